// Single short circuits from the arc's rate.
#include "core/training/feedback/sound/short_circuits.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace meltpool;

namespace {

ArcState shortingArc(float rate) {
    ArcState arc;
    arc.action = ArcAction::shorting;
    arc.shorts = rate;
    arc.voltage = 18;
    arc.current = 130;
    return arc;
}

} // namespace

TEST_CASE("as many short circuits come as the rate says, each within its step, with the step of power", "[sound]") {
    for (const float rate : {20.0F, 84.0F, 168.0F})
        for (const double seconds : {1.0 / 90, 1.0 / 400, 0.04}) {
            ShortCircuits shorts;
            size_t listed = 0;
            double phase = 0;
            const int steps = static_cast<int>(10 / seconds);
            for (int i = 0; i < steps; ++i) {
                shorts.step(shortingArc(rate), seconds);
                double before = 0;
                for (const ShortCircuit& each : shorts.last()) {
                    const auto at = static_cast<double>(each.at);
                    CHECK(at >= before);
                    CHECK(at <= seconds * 1.0001);
                    CHECK(each.power == 18.0F * 130.0F);
                    before = at;
                }
                listed += shorts.last().size();
                CHECK(shorts.phase() >= phase);
                phase = shorts.phase();
            }
            INFO(rate << " a second in steps of " << seconds << " s");
            CHECK(listed == shorts.count());
            // The scatter has zero mean: ten seconds leave a small rest.
            CHECK(std::abs(static_cast<double>(listed) - 10 * static_cast<double>(rate)) < 12);
        }
}

TEST_CASE("a wire that does not ignite again has no short circuits, and the same arc has the same ones", "[sound]") {
    ShortCircuits shorts;
    for (const ArcAction action : {ArcAction::out, ArcAction::striking, ArcAction::stubbed}) {
        ArcState arc = shortingArc(120);
        arc.action = action;
        shorts.step(arc, 0.1);
        CHECK(shorts.last().empty());
        CHECK(shorts.count() == 0);
    }
    ShortCircuits again;
    for (int i = 0; i < 200; ++i) {
        shorts.step(shortingArc(90), 1.0 / 90);
        again.step(shortingArc(90), 1.0 / 90);
        REQUIRE(shorts.last().size() == again.last().size());
        for (size_t k = 0; k < again.last().size(); ++k)
            CHECK(shorts.last()[k].at == again.last()[k].at);
    }
    const ShortCircuits copy = again; // copy as in a checkpoint
    again.step(shortingArc(90), 0.05);
    ShortCircuits restored = copy;
    restored.step(shortingArc(90), 0.05);
    CHECK(restored.phase() == again.phase());
}

TEST_CASE("short circuits do not come evenly, but never together", "[sound]") {
    ShortCircuits shorts;
    double time = 0, last = -1, least = 1, most = 0;
    for (int i = 0; i < 1000; ++i, time += 1.0 / 90) {
        shorts.step(shortingArc(120), 1.0 / 90);
        for (const ShortCircuit& each : shorts.last()) {
            const double at = time + static_cast<double>(each.at);
            if (last >= 0) {
                least = std::min(least, at - last);
                most = std::max(most, at - last);
            }
            last = at;
        }
    }
    CHECK(least > (1 - ShortCircuits::kUnevenness - 0.01) / 120);
    CHECK(least < 0.8 / 120);
    CHECK(most > 1.2 / 120);
    CHECK(most < (1 + ShortCircuits::kUnevenness + 0.01) / 120);
}

TEST_CASE("a machine that controls its short circuits makes them evenly, and opens them with little power", "[sound]") {
    ShortCircuits shorts;
    double time = 0, last = -1;
    for (int i = 0; i < 200; ++i, time += 1.0 / 90) {
        shorts.step(shortingArc(70), 1.0 / 90, true);
        for (const ShortCircuit& each : shorts.last()) {
            CHECK(static_cast<double>(each.power) == Approx(18 * kControlledBreakCurrent));
            const double at = time + static_cast<double>(each.at);
            if (last >= 0) CHECK(at - last == Approx(1.0 / 70).epsilon(1e-4));
            last = at;
        }
    }
    CHECK(shorts.count() > 150);
}
