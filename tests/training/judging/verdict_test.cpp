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
        s.leg1 = s.leg2 = 5.7 * kMm;
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
    CHECK(convexity.resolution == Approx(0.25));
    CHECK(*itemOf(verdict, "toe_angle").value == Approx(130));
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
        {butt, "root_penetration_missing", [](WeldStation& s) { s.rootMissing = 0.5 * kMm; }},
        {fillet, "undercut", [](WeldStation& s) { s.undercut2 = 0.6 * kMm; }},
        {bead, "undercut", [](WeldStation& s) { s.undercut1 = 0.6 * kMm; }},
        {butt, "excess_weld_metal", [](WeldStation& s) { s.height = 2.3 * kMm; }},
        {fillet, "convexity", [](WeldStation& s) { s.convexity = 2.3 * kMm; }},
        {butt, "excess_penetration", [](WeldStation& s) { s.excessPenetration = 3.5 * kMm; }},
        {fillet, "toe_angle", [](WeldStation& s) { s.edgeAngle1 = 97 * kDegree; }},
        {butt, "toe_angle", [](WeldStation& s) { s.edgeAngle2 = 87 * kDegree; }},
        {fillet, "overlap", [](WeldStation& s) { s.overlap1 = 0.6 * kMm; }},
        {fillet, "excessive_asymmetry", [](WeldStation& s) { s.leg1 = 8.5 * kMm; }},
        {butt, "incompletely_filled_groove", [](WeldStation& s) { s.underfill = 0.7 * kMm; }},
        {butt, "root_concavity", [](WeldStation& s) { s.rootConcavity = 0.7 * kMm; }},
        {fillet, "insufficient_throat", [](WeldStation& s) { s.throat = 3 * kMm; }},
        {fillet, "excessive_throat", [](WeldStation& s) { s.throat = 6 * kMm; }}};
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
    }
    const auto smallLeg = weldOf(
        fillet, [](WeldStation& s) { s.leg2 = 2 * kMm; }, 3, 3);
    CHECK(failures(judge(smallLeg, shipped("aws-d1-1-static"), nominal(fillet))) ==
          std::vector<std::string>{"leg_too_small"});
}

TEST_CASE("what the particles do not resolve neither passes nor fails", "[verdict]") {
    const Acceptance c = shipped("iso5817-c"), b = shipped("iso5817-b");
    const auto fillet = WeldKind::fillet;
    const auto undercut = [&](double mm, double spacing) {
        return weldOf(
            fillet, [mm](WeldStation& s) { s.undercut1 = mm * kMm; }, 0, 49, spacing);
    };
    // B allows 0.3 mm: particles of 0.5 mm resolve it, particles of 1 mm do not.
    CHECK(stateOf(undercut(0.2, 0.5e-3), b, "undercut") == VerdictState::pass);
    CHECK(stateOf(undercut(0.35, 0.5e-3), b, "undercut") == VerdictState::fail);
    CHECK(stateOf(undercut(0, 1e-3), b, "undercut") == VerdictState::notResolved);
    CHECK(stateOf(undercut(0.75, 1e-3), b, "undercut") == VerdictState::notResolved);
    CHECK(stateOf(undercut(0.85, 1e-3), b, "undercut") == VerdictState::fail); // 0.3 is exceeded by more than 0.5
    CHECK(stateOf(undercut(0, static_cast<double>(1e-3F)), c, "undercut") == VerdictState::pass); // 0.5 by 0.5 mm
    const Verdict told = judge(undercut(0, 1e-3), b, nominal(fillet));
    CHECK(itemOf(told, "undercut").resolution == Approx(0.5));
    CHECK(*itemOf(told, "undercut").limit == Approx(0.3));
    // Without permitted size, only a value whose margin exceeds the resolution passes.
    const auto fusion = [&](double mm) { return weldOf(fillet, [mm](WeldStation& s) { s.lackOfFusion = mm * kMm; }); };
    CHECK(stateOf(fusion(-0.3), c, "lack_of_fusion") == VerdictState::pass);
    CHECK(stateOf(fusion(-0.2), c, "lack_of_fusion") == VerdictState::notResolved);
    CHECK(stateOf(fusion(0.2), c, "lack_of_fusion") == VerdictState::notResolved);
    CHECK(stateOf(fusion(0.3), c, "lack_of_fusion") == VerdictState::fail);
    CHECK(judge(fusion(0.2), c, nominal(fillet)).accepted); // reported, but not decisive
    // The angle is near its limit of 100 degrees.
    const auto angle = [&](double degrees) {
        return weldOf(fillet, [=](WeldStation& s) { s.edgeAngle1 = (180 - degrees) * kDegree; });
    };
    CHECK(stateOf(angle(116), c, "toe_angle") == VerdictState::pass);
    CHECK(stateOf(angle(114), c, "toe_angle") == VerdictState::notResolved);
    CHECK(stateOf(angle(86), c, "toe_angle") == VerdictState::notResolved);
    CHECK(stateOf(angle(84), c, "toe_angle") == VerdictState::fail);
    CHECK(itemOf(judge(angle(84), c, nominal(fillet)), "toe_angle").resolution == 15);
}

TEST_CASE("short imperfections have their allowance", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet;
    const auto thin = [](WeldStation& s) { s.throat = 3.4 * kMm; }; // 0.6 mm too small, of 0.7 mm for short ones
    // 12 stations are 24 mm in 100 mm, 13 are 26.
    CHECK(stateOf(weldOf(fillet, thin, 10, 21), c, "insufficient_throat") == VerdictState::pass);
    CHECK(stateOf(weldOf(fillet, thin, 10, 22), c, "insufficient_throat") == VerdictState::fail);
    const Verdict within = judge(weldOf(fillet, thin, 10, 21), c, nominal(fillet));
    CHECK(*itemOf(within, "insufficient_throat").limit == Approx(0.7));
    const auto thinner = [](WeldStation& s) { s.throat = 3.2 * kMm; };
    CHECK(stateOf(weldOf(fillet, thinner, 10, 10), c, "insufficient_throat") == VerdictState::fail);
    // The limit is a quarter of a shorter weld: 40 mm, so 10 mm.
    const auto shorter = [&](int last) {
        WeldMeasures weld = weldOf(fillet, thin, 0, last);
        weld.stations.resize(20);
        return summarise(weld.stations, fillet, weld.pitch, kSpacing);
    };
    CHECK(stateOf(shorter(4), c, "insufficient_throat") == VerdictState::pass);
    CHECK(stateOf(shorter(5), c, "insufficient_throat") == VerdictState::fail);
    // The throat is slightly below nominal over the whole length: within the allowance's limit, but perhaps too long.
    const auto hardly = [](WeldStation& s) { s.throat = 3.9 * kMm; };
    CHECK(stateOf(weldOf(fillet, hardly), c, "insufficient_throat") == VerdictState::notResolved);
    CHECK(stateOf(weldOf(fillet, hardly, 0, 9), c, "insufficient_throat") == VerdictState::pass);
    // AWS D1.1 permits undercut to 2 mm over 50 mm in any 300.
    const auto deep = [](WeldStation& s) { s.undercut1 = 1.5 * kMm; };
    CHECK(stateOf(weldOf(fillet, deep, 0, 24), shipped("aws-d1-1-static"), "undercut") == VerdictState::pass);
    CHECK(stateOf(weldOf(fillet, deep, 0, 25), shipped("aws-d1-1-static"), "undercut") == VerdictState::fail);
}

TEST_CASE("limits grow with the width at their station, and with nominal sizes that are known", "[verdict]") {
    const Acceptance c = shipped("iso5817-c");
    const auto fillet = WeldKind::fillet;
    const auto convex = [&](double width) {
        return weldOf(fillet, [width](WeldStation& s) {
            s.convexity = 2.3 * kMm;
            s.toeWidth = width * kMm;
        });
    };
    CHECK(stateOf(convex(8), c, "convexity") == VerdictState::fail);  // limit 2.2 mm
    CHECK(stateOf(convex(10), c, "convexity") == VerdictState::pass); // limit 2.5 mm
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
