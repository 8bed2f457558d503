// Tests the metal's time against the hand's time at different frame rates and on machines of different speed.
#include "app/activities/step_clock.hpp"
#include "core/training/attempt/checkpoint_schedule.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

constexpr double kStep = 0.01; // s of the metal

/// Runs frames of a machine that needs `cost` s for a step and `picture` s for the rest, on a display that waits until
/// `shortest` s have passed. Returns simulated over real time of the last of ten seconds.
double paceOf(double cost, double picture, double shortest) {
    StepClock clock;
    double elapsed = shortest, real = 0, simulated = 0;
    while (real < 10) {
        const int due = clock.due(elapsed, kStep);
        clock.took(due * cost, due);
        elapsed = std::max(shortest, due * cost + picture);
        real += elapsed;
        simulated += due * kStep;
    }
    INFO("speed " << clock.speed() << ", real " << real << ", simulated " << simulated);
    CHECK(clock.speed() == Approx(simulated / real).margin(0.12));
    return simulated / real;
}

} // namespace

TEST_CASE("steps follow the clock at any frame rate that leaves time for them") {
    for (const double rate : {10.0, 12.0, 30.0, 45.0, 60.0, 90.0, 144.0, 500.0}) {
        INFO(rate << " frames a second");
        CHECK(paceOf(0.001, 0.001, 1 / rate) == Approx(1).margin(0.03));
    }
}

TEST_CASE("a machine that is just fast enough keeps up, though its frames become few") {
    CHECK(paceOf(0.006, 0.02, 1.0 / 60) == Approx(1).margin(0.03));
}

TEST_CASE("a machine that is too slow is slow by as much as its steps are, and its frames stay short") {
    StepClock clock;
    clock.due(0, kStep);
    clock.took(0.02, 1);
    for (int i = 0; i < 100; ++i)
        CHECK(clock.due(0.5, kStep) == 4); // 80 ms of steps
    CHECK(clock.speed() == Approx(4 * kStep / 0.5).epsilon(0.05));
    CHECK(clock.due(0, kStep) <= 1); // no debt remains
    CHECK(clock.due(0, kStep) == 0);
    CHECK(paceOf(0.02, 0.02, 1.0 / 60) == Approx(0.4).margin(0.02));
    CHECK(paceOf(0.2, 0.02, 1.0 / 60) == Approx(kStep / 0.22).margin(0.01)); // at least a step a frame
}

TEST_CASE("steps beside a picture fill its time or a frame of twenty a second, and the metal is as fast as they are") {
    struct Machine {
        double cost, picture; // s of a step, and of a frame apart from steps
        double longest;       // longest of its frames, s
    };
    for (const auto& [cost, picture, longest] :
         {Machine{0.011, 0.03, 0.056}, Machine{0.011, 0.06, 0.067}, Machine{0.02, 0.03, 0.061},
          Machine{0.02, 0.2, 0.201}, Machine{0.005, 0.03, 0.031}}) {
        INFO(cost << " s a step, " << picture << " s a picture");
        StepClock clock;
        double elapsed = 0.1, real = 0, simulated = 0, busy = 0;
        for (int frame = 0; frame < 400; ++frame) {
            const int due = clock.due(elapsed, kStep, picture);
            clock.took(due * cost, due);
            elapsed = std::max(due * cost, picture) + 0.0005;
            if (frame < 100) continue;
            CHECK(elapsed <= longest);
            CHECK(clock.busyBeside() <= StepClock::kBeside + cost);
            real += elapsed;
            simulated += due * kStep;
            busy += due * cost;
        }
        // The steps rest during a picture longer than kBusy: a longer frame would lose the hand.
        const double leastBusy = picture > StepClock::kBusy ? 0.35 : 0.96;
        if (cost < kStep)
            CHECK(simulated / real == Approx(1).margin(0.02));
        else
            CHECK(busy / real > leastBusy);
    }
}

TEST_CASE("when an arc makes steps dearer and dearer no frame takes so long that the hand is lost") {
    // Costs measured in the tee on two cores: cold steps cost 1 ms, and within some frames of the strike 6 ms, still
    // growing.
    StepClock clock;
    double elapsed = 0.1, cost = 0.001;
    for (int frame = 0; frame < 60; ++frame) {
        const int due = clock.due(elapsed, kStep);
        CHECK_FALSE(clock.dropped());
        clock.took(due * cost, due);
        elapsed = due * cost + 0.1;
        if (frame >= 20) cost = std::min(cost + 0.0035, 0.03);
    }
    CHECK(clock.busy() <= StepClock::kBusy);
}

TEST_CASE("a frame that took longer than can be made good has dropped what the hand did, one after a pause has not") {
    StepClock clock;
    clock.due(5, kStep);
    CHECK_FALSE(clock.dropped());
    clock.due(0.24, kStep);
    CHECK_FALSE(clock.dropped());
    clock.due(0.26, kStep);
    CHECK(clock.dropped());
    clock.due(0.02, kStep);
    CHECK_FALSE(clock.dropped());
    clock.restart();
    clock.due(9, kStep);
    CHECK_FALSE(clock.dropped());
    clock.took(0.08, 1); // slow metal: one step a frame
    for (int i = 0; i < 20; ++i)
        clock.due(0.5, kStep);
    CHECK_FALSE(clock.dropped());
}

TEST_CASE("the speed of steps alone is that of the time they took") {
    StepClock clock;
    CHECK(clock.speedOfSteps(kStep) > 1e6);
    clock.took(0.08, 2);
    CHECK(clock.speedOfSteps(kStep) == Approx(kStep / 0.04));
    for (int i = 0; i < 40; ++i)
        clock.took(0.02, 1);
    CHECK(clock.speedOfSteps(kStep) == Approx(kStep / 0.02).epsilon(0.01));
    clock.reset();
    CHECK(clock.speedOfSteps(kStep) > 1e6);
}

TEST_CASE("moments lie as far apart as the machine welds in a second") {
    CHECK(CheckpointSchedule::period(StepClock().speedOfSteps(kStep)) == 1);
    CHECK(CheckpointSchedule::period(3) == 1);
    CHECK(CheckpointSchedule::period(0.7) == 0.7);
    CHECK(CheckpointSchedule::period(0.1) == 0.4);
}

TEST_CASE("after a pause no time is made good, and one long frame is") {
    StepClock clock;
    clock.due(5, kStep);
    CHECK(clock.due(0.02, kStep) == 2);
    CHECK(clock.due(0.2, kStep) == 20);
    clock.restart();
    CHECK(clock.due(9, kStep) == 0);
    CHECK(clock.due(0.01, kStep) == 1);
    CHECK(clock.speed() == Approx(1).margin(0.01));
}

} // namespace meltpool
