// A filler rod: melting in the pool, balls in the arc, contamination of the tungsten, and its balance of heat and
// metal.
#include "core/weld/process/filler_rod.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <numbers>

using namespace meltpool;

namespace {

constexpr double kStep = 1.0 / 109;
constexpr float kMm = 1e-3F;
constexpr double kRod = 2.4e-3; // rod diameter, m

const HeatTable& table() {
    static const HeatTable made(
        readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml"));
    return made;
}

ProcessMetal steel() {
    return {table(), 7850, 1e-3F, 293.15};
}

/// Returns a rod along -x at 20 degrees over the plate.
RodSample rodAt(glm::vec3 tipMm, float feedMmPerS = 0) {
    RodSample rod;
    rod.tip = tipMm * kMm;
    const float angle = 20 * std::numbers::pi_v<float> / 180;
    rod.orientation =
        glm::angleAxis(std::numbers::pi_v<float> / 2, glm::vec3(0, 1, 0)) * glm::angleAxis(-angle, glm::vec3(1, 0, 0));
    rod.feed = feedMmPerS * kMm;
    return rod;
}

/// Returns the arc of an upright electrode with its tip 2 mm over the plate at x = 0.
RodArc arcOf(double power = 1000) {
    return {{{0, 2 * kMm, 0}, {0, -1, 0}}, 2e-3, 1.3e-3, power};
}

/// Returns metal `mm` before the rod's end; negative: the end is inside the metal.
MetalAhead before(double mm, float liquid) {
    return {static_cast<float>(0.01 + mm * 1e-3), liquid};
}

} // namespace

TEST_CASE("a rod points the way that its test expects", "[weld]") {
    const glm::vec3 axis = rodAt({0, 0, 0}).axis();
    CHECK(axis.x == Approx(-std::cos(20 * std::numbers::pi / 180)));
    CHECK(axis.y == Approx(-std::sin(20 * std::numbers::pi / 180)));
}

TEST_CASE("a rod that is dipped into the pool melts back to its surface, as fast as the arc's heat allows", "[weld]") {
    FillerRod rod;
    rod.setDiameter(kRod);
    const RodSample held = rodAt({3, 0, 0});
    const RodArc arc = arcOf();
    const double perVolume = 7850 * (table().liquidusEnthalpy() - table().enthalpyAt(293.15));
    double volume = 0, heat = 0;
    for (int i = 0; i < 400; ++i) {
        const double depth = 1.5 - rod.eaten() * 1e3; // the surface is fixed
        const RodMelt melt = rod.step(held, before(-depth, 1), &arc, steel(), kStep);
        CHECK(melt.heat <= kRodPoolShare * arc.power * (1 + 1e-9));
        CHECK(melt.temperature == Approx(table().temperatureAt(table().liquidusEnthalpy())));
        volume += melt.volume;
        heat += melt.heat * kStep;
        if (i == 0) CHECK(melt.heat == Approx(kRodPoolShare * arc.power)); // more of it is in the pool than can melt
    }
    CHECK(rod.inPool());
    CHECK(rod.eaten() == Approx(1.5e-3).margin(1e-5));
    CHECK(volume == Approx(1.5e-3 * rod.area()).epsilon(0.01));
    CHECK(heat == Approx(volume * perVolume));
    CHECK(rod.melted() == Approx(rod.eaten()));
}

TEST_CASE("a rod melts neither on solid metal, nor beside the arc, nor without one", "[weld]") {
    FillerRod rod;
    rod.setDiameter(kRod);
    const RodArc arc = arcOf();
    CHECK(rod.step(rodAt({3, 0, 0}), before(-1, 0.1F), &arc, steel(), kStep).heat == 0); // solid metal
    CHECK(rod.step(rodAt({12, 3, 0}), before(8, 0), &arc, steel(), kStep).heat == 0);    // away from the arc
    CHECK(rod.step(rodAt({3, 0, 0}), before(-1, 1), nullptr, steel(), kStep).heat == 0); // no arc
    CHECK(rod.eaten() == 0);
    CHECK(rod.melted() == 0);
}

TEST_CASE("a rod in the arc above the pool grows a ball, which falls when it is too heavy and loses no metal",
          "[weld]") {
    FillerRod rod;
    rod.setDiameter(kRod);
    const RodArc arc = arcOf();
    double poured = 0, most = 0;
    int falls = 0;
    bool hung = false;
    for (int i = 0; i < 1000; ++i) {
        // The hand follows the end into the arc, 1 mm above the metal on its ray.
        const RodSample held = rodAt({float(rod.eaten() * 1e3 * -std::cos(0.349)) + 0.5F,
                                      float(rod.eaten() * 1e3 * -std::sin(0.349)) + 1.2F, 0});
        const RodMelt melt = rod.step(held, before(6, 0), &arc, steel(), kStep);
        poured += melt.volume;
        most = std::max(most, rod.ballDiameter());
        CHECK(melt.heat == Approx(kRodArcShare * arc.power));
        falls += hung && rod.ballDiameter() == 0 ? 1 : 0;
        hung = rod.ballDiameter() > 0;
    }
    CHECK(falls > 2);
    CHECK(most == Approx(kRodBall * kRod).epsilon(0.05));
    const double hanging = std::numbers::pi / 6 * std::pow(rod.ballDiameter(), 3);
    CHECK(rod.melted() * rod.area() == Approx(poured + hanging).margin(kRodBall * kRod * 1e-6));
}

TEST_CASE("a rod that is fed through the hand keeps its end where it is held", "[weld]") {
    FillerRod rod;
    rod.setDiameter(kRod);
    const RodArc arc = arcOf();
    for (int i = 0; i < 400; ++i)
        rod.step(rodAt({3, 0, 0}, 2), before(-1 + rod.eaten() * 1e3, 1), &arc, steel(), kStep);
    CHECK(rod.eaten() < 1.05e-3);
    CHECK(rod.melted() == Approx(400 * kStep * 2e-3).epsilon(0.2)); // the fed length melts
}

TEST_CASE("a GTAW torch melts its rod from its own heat, and a rod on the tungsten spoils it", "[weld]") {
    ProcessSettings settings;
    settings.choose<Gtaw>().current = 130;
    const auto process = makeProcess(settings, steel());
    TorchSample torch;
    torch.tip = {0, 2 * kMm, 0};
    torch.orientation = glm::angleAxis(-std::numbers::pi_v<float> / 2, glm::vec3(1, 0, 0));
    torch.trigger = 1;
    CHECK_FALSE(process->rodRay(torch));
    torch.rod = rodAt({3, 0, 0});
    REQUIRE(process->rodRay(torch));
    const MetalAhead plate{2 * kMm, 1};
    double brought = 0, expected = 0;
    size_t drops = 0;
    for (int i = 0; i < 300; ++i) {
        const double eaten = double(process->arc().rodEaten);
        process->step(torch, plate, kStep, before(-3 + eaten * 1e3, 1));
        for (const HeatSource& source : process->sources())
            brought += double(source.power) * kStep;
        for (const MetalSeed& drop : process->drops())
            brought += 7850e-9 * (table().enthalpyAt(double(drop.temperature)) - table().enthalpyAt(293.15));
        drops += process->drops().size();
        expected += process->arc().power * kStep;
    }
    CHECK(process->arc().rodInPool);
    CHECK(process->arc().rodEaten > 2.5e-3F);
    CHECK(drops > 10);
    CHECK(brought == Approx(expected).epsilon(0.003)); // within one pending particle
    const WireAccount account = process->wire();
    CHECK(double(drops) == Approx(account.melted * account.area / 1e-9).margin(1));

    // The remaining rod reaches the electrode.
    const float eaten = process->arc().rodEaten / kMm, angle = 20 * std::numbers::pi_v<float> / 180;
    torch.rod = rodAt({-eaten * std::cos(angle), 2.4F - eaten * std::sin(angle), 0});
    process->step(torch, plate, kStep, before(2, 1));
    CHECK(process->arc().noArc == NoArc::touched);
    CHECK(dynamic_cast<const Gtaw&>(*process).electrodeSpoiled());
    process->reset();
    CHECK(process->wire().area == 0);

    // In a lesson without a rod no rod melts or touches.
    settings.of<Gtaw>().rodDiameterMm = 0;
    CHECK_FALSE(holdsRod(settings));
    const auto bare = makeProcess(settings, steel());
    CHECK_FALSE(bare->rodRay(torch));
    for (int i = 0; i < 50; ++i)
        bare->step(torch, plate, kStep, before(-3, 1));
    CHECK(bare->arc().burns());
    CHECK(bare->arc().rodEaten == 0);
    CHECK(bare->drops().empty());
}

TEST_CASE("a flame and a soldering iron melt a rod or wire in the pool, from their own heat", "[weld]") {
    TorchSample torch;
    torch.orientation = glm::angleAxis(-std::numbers::pi_v<float> / 2, glm::vec3(1, 0, 0));
    torch.trigger = 1;
    torch.rod = rodAt({3, 0, 0}, 4);
    for (const bool flame : {false, true}) {
        INFO((flame ? "flame" : "iron"));
        ProcessSettings settings;
        if (flame)
            settings.choose<Flame>().rodDiameterMm = 1;
        else
            settings.choose<SolderingIron>() = {1600, 2, 1}; // hot enough for this metal
        torch.tip = {0, flame ? 10 * kMm : 0, 0};
        const MetalAhead plate{torch.tip.y, 1};
        const auto process = makeProcess(settings, steel());
        CHECK(process->takesRod());
        TorchSample alone = torch;
        alone.rod.reset();
        process->step(alone, plate, kStep);
        REQUIRE(process->sources().size() == 1);
        const double whole = double(process->sources()[0].power);
        double left = 0, brought = 0;
        const double begin = double(process->arc().rodEaten);
        for (int i = 0; i < 300; ++i) {
            const double eaten = double(process->arc().rodEaten);
            process->step(torch, plate, kStep, before(-3 + eaten * 1e3, 1));
            left += (whole - double(process->sources()[0].power)) * kStep;
            for (const MetalSeed& drop : process->drops())
                brought += 7850e-9 * (table().enthalpyAt(double(drop.temperature)) - table().enthalpyAt(293.15));
        }
        CHECK(process->arc().rodInPool);
        CHECK(double(process->arc().rodEaten) > begin + 2e-3);
        CHECK(left > 10);                                           // J
        CHECK(brought == Approx(left).margin(2 * 7850e-9 * 1.5e6)); // within two pending particles
        // Without a rod nothing melts, and the metal gets all the heat.
        ProcessSettings none;
        if (flame)
            none.choose<Flame>();
        else
            none.choose<SolderingIron>();
        CHECK_FALSE(holdsRod(none));
        CHECK_FALSE(makeProcess(none, steel())->rodRay(torch));
    }
}

TEST_CASE("wire solder melts at the iron's tip too, and a tip colder than its liquidus melts none", "[weld]") {
    TorchSample torch;
    torch.orientation = glm::angleAxis(-std::numbers::pi_v<float> / 2, glm::vec3(1, 0, 0));
    torch.trigger = 1;
    torch.rod = rodAt({1, 0, 0}, 3);
    for (const float temperature : {1000.0F, 1600.0F}) { // degrees Celsius; this metal is liquid from about 1500
        ProcessSettings settings;
        settings.choose<SolderingIron>() = {temperature, 2, 1};
        const auto process = makeProcess(settings, steel());
        for (int i = 0; i < 100; ++i)
            process->step(torch, {0, 0}, kStep, before(3, 0));
        const bool hot = temperature > 1500;
        CHECK((process->arc().rodBall > 0 || process->wire().melted > 0) == hot);
        CHECK((process->wire().area > 0) == hot);
    }
}
