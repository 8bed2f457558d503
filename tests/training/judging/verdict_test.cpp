// Verdicts on synthetic welds: each imperfection alone fails its own item, unresolved ones neither pass nor fail, and
// short ones have their allowance.
#include "core/training/judging/verdict.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <functional>
#include <numbers>

using namespace meltpool;

namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSpacing = 0.5e-3;

Acceptance shipped(const std::string& name) {
    return readAcceptance(test::testFolder().parent_path() / "app" / "data" / "acceptance" / (name + ".toml"));
}

/// Returns a sound weld: a = 4 mm, 6 mm plates.
WeldStation sound(WeldKind kind) {
    WeldStation s;
    s.toeWidth = 8 * kMm;
    s.undercut1 = s.undercut2 = 0;
    s.hole = 0;
    s.lackOfFusion = -1 * kMm;
    s.facesFused = 1;
    s.overlap1 = s.overlap2 = -1 * kMm;
    if (kind == WeldKind::fillet) {
        s.leg1 = s.leg2 = 6.6 * kMm;
        s.throat = 4.4 * kMm;
        s.convexity = 0.4 * kMm;
        s.edgeAngle1 = s.edgeAngle2 = 50 * kDegree;
        return s;
    }
    s.height = 1 * kMm;
    s.edgeAngle1 = s.edgeAngle2 = 30 * kDegree;
    s.underfill = 0;
    if (kind == WeldKind::butt) {
        s.rootMissing = -1 * kMm;
        s.excessPenetration = 1 * kMm;
        s.rootWidth = 4 * kMm;
        s.rootConcavity = 0;
    }
    return s;
}

NominalWeld nominal(WeldKind kind) {
    NominalWeld weld;
    weld.thickness = 6 * kMm;
    if (kind == WeldKind::fillet) weld.throat = 4 * kMm;
    return weld;
}

/// Returns 50 stations of 2 mm: 100 mm of weld. Those from `first` to `last` are changed.
WeldMeasures weldOf(WeldKind kind, const std::function<void(WeldStation&)>& change = {}, int first = 0, int last = 49,
                    double spacing = kSpacing) {
    std::vector<WeldStation> stations;
    for (int i = 0; i < 50; ++i) {
        stations.push_back(sound(kind));
        stations.back().place = (2 * i + 1) * kMm;
        if (change && i >= first && i <= last) change(stations.back());
    }
    return summarise(stations, kind, 2 * kMm, spacing);
}

const VerdictItem& itemOf(const Verdict& verdict, const std::string& name) {
    for (const VerdictItem& item : verdict.items)
        if (item.name == name) return item;
    FAIL("no item " << name);
    return verdict.items.front();
}

VerdictState stateOf(const WeldMeasures& weld, const Acceptance& acceptance, const std::string& name) {
    return itemOf(judge(weld, acceptance, nominal(weld.kind)), name).state;
}

std::vector<std::string> failures(const Verdict& verdict) {
    std::vector<std::string> names;
    for (const VerdictItem& item : verdict.items)
        if (item.state == VerdictState::fail) names.push_back(item.name);
    return names;
}

} // namespace

TEST_CASE("sound welds are accepted by every shipped file", "[verdict]") {
    for (const char* name : {"iso5817-d", "iso5817-c", "aws-d1-1-static"})
        for (const WeldKind kind : {WeldKind::fillet, WeldKind::butt, WeldKind::bead}) {
            INFO(name << ", " << nameOf(kind));
            const Verdict verdict = judge(weldOf(kind), shipped(name), nominal(kind));
            CHECK(failures(verdict).empty());
            CHECK(verdict.accepted);
            CHECK(itemOf(verdict, "lack_of_fusion").state == VerdictState::pass);
            CHECK(itemOf(verdict, "burn_through").state == VerdictState::pass);
            CHECK(itemOf(verdict, "overlap").state == VerdictState::pass);
            CHECK(itemOf(verdict, "crack").state == VerdictState::notResolved); // the metal model has no cracks
            CHECK_FALSE(itemOf(verdict, "crack").value);
        }
    const Verdict verdict = judge(weldOf(WeldKind::fillet), shipped("iso5817-c"), nominal(WeldKind::fillet));
    CHECK(verdict.standard == "ISO 5817");
    CHECK(verdict.level == "C");
    const VerdictItem& convexity = itemOf(verdict, "convexity");
    CHECK(*convexity.value == Approx(0.4));
    CHECK(*convexity.limit == Approx(2.2));
    CHECK(convexity.unit == "mm");
    CHECK(convexity.uncertainty == Approx(0.5));
    CHECK(convexity.meanOver == 0);
    CHECK(*itemOf(verdict, "toe_angle").value == Approx(130));
    // Not in this metal, or too fine: said by their number.
    const std::vector<std::string> open{"crack", "end_crater_pipe", "poor_restart", "stray_arc", "surface_pore"};
    for (const std::string& name : open)
        CHECK(itemOf(verdict, name).state == VerdictState::notResolved);
    CHECK(verdict.notAssessed() == open.size());
    CHECK(itemOf(verdict, "undercut").state == VerdictState::pass); // 0.5 mm of limit and of uncertainty
    CHECK(itemOf(verdict, "insufficient_throat").state == VerdictState::pass);
}

TEST_CASE("each imperfection alone fails its own item", "[verdict]") {
    struct Fault {
        WeldKind kind;
        const char* item;
        std::function<void(WeldStation&)> change;
    };
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt, bead = WeldKind::bead;
    const std::vector<Fault> faults{
        {fillet, "lack_of_fusion", [](WeldStation& s) { s.lackOfFusion = 1 * kMm; }},
        {bead, "lack_of_fusion", [](WeldStation& s) { s.facesFused = 0; }},
        {butt, "burn_through", [](WeldStation& s) { s.hole = 1 * kMm; }},
        {butt, "root_penetration_missing", [](WeldStation& s) { s.rootMissing = 0.6 * kMm; }},
        {fillet, "undercut", [](WeldStation& s) { s.undercut2 = 1.1 * kMm; }},
        {bead, "undercut", [](WeldStation& s) { s.undercut1 = 1.1 * kMm; }},
        {butt, "excess_weld_metal", [](WeldStation& s) { s.height = 2.8 * kMm; }},
        {fillet, "convexity", [](WeldStation& s) { s.convexity = 2.8 * kMm; }},
        {butt, "excess_penetration", [](WeldStation& s) { s.excessPenetration = 4 * kMm; }},
        {fillet, "toe_angle", [](WeldStation& s) { s.edgeAngle1 = 97 * kDegree; }},
        {butt, "toe_angle", [](WeldStation& s) { s.edgeAngle2 = 87 * kDegree; }},
        {fillet, "excessive_asymmetry", [](WeldStation& s) { s.leg1 = 9.9 * kMm; }},
        {butt, "incompletely_filled_groove", [](WeldStation& s) { s.underfill = 1.2 * kMm; }},
        {butt, "root_concavity", [](WeldStation& s) { s.rootConcavity = 1.2 * kMm; }},
        {fillet, "insufficient_throat", [](WeldStation& s) { s.throat = 2.7 * kMm; }},
        {fillet, "excessive_throat", [](WeldStation& s) { s.throat = 6.4 * kMm; }}};
    const Acceptance c = shipped("iso5817-c");
    for (const Fault& fault : faults) {
        INFO(nameOf(fault.kind) << ": " << fault.item);
        // A single station is enough.
        const Verdict verdict = judge(weldOf(fault.kind, fault.change, 7, 7), c, nominal(fault.kind));
        CHECK(failures(verdict) == std::vector<std::string>{fault.item});
        CHECK_FALSE(verdict.accepted);
        const VerdictItem& item = itemOf(verdict, fault.item);
        REQUIRE(item.place);
        CHECK(*item.place == Approx(15 * kMm));
        CHECK(item.beyond);
        CHECK(item.meanOver == 0);
    }
    const auto smallLeg = weldOf(
        fillet, [](WeldStation& s) { s.leg2 = 2 * kMm; }, 3, 3);
    CHECK(failures(judge(smallLeg, shipped("aws-d1-1-static"), nominal(fillet))) ==
          std::vector<std::string>{"leg_too_small"});
}

TEST_CASE("a station alone resolves one particle, and a limit of nothing fails only beyond it", "[verdict]") {
    const Acceptance c = shipped("iso5817-c"), b = shipped("iso5817-b");
    const auto fillet = WeldKind::fillet;
    const auto undercut = [&](double mm, double spacing) {
        return weldOf(
            fillet, [mm](WeldStation& s) { s.undercut1 = mm * kMm; }, 9, 9, spacing);
    };
    // B allows 0.3 mm. The figure of one station is right to a particle.
    CHECK(stateOf(undercut(0.85, 0.5e-3), b, "undercut") == VerdictState::fail);
    CHECK(stateOf(undercut(0.75, 0.5e-3), b, "undercut") == VerdictState::notResolved);
    CHECK(stateOf(undercut(0, 0.5e-3), b, "undercut") == VerdictState::notResolved);
    CHECK(stateOf(undercut(0.04, 0.25e-3), b, "undercut") == VerdictState::pass);
    CHECK(stateOf(undercut(1.35, 1e-3), b, "undercut") == VerdictState::fail);
    CHECK(stateOf(undercut(1.25, 1e-3), b, "undercut") == VerdictState::notResolved);
    CHECK(stateOf(undercut(0, static_cast<double>(0.5e-3F)), c, "undercut") == VerdictState::pass); // 0.5 by 0.5 mm
    const Verdict told = judge(undercut(0, 1e-3), b, nominal(fillet));
    CHECK(itemOf(told, "undercut").uncertainty == Approx(1));
    CHECK(*itemOf(told, "undercut").limit == Approx(0.3));
    // Without permitted size only a value on the safe side by a particle passes.
    const auto fusion = [&](double mm) {
        return weldOf(
            fillet, [mm](WeldStation& s) { s.lackOfFusion = mm * kMm; }, 9, 9);
    };
    CHECK(stateOf(fusion(-0.55), c, "lack_of_fusion") == VerdictState::pass);
    CHECK(stateOf(fusion(-0.45), c, "lack_of_fusion") == VerdictState::notResolved);
    CHECK(stateOf(fusion(0.45), c, "lack_of_fusion") == VerdictState::notResolved);
    CHECK(stateOf(fusion(0.55), c, "lack_of_fusion") == VerdictState::fail);
    CHECK(judge(fusion(0.45), c, nominal(fillet)).accepted); // reported, but not decisive
    // The angle is near its limit of 100 degrees.
    const auto angle = [&](double degrees) {
        return weldOf(
            fillet, [=](WeldStation& s) { s.edgeAngle1 = (180 - degrees) * kDegree; }, 9, 9);
    };
    CHECK(stateOf(angle(116), c, "toe_angle") == VerdictState::pass);
    CHECK(stateOf(angle(114), c, "toe_angle") == VerdictState::notResolved);
    CHECK(stateOf(angle(86), c, "toe_angle") == VerdictState::notResolved);
    CHECK(stateOf(angle(84), c, "toe_angle") == VerdictState::fail);
    CHECK(itemOf(judge(angle(84), c, nominal(fillet)), "toe_angle").uncertainty == 15);
}

TEST_CASE("a mean over many stations fails what a single one cannot", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet;
    // 1 mm particles: a station is cut over 5 mm, so 50 stations of 2 mm are 1 + 49 x 2 / 5 = 20.6 independent ones.
    const auto fusion = [&](double mm, int first, int last) {
        const auto change = [mm](WeldStation& s) { s.lackOfFusion = mm * kMm; };
        return judge(weldOf(fillet, change, first, last, 1e-3), c, nominal(fillet));
    };
    const Verdict all = fusion(0.6, 0, 49);
    const VerdictItem& missing = itemOf(all, "lack_of_fusion");
    CHECK(missing.state == VerdictState::fail);
    CHECK(*missing.value == Approx(0.6));
    CHECK(missing.uncertainty == Approx(0.5)); // the gauge's own error is left
    CHECK(missing.meanOver == Approx(100 * kMm));
    REQUIRE(missing.failing.size() == 1);
    CHECK(missing.failing[0].low == Approx(0).margin(1e-9));
    CHECK(missing.failing[0].high == Approx(100 * kMm));
    CHECK(itemOf(fusion(0.4, 0, 49), "lack_of_fusion").state == VerdictState::notResolved);
    // Over a part of the weld: 12 stations are 5.4 independent ones, uncertain by 1 / sqrt(5.4) = 0.43 or the gauge's
    // 0.5.
    const Verdict part = fusion(0.7, 20, 31);
    CHECK(itemOf(part, "lack_of_fusion").state == VerdictState::fail);
    CHECK(*itemOf(part, "lack_of_fusion").place == Approx(52 * kMm));
    CHECK(itemOf(part, "lack_of_fusion").failing[0].low == Approx(40 * kMm));
    CHECK(itemOf(part, "lack_of_fusion").failing[0].high == Approx(64 * kMm));
    // Over 3 stations, 1.8 independent ones, the mean is uncertain by 0.75 mm.
    CHECK(itemOf(fusion(0.7, 20, 22), "lack_of_fusion").state == VerdictState::notResolved);
    CHECK(itemOf(fusion(0.8, 20, 22), "lack_of_fusion").state == VerdictState::fail);
}

TEST_CASE("each side of a weld has its own mean", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    // Sides that scatter in turns: the greater of both would be 20 degrees off, each side's mean is 10.
    WeldMeasures weld = weldOf(WeldKind::fillet);
    for (size_t i = 0; i < weld.stations.size(); ++i) {
        weld.stations[i].edgeAngle1 = (i % 2 == 0 ? 90 : 70) * kDegree;
        weld.stations[i].edgeAngle2 = (i % 2 == 0 ? 70 : 90) * kDegree;
    }
    const Verdict verdict = judge(weld, c, nominal(WeldKind::fillet));
    CHECK(itemOf(verdict, "toe_angle").state == VerdictState::notResolved); // each 100 on average, single ones 90
    for (WeldStation& station : weld.stations)
        station.edgeAngle2 = 90 * kDegree;
    CHECK(itemOf(judge(weld, c, nominal(WeldKind::fillet)), "toe_angle").state == VerdictState::fail);
}

TEST_CASE("overlap counts only where the metal stands over the plate at less than a right angle", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto overlap = [&](double mm, double toeDegrees) {
        const auto change = [=](WeldStation& s) {
            s.overlap1 = mm * kMm;
            s.edgeAngle1 = (180 - toeDegrees) * kDegree;
        };
        return stateOf(weldOf(WeldKind::bead, change, 7, 7), c, "overlap");
    };
    CHECK(overlap(0.6, 89) == VerdictState::fail);
    CHECK(overlap(0.4, 89) == VerdictState::notResolved); // finer than a particle of 0.5 mm
    CHECK(overlap(-0.6, 89) == VerdictState::pass);
    CHECK(overlap(3, 91) == VerdictState::notResolved); // the angle is right to 15 degrees
    CHECK(overlap(3, 104) == VerdictState::notResolved);
    CHECK(overlap(3, 106) == VerdictState::pass);
    // The angle of the same side counts.
    const auto other = [](WeldStation& s) {
        s.overlap1 = 0.6 * kMm;
        s.edgeAngle1 = 51 * kDegree;
        s.edgeAngle2 = 100 * kDegree;
    };
    CHECK(stateOf(weldOf(WeldKind::bead, other, 7, 7), c, "overlap") == VerdictState::pass);
}

TEST_CASE("a toe that runs out flat has no place, so its leg is not judged", "[verdict]") {
    const auto flat = [](double degrees) {
        const auto change = [=](WeldStation& s) {
            s.leg2 = 12 * kMm; // the gauge continues a flat surface to far away
            s.edgeAngle2 = degrees * kDegree;
        };
        return weldOf(WeldKind::fillet, change, 7, 7);
    };
    const Acceptance c = shipped("iso5817-c");
    CHECK(stateOf(flat(9), c, "excessive_asymmetry") == VerdictState::fail);
    CHECK(stateOf(flat(8), c, "excessive_asymmetry") == VerdictState::pass);
    // Legs that are longer in turns are not unequal on average: limit 2.6 mm, particles of 2 mm.
    WeldMeasures turns = weldOf(WeldKind::fillet, {}, 0, 49, 2e-3);
    for (size_t i = 0; i < turns.stations.size(); ++i)
        turns.stations[i].leg1 = (6.6 + (i % 2 == 0 ? 4 : -4)) * kMm;
    CHECK(stateOf(turns, c, "excessive_asymmetry") == VerdictState::notResolved);
}

TEST_CASE("short imperfections have their allowance", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt;
    const auto sunk = [](double mm) { return [mm](WeldStation& s) { s.underfill = mm * kMm; }; };
    // 6 mm plates: 0.6 mm over 25 mm in 100 mm. Particles of 0.25 mm: 12 stations are 24 mm, 13 are 26.
    const auto state = [&](double mm, int last) {
        return stateOf(weldOf(butt, sunk(mm), 10, last, 0.25e-3), c, "incompletely_filled_groove");
    };
    CHECK(state(0.5, 21) ==
          VerdictState::notResolved); // long: the stations without any are nearer to 0 than a particle
    CHECK(state(0.5, 22) == VerdictState::fail);
    CHECK(state(0.9, 10) == VerdictState::fail);
    CHECK(state(0.8, 10) == VerdictState::notResolved);
    const auto safe = [&](double mm, int last) {
        WeldMeasures weld = weldOf(
            butt, [](WeldStation& s) { s.underfill = -0.3 * kMm; }, 0, 49, 0.25e-3);
        for (int i = 10; i <= last; ++i)
            weld.stations[static_cast<size_t>(i)].underfill = mm * kMm;
        return stateOf(weld, c, "incompletely_filled_groove");
    };
    CHECK(safe(0.3, 21) == VerdictState::pass);
    CHECK(safe(0.3, 22) == VerdictState::fail); // 26 mm
    CHECK(safe(0.2, 22) == VerdictState::notResolved);
    // A quarter of a shorter weld: 40 mm, so 10 mm.
    const auto shorter = [&](int last) {
        WeldMeasures weld = weldOf(butt, sunk(0.5), 0, last, 0.25e-3);
        weld.stations.resize(20);
        return stateOf(summarise(weld.stations, butt, weld.pitch, 0.25e-3), c, "incompletely_filled_groove");
    };
    CHECK(shorter(4) == VerdictState::notResolved);
    CHECK(shorter(5) == VerdictState::fail);
    // AWS D1.1 permits undercut to 2 mm over 50 mm in any 300; in a weld of 100 mm on half of it.
    const auto deep = [](WeldStation& s) { s.undercut1 = 1.6 * kMm; };
    CHECK(stateOf(weldOf(fillet, deep, 0, 24), shipped("aws-d1-1-static"), "undercut") == VerdictState::notResolved);
    CHECK(stateOf(weldOf(fillet, deep, 0, 25), shipped("aws-d1-1-static"), "undercut") == VerdictState::fail);
}

TEST_CASE("sizes are means over the weld, and as fine as their own scatter", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet;
    // 1 mm particles, 30 mm of weld: 15 stations, 1 + 14 x 2 / 5 = 6.6 independent ones.
    const auto throats = [&](double mean, double scatter, const NominalWeld& asked) {
        WeldMeasures weld = weldOf(fillet, {}, 0, 49, 1e-3);
        weld.stations.resize(15);
        for (size_t i = 0; i < 15; ++i) {
            weld.stations[i].leg1 = weld.stations[i].leg2 = 8 * kMm; // not these limit the size
            // Scatter to and fro around the mean of 14 of them.
            weld.stations[i].throat = (mean + (i == 14 ? 0 : i % 2 == 0 ? scatter : -scatter)) * kMm;
        }
        return itemOf(judge(summarise(weld.stations, fillet, weld.pitch, 1e-3), c, asked), "insufficient_throat");
    };
    // A leg of 6 mm is a throat of 4.24 mm. Short ones may lack 0.72 mm on a quarter of the weld: 0.18 mm on average.
    NominalWeld six;
    six.thickness = 6 * kMm;
    six.leg = 6 * kMm;
    const VerdictItem fast = throats(3.3, 0.2, six);
    CHECK(fast.state == VerdictState::fail);
    CHECK(*fast.value == Approx(0.943).margin(1e-3));
    CHECK(*fast.limit == Approx(0.181).margin(1e-3));
    CHECK(fast.uncertainty == Approx(0.156).margin(0.005)); // 2 x 0.2 / sqrt(6.6), 0.2 with one degree of freedom less
    CHECK(fast.meanOver == Approx(30 * kMm));
    CHECK(throats(3.8, 0.1, six).state == VerdictState::fail);         // lacks 0.44
    CHECK(throats(3.95, 0.1, six).state == VerdictState::notResolved); // lacks 0.29, less than 0.18 + 0.15
    CHECK(throats(4.3, 0.1, six).state == VerdictState::notResolved);
    CHECK(throats(4.4, 0.1, six).state == VerdictState::pass); // 0.157 more, the gauge's error is 0.15
    CHECK(throats(4.4, 0.1, six).uncertainty == Approx(0.15));
    CHECK(throats(4.4, 0.5, six).state == VerdictState::notResolved); // scatters too much
    CHECK(throats(4.7, 0.5, six).state == VerdictState::pass);
    // Legs by AWS D1.1: each plate's own mean.
    const auto legs = [&](double leg1, double leg2) {
        const auto change = [=](WeldStation& s) {
            s.leg1 = leg1 * kMm;
            s.leg2 = leg2 * kMm;
        };
        return itemOf(judge(weldOf(fillet, change, 0, 49, 1e-3), shipped("aws-d1-1-static"), six), "leg_too_small");
    };
    CHECK(legs(6.3, 6.3).state == VerdictState::pass);
    CHECK(legs(6.3, 6.1).state == VerdictState::notResolved);
    CHECK(legs(6.3, 5.5).state == VerdictState::fail); // lacks 0.5 everywhere; 2.5 on a tenth of it is allowed
    CHECK(*legs(6.3, 5.5).value == Approx(0.5));
    CHECK(legs(6.3, 5.7).state == VerdictState::notResolved);
}

TEST_CASE("limits grow with the width at their station, and with nominal sizes that are known", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet;
    const auto convex = [&](double width) {
        const auto change = [width](WeldStation& s) {
            s.convexity = 2.8 * kMm;
            s.toeWidth = width * kMm;
        };
        return stateOf(weldOf(fillet, change, 9, 9), c, "convexity");
    };
    CHECK(convex(8) == VerdictState::fail);         // limit 2.2 mm, and 0.5 mm of uncertainty
    CHECK(convex(10) == VerdictState::notResolved); // limit 2.5 mm
    CHECK(convex(16) == VerdictState::pass);        // limit 3.4 mm
    NominalWeld unknown;
    unknown.thickness = 6 * kMm;
    const Verdict verdict = judge(weldOf(fillet), c, unknown);
    CHECK(itemOf(verdict, "excessive_throat").state == VerdictState::notResolved);
    CHECK_FALSE(itemOf(verdict, "excessive_throat").value);
    CHECK(verdict.accepted);
    NominalWeld leg;
    leg.leg = 5 * kMm;
    CHECK(*leg.throatOf(fillet) == Approx(5 * kMm / std::numbers::sqrt2));
    CHECK(*nominal(fillet).legOf() == Approx(4 * kMm * std::numbers::sqrt2));
    CHECK(*nominal(WeldKind::butt).throatOf(WeldKind::butt) == Approx(6 * kMm));
}

TEST_CASE("what the metal does not contain is estimated and does not decide", "[verdict]") {
    const std::vector<Estimate> estimates{
        {"surface_pore", 3, "Too far."}, {"spatter", 0, "In balance."}, {"undercut", 9, "Never asked."}};
    const Verdict verdict = judge(weldOf(WeldKind::fillet), shipped("iso5817-c"), nominal(WeldKind::fillet), estimates);
    const VerdictItem& pore = itemOf(verdict, "surface_pore");
    CHECK(pore.state == VerdictState::estimated);
    CHECK(*pore.value == 3);
    CHECK(pore.rule == "Too far.");
    CHECK_FALSE(pore.limit); // 0.8 mm limits a pore's size
    CHECK(pore.beyond);
    CHECK(itemOf(verdict, "spatter").state == VerdictState::estimated);
    CHECK_FALSE(itemOf(verdict, "spatter").limit);
    CHECK_FALSE(itemOf(verdict, "spatter").beyond);
    CHECK(itemOf(verdict, "undercut").state == VerdictState::pass); // undercut is measured
    CHECK(itemOf(verdict, "undercut").rule.empty());
    CHECK(itemOf(verdict, "crack").state == VerdictState::notResolved); // cracks have no estimate
    CHECK(verdict.accepted);

    // D1.1 names another kind of pore: one estimate applies, once.
    const Verdict other =
        judge(weldOf(WeldKind::fillet), shipped("aws-d1-1-static"), nominal(WeldKind::fillet), estimates);
    CHECK(itemOf(other, "piping_porosity").state == VerdictState::estimated);
    CHECK(std::none_of(other.items.begin(), other.items.end(),
                       [](const VerdictItem& each) { return each.name == "surface_pore"; }));

    // A failed weld remains failed.
    const Verdict failed = judge(weldOf(WeldKind::fillet, [](WeldStation& s) { s.undercut1 = 3 * kMm; }),
                                 shipped("iso5817-c"), nominal(WeldKind::fillet), estimates);
    CHECK_FALSE(failed.accepted);
}

TEST_CASE("nothing welded is not accepted", "[verdict]") {
    const Verdict verdict =
        judge(summarise({}, WeldKind::bead, 2 * kMm, kSpacing), shipped("iso5817-d"), nominal(WeldKind::bead));
    CHECK_FALSE(verdict.accepted);
    CHECK(failures(verdict).empty());
    // A stretch of the seam has no weld.
    for (const WeldKind kind : {WeldKind::fillet, WeldKind::butt, WeldKind::bead}) {
        const auto bare = [&](WeldStation& s) {
            Section section;
            section.layers = 4;
            if (kind == WeldKind::fillet) section.fusedFaces.emplace();
            if (kind == WeldKind::butt) section.unfusedEdges = {6 * kMm, 6 * kMm};
            s = stationOf(section, kind, s.place);
        };
        const Verdict partly = judge(weldOf(kind, bare, 20, 24), shipped("aws-d1-1-static"), nominal(kind));
        INFO(nameOf(kind));
        CHECK_FALSE(partly.accepted);
        CHECK(itemOf(partly, "lack_of_fusion").state == VerdictState::fail);
    }
    CHECK(nameOf(VerdictState::notResolved) == "not_resolved");
    CHECK(nameOf(VerdictState::estimated) == "estimated");
}

TEST_CASE("a crater is judged by its pit, or by what lacks of the weld's size in it", "[verdict]") {
    const Acceptance c = shipped("iso5817-c"), aws = shipped("aws-d1-1-static");
    const auto crater = [](WeldKind kind, double pit, double surface) {
        WeldMeasures weld = weldOf(kind);
        weld.craterDepth = pit * kMm;
        weld.craterSurface = surface * kMm;
        weld.stop = 99 * kMm;
        return weld;
    };
    // C, 6 mm plate: 0.6 mm; particles of 0.5 mm.
    const WeldMeasures deep = crater(WeldKind::bead, 1.2, 0);
    CHECK(stateOf(deep, c, "end_crater_pipe") == VerdictState::fail);
    CHECK(*itemOf(judge(deep, c, nominal(WeldKind::bead)), "end_crater_pipe").place == Approx(99 * kMm));
    CHECK(stateOf(crater(WeldKind::bead, 1, 0), c, "end_crater_pipe") == VerdictState::notResolved);
    CHECK(stateOf(crater(WeldKind::bead, 0.05, 0), c, "end_crater_pipe") == VerdictState::pass);
    // D1.1: filled up to the throat of 4 mm, or to the plate.
    CHECK(stateOf(crater(WeldKind::fillet, 0, 3.4), aws, "unfilled_crater") == VerdictState::fail);
    CHECK(stateOf(crater(WeldKind::fillet, 0, 3.6), aws, "unfilled_crater") == VerdictState::notResolved);
    CHECK(stateOf(crater(WeldKind::fillet, 0, 4.6), aws, "unfilled_crater") == VerdictState::pass);
    CHECK(stateOf(crater(WeldKind::butt, 0, -0.6), aws, "unfilled_crater") == VerdictState::fail);
    CHECK(stateOf(crater(WeldKind::butt, 0, 0.6), aws, "unfilled_crater") == VerdictState::pass);
}

TEST_CASE("a weld shorter than asked for is judged on its length and not accepted", "[verdict]") {
    WeldMeasures weld = weldOf(WeldKind::fillet);
    weld.asked = 104 * kMm;
    CHECK(judge(weld, shipped("iso5817-c"), nominal(WeldKind::fillet)).accepted);
    weld.asked = 105 * kMm; // 100 mm, a cut of 2.5 mm and a pitch of 2 mm
    const Verdict verdict = judge(weld, shipped("iso5817-c"), nominal(WeldKind::fillet));
    CHECK_FALSE(verdict.accepted);
    CHECK_FALSE(verdict.complete);
    CHECK(failures(verdict).empty());
    CHECK(verdict.judgedLength == Approx(100 * kMm));
    CHECK(verdict.askedLength == Approx(105 * kMm));
}

TEST_CASE("an item that fails tells where, neighbours together", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    WeldMeasures weld = weldOf(
        WeldKind::bead, [](WeldStation& s) { s.hole = 3 * kMm; }, 10, 12);
    weld.stations[30].hole = 3 * kMm;
    const Verdict verdict = judge(weld, c, nominal(WeldKind::bead));
    const VerdictItem& hole = itemOf(verdict, "burn_through");
    CHECK(hole.state == VerdictState::fail);
    REQUIRE(hole.failing.size() == 2);
    CHECK(hole.failing[0].low == Approx(20 * kMm));
    CHECK(hole.failing[0].high == Approx(26 * kMm));
    CHECK(hole.failing[1].low == Approx(60 * kMm));
    CHECK(hole.failing[1].high == Approx(62 * kMm));
    const Verdict fine = judge(weldOf(WeldKind::bead), c, nominal(WeldKind::bead));
    CHECK(itemOf(fine, "burn_through").failing.empty());
}

TEST_CASE("an imperfection of the whole weld is judged at its own place", "[verdict]") {
    WeldFigure uneven;
    uneven.key = "uneven";
    uneven.unit = "mm";
    uneven.judgedWhole = [](const WeldMeasures& weld, const NominalWeld&) -> std::optional<PlacedImperfection> {
        if (!weld.straightness) return std::nullopt;
        return PlacedImperfection{{*weld.straightness / kMm, 0}, 97 * kMm};
    };
    CHECK(uneven.isMeasured());
    AcceptanceItem item; // not permitted at all
    item.imperfection = "uneven";
    item.appliesTo = {WeldKind::bead};
    WeldMeasures weld = weldOf(WeldKind::bead);
    const auto judged = [&] { return judgeItem(weld, item, uneven, nominal(WeldKind::bead)); };
    weld.straightness.reset();
    REQUIRE(judged());
    CHECK(judged()->state == VerdictState::notResolved);
    CHECK_FALSE(judged()->value);
    weld.straightness = 50 * kMm; // far beyond any limit
    const auto fails = judged();
    REQUIRE(fails);
    CHECK(fails->name == "uneven");
    CHECK(fails->state == VerdictState::fail);
    CHECK(*fails->value == Approx(50));
    CHECK(*fails->place == Approx(97 * kMm));
    REQUIRE(fails->failing.size() == 1);
    CHECK(fails->failing[0].low == Approx(96 * kMm));
    CHECK(fails->failing[0].high == Approx(98 * kMm));
    weld.straightness = -1 * kMm;
    CHECK(judged()->state == VerdictState::pass);
    weld.kind = WeldKind::fillet;
    CHECK_FALSE(judged());
}
