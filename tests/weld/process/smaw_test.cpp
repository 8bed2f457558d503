// SMAW: strike by touch, burn-off, sticking and its release by a twist, an extinguished arc, the stub.
#include "core/weld/process/processes.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <limits>
#include <numbers>

using namespace meltpool;

namespace {

constexpr double kStep = 1.0 / 100;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

const HeatTable& table() {
    static const HeatTable made(
        readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml"));
    return made;
}

/// An electrode whose distance from the metal is set directly.
struct Stick {
    Stick() {
        settings.choose<Smaw>().current = 115;
        process = makeProcess(settings, {table(), 7850, 1e-3F, 293.15});
        torch.orientation = glm::angleAxis(-std::numbers::pi_v<float> / 2, glm::vec3(1, 0, 0));
        torch.trigger = 1;
    }
    /// Makes one step with the electrode's end `mm` from the metal.
    const ArcState& at(double mm) {
        process->step(torch, {static_cast<float>(0.01 + mm * 1e-3), 1}, kStep);
        return process->arc();
    }
    const ArcState& forSeconds(double seconds, double mm) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i)
            at(mm);
        return process->arc();
    }
    void twist(double degrees) {
        torch.orientation =
            torch.orientation * glm::angleAxis(float(degrees * std::numbers::pi / 180), glm::vec3(0, 0, 1));
    }
    void strike() {
        forSeconds(0.1, 0);
        REQUIRE(at(1).burns());
    }

    ProcessSettings settings;
    std::unique_ptr<Process> process;
    TorchSample torch;
};

} // namespace

TEST_CASE("a stick strikes when it has touched and is lifted, not from afar", "[weld]") {
    Stick stick;
    CHECK(stick.forSeconds(0.1, 2).noArc == NoArc::tooFar);
    CHECK(stick.at(kNowhere).noArc == NoArc::noMetal);
    CHECK(stick.forSeconds(0.1, 0).noArc == NoArc::touching);
    CHECK(stick.at(1).action == ArcAction::striking);
    CHECK(stick.at(2).action == ArcAction::burning);
    stick.torch.trigger = 0;
    CHECK(stick.at(2).noArc == NoArc::released);
    stick.torch.trigger = 1;
    CHECK(stick.at(2).noArc == NoArc::tooFar); // a new touch is required
    stick.at(0);
    CHECK(stick.at(8).noArc == NoArc::tooFar); // lifted too fast for the arc
    CHECK(stick.at(2).noArc == NoArc::tooFar);
    stick.strike();
}

TEST_CASE("a stick that touches for 0.3 s sticks until it is twisted or torn off", "[weld]") {
    Stick stick;
    stick.strike();
    CHECK(stick.forSeconds(0.2, 0).action == ArcAction::shorting);
    CHECK(stick.at(2).action == ArcAction::burning); // lifted in time
    CHECK(stick.forSeconds(0.35, 0).noArc == NoArc::stuck);
    CHECK(wentOut(NoArc::stuck));
    CHECK(stick.process->sources().empty());
    CHECK(stick.forSeconds(0.5, 3).noArc == NoArc::stuck); // the rod gives way
    stick.twist(5);
    CHECK(stick.at(3).noArc == NoArc::stuck);
    stick.twist(10);
    CHECK(stick.at(3).noArc == NoArc::tooFar);
    stick.strike();
    CHECK(stick.forSeconds(0.35, -1).noArc == NoArc::stuck); // pressed into the pool
    CHECK(stick.at(14).noArc == NoArc::stuck);
    CHECK(stick.at(16).noArc == NoArc::tooFar); // torn off
    CHECK(stick.at(2).noArc == NoArc::tooFar);  // and has to touch again
    stick.strike();
    CHECK(stick.forSeconds(0.35, -1).noArc == NoArc::stuck);
    CHECK(stick.at(kNowhere).noArc == NoArc::noMetal); // torn off over the edge
    CHECK(stick.at(5).noArc == NoArc::tooFar);
    stick.strike();
    CHECK(stick.forSeconds(0.35, -1).noArc == NoArc::stuck);
    stick.torch.trigger = 0; // the holder releases the electrode
    CHECK(stick.at(3).noArc == NoArc::released);
    stick.torch.trigger = 1;
    stick.strike();
}

TEST_CASE("a stick's arc breaks as it grows, goes out when it is too long, and says so", "[weld]") {
    Stick stick;
    stick.strike();
    const double longest = smawLongestArc(0, 115) * 1e3;
    CHECK(longest > 6); // an arc of 3.2 mm holds, one over a centimetre does not
    CHECK(longest < 12);
    CHECK(stick.at(3).stretch < 0.1F);
    CHECK(double(stick.at(3).voltage) == Approx(smawVoltage(0, 3e-3, 115)));
    CHECK(stick.at(longest - 0.5).action == ArcAction::breaking);
    CHECK(stick.at(longest + 0.5).noArc == NoArc::tooLong);
    CHECK(stick.at(2).noArc == NoArc::tooLong); // reported until the next strike
    stick.strike();
    CHECK(stick.at(kNowhere).noArc == NoArc::metalLeft);
}

TEST_CASE("a 3.2 mm electrode of 350 mm burns to its stub in 65 to 75 s at 115 A, and a new one is taken", "[weld]") {
    Stick stick;
    stick.strike();
    double seconds = 0;
    while (stick.at(3).burns() && seconds < 200)
        seconds += kStep;
    CHECK(seconds > 62);
    CHECK(seconds < 76);
    CHECK(stick.process->arc().noArc == NoArc::usedUp);
    CHECK(stick.process->burntOff() == Approx(0.3).margin(1e-3));
    CHECK(stick.process->arc().extension == Approx(kSmawStub).margin(1e-3));
    stick.torch.trigger = 0;
    stick.at(3);
    CHECK(stick.process->burntOff() == 0);
    stick.torch.trigger = 1;
    stick.strike();
}

TEST_CASE("the rays of a burning electrode begin at what is left of it", "[weld]") {
    Stick stick;
    const glm::vec3 before = stick.process->ray(stick.torch).origin;
    stick.strike();
    stick.forSeconds(10, 3);
    const glm::vec3 after = stick.process->ray(stick.torch).origin;
    const float burnt = stick.process->burntOff();
    CHECK(burnt > 0.03F);
    CHECK(after.y - before.y == Approx(burnt).margin(1e-6)); // up and out of the metal
}

TEST_CASE("a stick's arc and its drops together bring efficiency U I, and its core is found again but for spatter",
          "[weld]") {
    Stick stick;
    stick.strike();
    stick.process->reset();
    double brought = 0, expected = 0;
    size_t drops = 0;
    stick.at(0);
    for (int i = 0; i < 1000; ++i) {
        const ArcState arc = stick.at(3);
        for (const HeatSource& source : stick.process->sources())
            brought += double(source.power) * kStep;
        for (const MetalSeed& drop : stick.process->drops())
            brought += 7850e-9 * (table().enthalpyAt(double(drop.temperature)) - table().enthalpyAt(293.15));
        drops += stick.process->drops().size();
        expected += kSmawEfficiency * double(arc.voltage) * double(arc.current) * kStep;
    }
    CHECK(brought == Approx(expected).epsilon(0.003));
    const WireAccount wire = stick.process->wire();
    CHECK(double(drops) == Approx(kSmawDeposit * wire.melted * wire.area / 1e-9).margin(1));
}
