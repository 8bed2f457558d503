// A weld on the real metal: distance to the metal, effect of the arc, and agreement of live and replayed welds.
#include "core/weld/process/weld.hpp"
#include "core/weld/torch/torch_moves.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace meltpool;

namespace {

constexpr float kMm = 1e-3F;

Material steel() {
    return readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml");
}

/// Returns a plate, or by its kind a joint, of 30x20x4 mm.
WorkpieceParameters smallPiece() {
    WorkpieceParameters parameters;
    parameters.lengthMm = 30;
    parameters.widthMm = 20;
    parameters.thicknessMm = 4;
    parameters.roomAboveMm = 10;
    return parameters;
}

Workpiece smallPlate() {
    return makeWorkpiece(smallPiece());
}

ProcessSettings wireSettings() {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.voltage = 19;
    gmaw.wireFeedMPerMin = 5.8F;
    gmaw.wireDiameterMm = 0.9F;
    return settings;
}

/// Returns an upright torch whose pose is `mm` over the plate's upper face.
TorchSample over(float mm, float trigger = 1, float x = 0.3F) {
    TorchSample torch;
    torch.tip = {x * kMm, mm * kMm, 0.2F * kMm};
    torch.orientation = heldOrientation(std::numbers::pi / 2, 0, {1, 0, 0});
    torch.trigger = trigger;
    return torch;
}

float distanceSeen(Weld& weld, const TorchSample& torch) {
    for (int i = 0; i < 6; ++i)
        weld.step(torch, nullptr);
    return weld.arc().distance / kMm;
}

} // namespace

TEST_CASE("the metal on the torch's axis is found to a tenth of a spacing, upright and slanted", "[weld]") {
    ProcessSettings settings;
    settings.choose<Gtaw>();
    Weld weld(test::shaders(), steel(), smallPlate(), settings);
    for (const float mm : {0.5F, 2.0F, 3.7F, 10.0F, 30.0F})
        for (const float x : {0.0F, 0.3F, 0.5F}) {
            INFO(mm << " mm over the plate at " << x);
            CHECK(distanceSeen(weld, over(mm, 0, x)) == Approx(mm).margin(0.12));
        }
    for (const double degrees : {15.0, 30.0, 45.0}) {
        TorchSample torch = over(3, 0);
        torch.orientation = heldOrientation(std::numbers::pi / 2, degrees * std::numbers::pi / 180, {1, 0, 0});
        INFO(degrees << " degrees");
        CHECK(distanceSeen(weld, torch) == Approx(3 / std::cos(degrees * std::numbers::pi / 180)).margin(0.2));
    }
    TorchSample beside = over(3, 0);
    beside.tip.z = 40 * kMm;
    CHECK(std::isinf(distanceSeen(weld, beside)));
    CHECK(std::isinf(distanceSeen(weld, over(80, 0))));
}

TEST_CASE("over a gap between two plates the torch finds their edges, beside a plate nothing", "[weld]") {
    ProcessSettings settings;
    settings.choose<Gtaw>();
    WorkpieceParameters parameters = smallPiece();
    parameters.kind = static_cast<int>(WorkpieceKind::Butt);
    for (const float spacings : {1.0F, 2.0F}) {
        parameters.gapMm = spacings * parameters.spacingMm;
        Weld weld(test::shaders(), steel(), makeWorkpiece(parameters), settings);
        for (const float mm : {2.0F, 10.0F}) {
            TorchSample torch = over(mm, 0, 5); // away from the tacks
            torch.tip.z = 0;
            INFO(mm << " mm over a gap of " << spacings << " spacings");
            CHECK(distanceSeen(weld, torch) == Approx(mm).margin(0.6));
        }
        TorchSample beside = over(2, 0, 5);
        beside.tip.z = (parameters.widthMm / 2 + 1.8F * parameters.spacingMm) * kMm;
        CHECK(std::isinf(distanceSeen(weld, beside)));
    }
}

TEST_CASE("the computed current follows the distance from contact tip to plate", "[weld]") {
    for (const float ctwd : {3.0F, 12.0F, 20.0F, 30.0F}) {
        ProcessSettings settings = wireSettings();
        settings.of<Gmaw>().stickOutMm = ctwd - 1;
        Weld weld(test::shaders(), steel(), smallPlate(), settings);
        double sum = 0, extension = 0;
        int count = 0;
        for (int i = 0; i < 60; ++i) {
            weld.step(over(1), nullptr);
            if (i < 20) continue;
            sum += double(weld.arc().current);
            extension += double(weld.arc().extension);
            ++count;
        }
        const WireMelting wire = WireMelting::steel(0.9e-3);
        INFO(ctwd << " mm: " << sum / count << " A at " << extension / count * 1e3 << " mm of extension");
        CHECK(weld.arc().burns());
        CHECK(sum / count == Approx(wire.current(5.8 / 60, extension / count)).epsilon(0.1));
    }
}

TEST_CASE("a torch that is lifted while it welds takes its power along, and loses its arc at the limit", "[weld]") {
    ProcessSettings settings;
    settings.choose<Gtaw>().current = 120;
    Weld weld(test::shaders(), steel(), smallPlate(), settings);
    weld.step(over(2, 0), nullptr);
    double lastLength = 0, burned = 0;
    bool out = false;
    for (int i = 0; i < 160 && !out; ++i) {
        const float mm = 2 + 0.1F * static_cast<float>(i);
        weld.step(over(mm), nullptr);
        const ArcState& arc = weld.arc();
        if (i < 8) continue;
        out = !arc.burns();
        if (out) {
            CHECK(double(arc.distance) > gtawLongestArc(120));
            CHECK(weld.process().sources().empty());
            continue;
        }
        burned += weld.timeStep();
        CHECK(double(arc.voltage) == Approx(gtawVoltage(double(arc.length), 120)).epsilon(1e-4));
        CHECK(double(arc.length) >= lastLength - 0.3e-3);
        lastLength = double(arc.length);
    }
    CHECK(out);
    CHECK(burned > 0.5);
    CHECK(lastLength == Approx(gtawLongestArc(120)).margin(1e-3));
}

TEST_CASE("wire that is fed in the air for a second is found again when it melts", "[weld]") {
    Weld weld(test::shaders(), steel(), smallPlate(), wireSettings());
    const auto second = static_cast<int>(std::lround(1 / weld.timeStep()));
    for (int i = 0; i < second; ++i)
        weld.step(over(200), nullptr);
    WireAccount wire = weld.process().wire();
    CHECK(wire.melted == 0);
    CHECK(wire.fed == Approx(5.8 / 60).epsilon(0.01));
    CHECK(wire.standing == Approx(wire.fed + 12e-3));
    CHECK(weld.process().filler().fed() == 0);
    const double mass = wire.fed * wire.area * 7850;
    CHECK(mass == Approx(0.483e-3).epsilon(0.02)); // kg
    for (int i = 0; i < second; ++i)
        weld.step(over(2), nullptr);
    wire = weld.process().wire();
    CHECK(weld.arc().burns());
    CHECK(wire.melted + wire.standing == Approx(wire.fed + 12e-3));
    CHECK(double(weld.process().filler().fed()) == Approx(wire.melted * wire.area / 1e-9).margin(1));
    CHECK(wire.standing < 16e-3);
}

TEST_CASE("the same torch gives the same bits after a reset and in another weld", "[weld]") {
    std::uint64_t hashes[3];
    Weld first(test::shaders(), steel(), smallPlate(), wireSettings());
    Weld second(test::shaders(), steel(), smallPlate(), wireSettings());
    for (int run = 0; run < 3; ++run) {
        Weld& weld = run == 2 ? second : first;
        for (int i = 0; i < 50; ++i)
            weld.step(over(3 - 0.02F * static_cast<float>(i)), nullptr);
        hashes[run] = weld.metal().stateHash();
        if (run == 0) first.reset();
    }
    CHECK(hashes[0] == hashes[1]);
    CHECK(hashes[0] == hashes[2]);
}

TEST_CASE(
    "a setting that changes under the arc stirs the pool anew, and after a reset all is as with it from the start",
    "[weld]") {
    const auto tig = [](float amperes) {
        ProcessSettings settings;
        settings.choose<Gtaw>().current = amperes;
        return settings;
    };
    const auto run = [](Weld& weld, const ProcessSettings& settings) {
        for (int i = 0; i < 40; ++i) {
            weld.apply(settings);
            weld.step(over(2), nullptr);
        }
        return weld.metal().stateHash();
    };
    const auto hot = [](const Weld& weld) {
        const HeatTable& table = weld.metal().table();
        return table.kirchhoffAt(table.enthalpyAt(2500)) - table.kirchhoffAt(table.enthalpyAt(2200));
    };
    Weld strong(test::shaders(), steel(), smallPlate(), tig(200));
    Weld changed(test::shaders(), steel(), smallPlate(), tig(100));
    CHECK(hot(strong) == Approx(hot(changed) * arcStirring(200) / arcStirring(100)));
    const double atFirst = hot(changed);
    run(changed, tig(100));
    CHECK(hot(changed) == atFirst); // the state is unchanged
    const auto first = run(strong, tig(200));
    run(changed, tig(200));
    CHECK(hot(changed) == hot(strong));
    changed.reset();
    CHECK(run(changed, tig(200)) == first);
    CHECK(changed.timeStep() == strong.timeStep());
}

TEST_CASE("a rod that is dipped into a GTAW pool becomes weld metal, one that is held away from it does not",
          "[weld]") {
    double fed[2] = {};
    for (const bool dipped : {false, true}) {
        ProcessSettings settings;
        settings.choose<Gtaw>().current = 130;
        Weld weld(test::shaders(), steel(), smallPlate(), settings);
        for (int i = 0; i < 260; ++i) {
            TorchSample torch = over(2);
            const double seconds = i * weld.timeStep();
            RodHold hold;
            hold.angle = 20 * std::numbers::pi / 180;
            hold.ahead = 2.5e-3;
            hold.below = 2e-3;
            hold.rest = 0.015;
            hold.depth = 1.5e-3;
            hold.frequency = dipped && seconds > 1 ? 1 : 0;
            hold.feed = 3e-3;
            torch.rod = hold.sample(torch.tip, seconds - 1);
            weld.step(torch, nullptr);
        }
        CHECK(weld.arc().burns());
        fed[dipped ? 1 : 0] = double(weld.process().filler().fed());
    }
    CHECK(fed[0] == 0);
    CHECK(fed[1] > 3);
}

TEST_CASE("a stick touches the plate, strikes when it is lifted, and lays metal while the hand follows it", "[weld]") {
    ProcessSettings settings;
    settings.choose<Smaw>().current = 115;
    Weld weld(test::shaders(), steel(), smallPlate(), settings);
    const double rate = smawBurnOff(0, 115, 3.2e-3);
    double burning = 0;
    for (int i = 0; i < 300; ++i) {
        const double seconds = i * weld.timeStep();
        const double lifted = std::clamp((seconds - 0.2) / 0.1, 0.0, 1.0) * 3 - 0.2;
        const double x = -8 + 4 * std::max(seconds - 0.3, 0.0); // mm
        weld.step(over(float(lifted - 1e3 * rate * burning), 1, float(x)), nullptr);
        if (weld.arc().burns()) burning += weld.timeStep();
        if (seconds < 0.15) CHECK_FALSE(weld.arc().burns());
    }
    CHECK(weld.arc().burns());
    CHECK(burning > 0.8 * (300 * weld.timeStep() - 0.3));
    CHECK(double(weld.arc().length) * 1e3 == Approx(2.5).margin(2)); // the bead grows under the arc
    CHECK(double(weld.process().burntOff()) == Approx(rate * burning).epsilon(0.1));
    CHECK(weld.process().filler().fed() > 50);
}

TEST_CASE("a stop of the torch stays in the freezing times: the crater closes inwards, and what follows is later",
          "[weld]") {
    ProcessSettings settings;
    settings.choose<Gtaw>().rodDiameterMm = 0;
    Weld weld(test::shaders(), steel(), smallPlate(), settings);
    constexpr float kSpeed = 3, kStop = 1, kGoesOn = 4; // mm/s; mm of the torch's stop; mm of its end
    float x = -5;
    double time = 0;
    const auto step = [&](float trigger) {
        weld.step(over(2, trigger, x), nullptr);
        time += weld.timeStep();
    };
    const auto travel = [&](float to) {
        for (; x < to; x += kSpeed * static_cast<float>(weld.timeStep()))
            step(1);
    };
    const auto wait = [&](double seconds) {
        const double end = time + seconds;
        while (time < end)
            step(0);
    };
    travel(kStop);
    const auto stopped = static_cast<float>(time);
    wait(1.2);
    const MetalState& state = weld.metal().state();
    const auto frozen = [&] { // x and z in mm and time of the frozen upper face
        const auto places = state.position.read<glm::vec4>(state.particles());
        const auto times = state.frozenAt.read<float>(state.particles());
        std::vector<glm::vec3> all;
        for (size_t i = 0; i < places.size(); ++i)
            if (times[i] > 0 && places[i].y > -1.2F * kMm)
                all.emplace_back(places[i].x / kMm, places[i].z / kMm, times[i]);
        return all;
    };
    // The crater was molten when the arc went out.
    std::vector<glm::vec3> crater;
    glm::vec2 middle(0);
    for (const glm::vec3& each : frozen())
        if (each.z > stopped) {
            crater.push_back(each);
            middle += glm::vec2(each);
        }
    REQUIRE(crater.size() > 12);
    middle /= static_cast<float>(crater.size());
    double inner = 0, outer = 0, innerCount = 0, outerCount = 0;
    for (const glm::vec3& each : crater) {
        const bool near = glm::distance(glm::vec2(each), middle) < 1.5F;
        (near ? inner : outer) += static_cast<double>(each.z);
        (near ? innerCount : outerCount) += 1;
    }
    REQUIRE((innerCount > 2 && outerCount > 2));
    INFO("the middle froze " << inner / innerCount - double(stopped) << " s after the arc, the rim "
                             << outer / outerCount - double(stopped));
    CHECK(inner / innerCount > outer / outerCount + 0.05);
    // The weld continues from its stop: along the seam time jumps by at least the pause.
    travel(kGoesOn);
    wait(1.5);
    float before = 0, after = std::numeric_limits<float>::infinity();
    for (const glm::vec3& each : frozen()) {
        if (std::abs(each.y) > 1.6F) continue;
        if (each.z <= stopped + 1.2F)
            before = std::max(before, each.z);
        else
            after = std::min(after, each.z);
    }
    CHECK(after - before > 0.5F);
}

TEST_CASE("a TIG pool of clean steel is wide and flat, one with much sulphur narrow and deep", "[weld]") {
    const auto pool = [](double sulphur) {
        Material metal = steel();
        metal.sulphur = sulphur;
        WorkpieceParameters piece = smallPiece();
        piece.thicknessMm = 8;
        ProcessSettings settings;
        settings.choose<Gtaw>().current = 160;
        Weld weld(test::shaders(), metal, makeWorkpiece(piece), settings);
        for (double time = 0; time < 2.5; time += weld.timeStep())
            weld.step(over(2), nullptr);
        const MetalState& state = weld.metal().state();
        float wide = 0, deep = 0; // distance from the middle of the upper face, m
        for (const vec4& p : state.position.read<vec4>(state.particles()))
            if (double(p.w) > metal.liquidus) {
                wide = std::max(wide, std::abs(p.z - 0.2F * kMm));
                deep = std::max(deep, -p.y);
            }
        REQUIRE(wide > 2 * kMm);
        return std::pair(wide, deep);
    };
    const auto clean = pool(0.001), sulphur = pool(0.05);
    INFO("clean " << clean.first << " x " << clean.second << ", sulphur " << sulphur.first << " x " << sulphur.second);
    CHECK(sulphur.second > clean.second + 0.4F * kMm);
    CHECK(sulphur.first < clean.first - 0.15F * kMm);
}
