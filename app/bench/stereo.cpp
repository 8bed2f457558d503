// The cost of a headset's second eye over the first.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "app/headset/workshop_scene.hpp"
#include "core/base/resources.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>

namespace meltpool {

namespace {

constexpr int kEyeWidth = 672; ///< width that Monado recommends for its scripted headset
constexpr int kEyeHeight = 756;
constexpr int kSamples = 4;
constexpr float kBetweenEyes = 0.063f;
constexpr float kWorldUnit = 0.04f;
constexpr int kMeltingSteps = 60;
constexpr int kRounds = 6;
/// Time of all the program's threads: with a driver that draws on the processor this is the work, independent of other
/// load; with a graphics card, the cost of preparing the frame.
constexpr const char* kCpuMs = "cpu_ms";

View eyeAt(float x) {
    const glm::quat down = glm::angleAxis(-0.8f, glm::vec3(1, 0, 0));
    const Lens lens{1.5f, 0.02f, 50.0f};
    return makeView({x, 1.55f, 0.42f}, down, lens, static_cast<float>(kEyeWidth) / kEyeHeight);
}

} // namespace

void benchStereo(Bench& bench) {
    Lesson lesson = findLesson(std::string(kDefaultLesson), resourceFolder() / "data" / "lessons");
    lesson.set("particles", "8192", "bench");
    Trainer trainer(bench.shaders(), lesson);
    LessonScene shown(bench.shaders(), trainer);
    for (int i = 0; i < kMeltingSteps; ++i)
        trainer.advance(trainer.demonstration(), nullptr);
    shown.updateSurface(nullptr);
    Renderer renderer(bench.shaders());
    const HeadsetParameters parameters;
    WorkshopScene workshop;
    HandsView hands;
    hands.torch = true;
    hands.tip.position = {0.1f, 1.15f, 0.1f};
    hands.holder.hold.position = {0.12f, 1.25f, 0.2f};
    SceneView scene = shown.view();
    scene.modelToWorld =
        WorkpiecePlace(parameters.tableHeight, parameters.zoom, -kWorldUnit).modelToWorkshop(kWorldUnit) *
        scene.modelToWorld;
    scene.solids = workshop.build(parameters, hands);
    const std::array<View, 2> eyes{eyeAt(-kBetweenEyes / 2), eyeAt(kBetweenEyes / 2)};
    const PictureTarget one(kEyeWidth, kEyeHeight, kSamples), two(2 * kEyeWidth, kEyeHeight, kSamples);
    const auto draw = [&](std::string what, std::span<const View> views, const PictureTarget& target) {
        double cpuMs = std::numeric_limits<double>::infinity();
        const auto work = [&](gl::Profiler& profiler) {
            const std::clock_t start = std::clock();
            renderer.draw(scene, trainer.lesson().look, views, target.target(), &profiler);
            target.resolve();
            glFinish();
            cpuMs = std::min(cpuMs, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        };
        BenchRow row = bench.measure(std::move(what), work, 0.5, 3);
        row.further = {{kCpuMs, cpuMs}};
        return row;
    };
    // All take turns, so that other load on the machine falls on all of them alike.
    BenchRow single;
    std::array<BenchRow, kViewSubmissions.size()> pairs;
    for (int round = 0; round < kRounds; ++round) {
        keepLeast(single, draw("one eye", {eyes.data(), 1}, one));
        for (size_t i = 0; i < pairs.size(); ++i)
            if (renderer.submitBy(kViewSubmissions[i]).submission == kViewSubmissions[i])
                keepLeast(pairs[i], draw("two eyes, " + std::string(submissionName(kViewSubmissions[i])), eyes, two));
    }
    const double oneEyeMs = single.stepMs, oneEyeCpuMs = single.further.front().second;
    bench.add(std::move(single));
    for (BenchRow& pair : pairs) {
        if (pair.what.empty()) continue; // this driver does not support it
        pair.further.emplace_back("cpu_over_one_eye", pair.further.front().second / oneEyeCpuMs);
        pair.further.emplace_back("over_one_eye", pair.stepMs / oneEyeMs);
        bench.add(std::move(pair));
    }
}

} // namespace meltpool
