// What the second eye of a headset costs over the first.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "app/headset/workshop_scene.hpp"
#include "core/base/resources.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr int kEyeWidth = 672; ///< what Monado recommends for its scripted headset
constexpr int kEyeHeight = 756;
constexpr int kSamples = 4;
constexpr float kBetweenEyes = 0.063f;
constexpr float kWorldUnit = 0.04f;
constexpr int kMeltingSteps = 60;

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
    for (int i = 0; i < kMeltingSteps; ++i)
        trainer.advance(trainer.demonstration(), nullptr);
    trainer.updateSurface(nullptr);
    Renderer renderer(bench.shaders());
    const HeadsetParameters parameters;
    WorkshopScene workshop;
    HandsInSight hands;
    hands.torch = true;
    hands.tip.position = {0.1f, 1.15f, 0.1f};
    hands.grip.position = {0.12f, 1.25f, 0.2f};
    SceneView scene = trainer.scene();
    scene.modelToWorld = WorkpiecePlace(parameters, -kWorldUnit).modelToWorkshop(kWorldUnit) * scene.modelToWorld;
    scene.solids = workshop.build(parameters, hands);
    const std::array<View, 2> eyes{eyeAt(-kBetweenEyes / 2), eyeAt(kBetweenEyes / 2)};
    const PictureTarget one(kEyeWidth, kEyeHeight, kSamples), two(2 * kEyeWidth, kEyeHeight, kSamples);
    const auto draw = [&](std::span<const View> views, const PictureTarget& target) {
        return [&, views](gl::Profiler& profiler) {
            renderer.draw(scene, trainer.lesson().look, views, target.target(), &profiler);
            target.resolve();
        };
    };
    BenchRow single = bench.measure("one eye", draw({eyes.data(), 1}, one), 2.0);
    BenchRow both = bench.measure("two eyes, two passes", draw(eyes, two), 2.0);
    both.further = {{"over_one_eye", both.stepMs / single.stepMs}};
    bench.add(std::move(single));
    bench.add(std::move(both));
}

} // namespace meltpool
