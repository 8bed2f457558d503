// The times at which metal froze belong to a checkpoint, and the surface has them where a picture may show them.
#include "shaders/shared/surface.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/attempt/checkpoint_bench.hpp"

#include <algorithm>
#include <vector>

using namespace meltpool;

namespace {

/// The latest time at which metal at the surface froze, s; 0 where none has.
float latestFreezing(Trainer& trainer) {
    trainer.updateSurface(nullptr);
    const gl::Buffer* freezing = trainer.scene().mesh.freezing;
    REQUIRE(freezing != nullptr);
    float latest = 0;
    for (const SurfaceFreezing& each : freezing->read<SurfaceFreezing>(trainer.surface().statistics().vertices))
        latest = std::max(latest, each.time);
    return latest;
}

/// Steps with the arc on, then without.
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
    CHECK(latestFreezing(trainer) == 0);
    weldAndCool(trainer, 40, 85);
    const float before = latestFreezing(trainer);
    CHECK(before > 40 * float(trainer.timeStep()));
    CHECK(double(before) <= trainer.time() + 0.01);
    const Checkpoint checkpoint = trainer.save();
    weldAndCool(trainer, 40, 200);
    const float after = latestFreezing(trainer);
    CHECK(after > before);
    trainer.restore(checkpoint);
    CHECK(latestFreezing(trainer) ==
          Approx(before).margin(0.01)); // corners weigh times within what counts as no change
    Trainer fresh(test::shaders(), test::checkpointLesson("gmaw"));
    fresh.restore(checkpoint);
    CHECK(latestFreezing(fresh) == Approx(before).margin(0.01));
}

TEST_CASE("in low detail the surface has no freezing times", "[training]") {
    Lesson lesson = test::checkpointLesson("gmaw");
    lesson.look.detail = kLowDetail;
    Trainer trainer(test::shaders(), lesson);
    trainer.updateSurface(nullptr);
    CHECK(trainer.scene().mesh.freezing == nullptr);
    const size_t low = trainer.surface().bytes();
    trainer.lesson().look.detail = kMediumDetail;
    trainer.updateSurface(nullptr);
    CHECK(trainer.scene().mesh.freezing != nullptr);
    CHECK(trainer.surface().bytes() > low);
}
