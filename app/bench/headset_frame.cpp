// What a frame of the headset costs the processor beside the driver, and whether it asks the heap or waits for the GPU.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "app/headset/headset_station.hpp"
#include "app/meter/frame_meter.hpp"
#include "app/meter/gl_watch.hpp"
#include "core/base/function_ref.hpp"
#include "core/render/picture_target.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <thread>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPatience = 6;   ///< s, for a runtime to appear
constexpr double kWarmUp = 1.0;   ///< s: the first second may fill what is kept
constexpr double kMeasured = 5.0; ///< s
constexpr unsigned kLeastFrames = 20;
constexpr double kFrame = 1.0 / 60;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A lesson under its own demonstration, and both eyes of it.
struct Scene {
    explicit Scene(gl::ShaderLibrary& shaders) : session(shaders, lesson()) { session.begin(controls); }

    static Lesson lesson() {
        Lesson made = loadLesson(std::string(kDefaultLesson));
        made.set("particles", "8192", "bench");
        return made;
    }
    void advance(gl::Profiler& profiler) {
        time += kFrame;
        const auto held = [this](int, int) { return session.lesson().torch.sample(time); };
        session.advance(controls, kFrame, &profiler, held);
        session.fillFigures(figures);
    }

    Session session;
    Controls controls;
    ui::Figures figures;
    double time = 0;
};

/// Runs frames until both are reached: kMeasured seconds after warming up, and kLeastFrames.
BenchRow measureFrames(std::string what, FunctionRef<void(gl::Profiler&)> frame) {
    gl::Profiler profiler;
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
        profiler.beginFrame();
        frame(profiler);
        profiler.endFrame();
        meter.end();
        ++run;
        for (size_t place = 0; place < kWorkPlaces; ++place)
            sum[place] += meter.lastMs(static_cast<WorkPlace>(place));
    }
    const auto mean = [&](WorkPlace place) { return sum[static_cast<size_t>(place)] / run; };
    BenchRow row;
    row.suite = "stereo";
    row.what = std::move(what);
    row.stepMs = meter.leastOwnMs();
    row.further = {{"own_cpu_ms_median", meter.medianOwnMs()},
                   {"driver_ms_mean", mean(WorkPlace::driver)},
                   {"runtime_ms_mean", mean(WorkPlace::runtime)},
                   {"waiting_ms_mean", mean(WorkPlace::waiting)},
                   {"frames", run},
                   {"frames_that_allocated", meter.totals().framesThatAllocated},
                   {"allocations", static_cast<double>(meter.totals().allocations)},
                   {"stalls", meter.totals().stalls}};
    return row;
}

BenchRow measureWithoutRuntime(Scene& scene) {
    constexpr int kWidth = 672, kHeight = 756, kSamples = 4;
    const PictureTarget target(2 * kWidth, kHeight, kSamples);
    const Lens lens;
    const std::array<View, 2> eyes{makeView({-0.8f, 1.4f, 2.4f}, glm::angleAxis(-0.5f, glm::vec3(1, 0, 0)), lens, 0.9f),
                                   makeView({0.8f, 1.4f, 2.4f}, glm::angleAxis(-0.5f, glm::vec3(1, 0, 0)), lens, 0.9f)};
    return measureFrames("own work, no runtime", [&](gl::Profiler& profiler) {
        scene.advance(profiler);
        const SceneView shown = scene.session.scene(&profiler);
        scene.session.renderer().draw(shown, scene.session.lesson().look, eyes, target.target(), &profiler);
        target.resolve();
    });
}

/// A frame in which the headset is there was begun.
bool waitForHeadset(HeadsetStation& station, const Scene& scene) {
    const Clock::time_point start = Clock::now();
    while (secondsSince(start) < kPatience) {
        if (station.begin(scene.session, kFrame)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

} // namespace

void benchHeadsetFrame(Bench& bench) {
    if (!watchGl()) return; // what the driver takes cannot be told apart here
    Scene scene(bench.shaders());
    bench.add(measureWithoutRuntime(scene));
    HeadsetStation station({});
    if (!waitForHeadset(station, scene)) {
        std::printf("%-10s no headset, so no frame with a runtime: %s\n", "stereo", station.desk().status().c_str());
        return;
    }
    bool first = true; // it was begun while waiting
    bench.add(measureFrames("own work, headset", [&](gl::Profiler& profiler) {
        if (!first && !station.begin(scene.session, kFrame)) return;
        first = false;
        scene.advance(profiler);
        station.draw(scene.session, scene.figures, kFrame, &profiler);
        station.end();
    }));
}

} // namespace meltpool
