// The cost of a headset's frame on the processor. With the tests' call counters loaded the driver's share is separate,
// and rows count heap allocations and waits for the GPU per frame.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "app/headset/headset_front_end.hpp"
#include "app/platform/call_counters.hpp"
#include "app/platform/frame_meter.hpp"
#include "core/base/function_ref.hpp"
#include "core/base/resources.hpp"
#include "core/render/picture_target.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <thread>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPatience = 6;   ///< s, for a runtime to appear
constexpr double kWarmUp = 1.0;   ///< s: the first second may fill caches
constexpr double kMeasured = 5.0; ///< s
constexpr unsigned kLeastFrames = 60;
constexpr double kFrame = 1.0 / 60; ///< s
/// Lateness of a frame that makes as many catch-up steps as any frame does, s.
constexpr double kLate = 0.1;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Lesson under its own demonstration, two steps per frame, and both eyes of it.
struct Scene {
    Scene(gl::ShaderLibrary& shaders, Lesson lesson) : session(shaders, std::move(lesson)) { session.begin(controls); }

    void advance() {
        time += kFrame;
        const auto held = [this](int, int) { return session.lesson().torch.sample(time); };
        session.advance(controls, kLate, nullptr, held);
        fillFigures(figures, session);
    }

    LessonSession session;
    Controls controls;
    LessonFigures figures;
    Home home{resourceFolder() / "data" / "lessons", {}}; // closed, and without scores
    double time = 0;
};

Lesson smallClassic() {
    Lesson lesson = loadLesson(std::string(kDefaultLesson));
    lesson.set("particles", "8192", "bench");
    return lesson;
}

/// Runs frames until both are reached: kMeasured seconds after warming up, and kLeastFrames. Returns one row for each
/// part of the processor's time; none if a frame reports that there is nothing left to measure.
std::vector<BenchRow> measureFrames(const std::string& what, bool counted, FunctionRef<bool()> frame) {
    FrameMeter meter;
    std::array<double, kWorkPlaces> sum{};
    bool warm = false;
    unsigned run = 0;
    Clock::time_point start = Clock::now();
    while (!warm || secondsSince(start) < kMeasured || run < kLeastFrames) {
        if (!warm && secondsSince(start) > kWarmUp && run >= kLeastFrames) {
            warm = true;
            run = 0;
            sum = {};
            meter.restart();
            start = Clock::now();
        }
        meter.begin();
        if (!frame()) return {};
        meter.end();
        ++run;
        for (size_t place = 0; place < kWorkPlaces; ++place)
            sum[place] += meter.lastMs(static_cast<WorkPlace>(place));
    }
    const auto row = [&](const char* part, FrameWork work) {
        BenchRow made;
        made.suite = "stereo";
        made.what = what + part;
        made.stepMs = meter.leastMs(work);
        made.further = {{"cpu_ms_median", meter.medianMs(work)}};
        return made;
    };
    std::vector<BenchRow> rows{
        row(counted ? ", own work" : ", own work and OpenGL", FrameWork::own),
        row(", runtime's calls", FrameWork::runtime),
        row(counted ? ", outside GL and xrWaitFrame" : ", outside xrWaitFrame", FrameWork::outside)};
    const auto mean = [&](WorkPlace place) { return sum[static_cast<size_t>(place)] / run; };
    auto& further = rows[0].further;
    further.insert(further.end(), {{"runtime_ms_mean", mean(WorkPlace::runtime)},
                                   {"waiting_ms_mean", mean(WorkPlace::waiting)},
                                   {"frames", run}});
    if (counted)
        further.insert(further.end(), {{"driver_ms_mean", mean(WorkPlace::driver)},
                                       {"frames_that_allocated", meter.totals().framesThatAllocated},
                                       {"allocations", static_cast<double>(meter.totals().allocations)},
                                       {"stalls", meter.totals().stalls}});
    return rows;
}

BenchRow measureWithoutRuntime(Scene& scene, bool counted) {
    constexpr int kWidth = 672, kHeight = 756, kSamples = 4;
    const PictureTarget target(2 * kWidth, kHeight, kSamples);
    const Lens lens;
    const std::array<View, 2> eyes{makeView({-0.8f, 1.4f, 2.4f}, glm::angleAxis(-0.5f, glm::vec3(1, 0, 0)), lens, 0.9f),
                                   makeView({0.8f, 1.4f, 2.4f}, glm::angleAxis(-0.5f, glm::vec3(1, 0, 0)), lens, 0.9f)};
    return measureFrames("no headset", counted,
                         [&] {
                             scene.advance();
                             const SceneView shown = scene.session.picture().scene(nullptr);
                             scene.session.picture().renderer().draw(shown, scene.session.lesson().look, eyes,
                                                                     target.target(), nullptr);
                             target.resolve();
                             return true;
                         })
        .front();
}

/// Waits for the headset's first frame; true once it has begun.
bool waitForHeadset(HeadsetFrontEnd& headset, Scene& scene) {
    const Clock::time_point start = Clock::now();
    while (secondsSince(start) < kPatience) {
        if (headset.begin(scene.session, scene.home, kFrame)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

/// Adds rows of the frames that a headset shows; prints a reason and returns false if there is none, or none any more.
bool addHeadsetRows(Bench& bench, const std::string& what, bool counted, HeadsetFrontEnd& headset, Scene& scene) {
    const auto frame = [&] {
        if (!waitForHeadset(headset, scene)) return false;
        scene.advance();
        headset.draw(scene.session, scene.home, scene.figures, {}, kFrame, nullptr);
        headset.end();
        return true;
    };
    std::vector<BenchRow> rows = measureFrames(what, counted, frame);
    if (rows.empty())
        std::printf("%-10s no headset, so no frame of %s with a runtime: %s\n", "stereo", what.c_str(),
                    headset.sentence().c_str());
    for (BenchRow& row : rows)
        bench.add(std::move(row));
    return !rows.empty();
}

} // namespace

void benchHeadsetFrame(Bench& bench) {
    const bool counted = joinCallCounters();
    Scene classic(bench.shaders(), smallClassic());
    bench.add(measureWithoutRuntime(classic, counted));
    HeadsetFrontEnd headset({});
    if (!addHeadsetRows(bench, "classic", counted, headset, classic)) return;
    Scene weld(bench.shaders(), loadLesson("gmaw-bead"));
    addHeadsetRows(bench, "gmaw-bead", counted, headset, weld);
}

} // namespace meltpool
