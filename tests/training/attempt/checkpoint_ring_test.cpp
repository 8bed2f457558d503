// The checkpoints that an attempt can return to: they equal saved states, ten returns to one are possible, and memory
// respects its limit.
#include "core/training/attempt/checkpoint_ring.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/attempt/checkpoint_bench.hpp"

#include <chrono>
#include <map>
#include <thread>

using namespace meltpool;

namespace {

void begin(CheckpointRing& moments, const Trainer& trainer) {
    trainer.capture(moments.capture(), moments.historyTo());
    moments.begun(trainer.time(), trainer.technique() ? trainer.technique()->steps().size() : 0);
}

/// Waits until a pending checkpoint is stored.
void settle(CheckpointRing& moments, size_t count) {
    for (int i = 0; i < 6000 && moments.count() < count; ++i) {
        moments.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    REQUIRE(moments.count() == count);
    REQUIRE(moments.fault().empty());
}

/// Welds on with a checkpoint every ten steps; returns the saved states of these steps.
std::map<size_t, Checkpoint> weld(CheckpointRing& moments, Trainer& trainer, size_t step) {
    std::map<size_t, Checkpoint> saved;
    while (trainer.steps() < step) {
        test::runTo(trainer, "gmaw", trainer.steps() + 10);
        saved[trainer.steps()] = trainer.save();
        const size_t count = moments.count();
        REQUIRE(moments.due(trainer.time()));
        begin(moments, trainer);
        CHECK_FALSE(moments.due(trainer.time()));
        settle(moments, count + 1);
    }
    return saved;
}

CheckpointRingLimits often(size_t bytes = size_t(1) << 30) {
    return {0.05, bytes};
}

} // namespace

TEST_CASE("kept moments are the states that were saved at the same time", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    CheckpointRing moments(often());
    CHECK_FALSE(moments.before(100));
    const double step = trainer.timeStep();
    const auto saved = weld(moments, trainer, 50);
    REQUIRE(saved.size() == 5);
    for (const auto& [steps, checkpoint] : saved) {
        const auto kept = moments.before((static_cast<double>(steps) + 4.5) * step);
        REQUIRE(kept);
        CHECK(kept->step == steps);
        CHECK(kept->hash == checkpoint.hash);
    }
    CHECK_FALSE(moments.before(5 * step));
    moments.clear();
    CHECK_FALSE(moments.before(100));
    CHECK(moments.due(0));
}

TEST_CASE("an attempt goes back to the same moment ten times, and its memory stays flat", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    CheckpointRing moments(often());
    weld(moments, trainer, 30);
    const double there = trainer.time() + 1e-6;
    const auto hash = trainer.result().stateHash;
    weld(moments, trainer, 60);
    size_t kept = 0;
    for (int i = 0; i < 10; ++i) {
        const auto moment = moments.before(there);
        REQUIRE(moment);
        trainer.restore(*moment);
        moments.branch(moment->step);
        CHECK(moments.count() == 3);
        CHECK(trainer.steps() == 30);
        CHECK(trainer.result().stateHash == hash);
        weld(moments, trainer, 60);
        if (i == 1) kept = moments.bytes();
    }
    CHECK(moments.bytes() < kept + kept / 10);
}

TEST_CASE("where memory reaches its limit, old moments become fewer and the first and the newest stay", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    size_t enough = 0;
    {
        CheckpointRing moments(often());
        weld(moments, trainer, 20);
        enough = moments.bytes();
    }
    trainer.reset();
    CheckpointRing moments(often(enough));
    std::map<size_t, Checkpoint> saved;
    const double step = trainer.timeStep();
    for (size_t steps = 10; steps <= 160; steps += 10) {
        test::runTo(trainer, "gmaw", steps);
        saved[steps] = trainer.save();
        begin(moments, trainer);
        const auto wanted = static_cast<double>(steps) * step + 1e-6;
        for (int i = 0; i < 6000; ++i) { // waits until the new checkpoint is the newest
            moments.update();
            const auto newest = moments.before(wanted);
            if (newest && newest->step == steps) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    CHECK(moments.count() < 12);
    CHECK(moments.before(10.5 * step)->step == 10);
    CHECK(moments.before(1000)->step == 160);
    for (const auto& [steps, checkpoint] : saved) { // every stored checkpoint is whole
        const auto kept = moments.before((static_cast<double>(steps) + 0.5) * step);
        REQUIRE(kept);
        CHECK(kept->hash == saved.at(kept->step).hash);
    }
}

TEST_CASE("a moment that is under way when the attempt ends is given up", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("classic"));
    CheckpointRing moments(often());
    for (int i = 0; i < 5; ++i) {
        trainer.advance(test::checkpointTorch("classic", 1), nullptr);
        begin(moments, trainer);
        if (i % 2 == 0) moments.update();
        moments.clear();
        CHECK(moments.count() == 0);
    }
}
