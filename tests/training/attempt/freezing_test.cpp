// Freezing times of metal: checkpoints contain them, and the surface has them for pictures.
#include "core/training/trainer/lesson_scene.hpp"
#include "shaders/shared/surface.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/attempt/checkpoint_bench.hpp"

#include <algorithm>
#include <vector>

using namespace meltpool;

namespace {

/// Returns the latest freezing time at the surface, s; 0 if no metal has frozen.
float latestFreezing(LessonScene& scene) {
    scene.updateSurface(nullptr);
    const gl::Buffer* freezing = scene.surface().mesh().freezing;
    REQUIRE(freezing != nullptr);
    float latest = 0;
    for (const SurfaceFreezing& each : freezing->read<SurfaceFreezing>(scene.surface().statistics().vertices))
        latest = std::max(latest, each.time);
    return latest;
}

/// Makes steps with the arc on, then without.
void weldAndCool(Trainer& trainer, size_t welded, size_t end) {
    while (trainer.steps() < end) {
        TorchSample torch = test::checkpointTorch("gmaw", trainer.steps());
        if (trainer.steps() >= welded) torch.trigger = 0;
        trainer.advance(torch, nullptr);
    }
}

} // namespace

TEST_CASE("metal that froze before a checkpoint has its time again after it, in a new metal too", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    LessonScene scene(test::shaders(), trainer);
    CHECK(latestFreezing(scene) == 0);
    weldAndCool(trainer, 40, 85);
    const float before = latestFreezing(scene);
    CHECK(before > 40 * float(trainer.timeStep()));
    CHECK(double(before) <= trainer.time() + 0.01);
    const Checkpoint checkpoint = trainer.save();
    weldAndCool(trainer, 40, 200);
    const float after = latestFreezing(scene);
    CHECK(after > before);
    trainer.restore(checkpoint);
    CHECK(latestFreezing(scene) == Approx(before).margin(0.01)); // weights are updated within a tolerance
    Trainer fresh(test::shaders(), test::checkpointLesson("gmaw"));
    LessonScene freshScene(test::shaders(), fresh);
    fresh.restore(checkpoint);
    CHECK(latestFreezing(freshScene) == Approx(before).margin(0.01));
}

TEST_CASE("in low detail the surface has no freezing times", "[training]") {
    Lesson lesson = test::checkpointLesson("gmaw");
    lesson.look.detail = kLowDetail;
    Trainer trainer(test::shaders(), lesson);
    LessonScene scene(test::shaders(), trainer);
    scene.updateSurface(nullptr);
    CHECK(scene.view().mesh.freezing == nullptr);
    const size_t low = scene.surface().bytes();
    trainer.lesson().look.detail = kMediumDetail;
    scene.updateSurface(nullptr);
    CHECK(scene.view().mesh.freezing != nullptr);
    CHECK(scene.surface().bytes() > low);
}
