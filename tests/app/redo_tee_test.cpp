// Repeated return to one checkpoint of the shipped tee lesson: identical metal each of fourteen times, and no growth of
// memory.
#include "app/activities/redo.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/resident_bytes.hpp"

#include <chrono>
#include <thread>

using namespace meltpool;

namespace {

constexpr double kBegun = 4;       ///< s of simulated time to which the attempt returns
constexpr double kFault = -0.0105; ///< m along the seam, welded shortly before that time
constexpr int kTimes = 14;
constexpr int kWarmedUp = 8; ///< rounds after which all memory that later rounds reuse is allocated; seven suffice

/// Welds the demonstration and takes checkpoints as the session does.
void weldTo(Trainer& trainer, Redo& redo, double time) {
    for (int step = 1; trainer.time() < time; ++step) {
        trainer.advanceDemonstration(nullptr);
        redo.update(trainer, 1);
        if (step % 10 != 0) continue;
        (void)trainer.result(); // waits for the GPU, so that a checkpoint can arrive
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

} // namespace

TEST_CASE("fourteen ways back at the tee begin with the same metal and take no more memory", "[app][long]") {
    Trainer trainer(test::shaders(),
                    findLesson("tee-fillet", test::testFolder().parent_path() / "app" / "data" / "lessons"));
    Redo redo;
    redo.begin();
    weldTo(trainer, redo, kBegun);
    REQUIRE(redo.can());
    REQUIRE(trainer.result().metal.molten > 0);
    REQUIRE(firstTimeAt(*trainer.technique(), kFault));
    const std::uint64_t end = trainer.result().stateHash;
    std::uint64_t start = 0;
    size_t startSteps = 0, before = 0;
    for (int i = 0; i < kTimes; ++i) {
        INFO("number " << i + 1);
        redo.choose(kFault);
        const auto moment = redo.target(trainer);
        REQUIRE(moment);
        redo.back(trainer, *moment);
        CHECK(redo.redone() == static_cast<size_t>(i) + 1);
        const LessonResult now = trainer.result();
        if (i == 0) {
            start = now.stateHash;
            startSteps = now.steps;
            CHECK(now.seconds > 1); // the arc burns by now
            CHECK(start != end);
        }
        CHECK(now.stateHash == start);
        CHECK(now.steps == startSteps);
        weldTo(trainer, redo, kBegun);
        CHECK(trainer.result().stateHash == end);
        if (i + 1 == kWarmedUp) before = test::residentBytes();
    }
    const size_t after = test::residentBytes();
    INFO(before << " bytes, then " << after);
    CHECK(redo.fault() == "");
#ifndef __SANITIZE_ADDRESS__ // residentBytes() is meaningless there
    CHECK(before > 0);
    CHECK(static_cast<double>(after) < 1.01 * static_cast<double>(before));
#endif
}
