// Measures drawn into a section: their lengths are the station's, their ends are on the metal.
#include "core/training/judging/section_measures.hpp"

#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>

using namespace meltpool;

namespace {

constexpr double kMm = 1e-3;
constexpr double kSpacing = 0.5; ///< particle spacing, mm
constexpr double kFusion = 1790; ///< fusion temperature, K

using Shape = std::function<bool(glm::dvec2)>; ///< shape as a function of a place (z, y), mm

/// Returns the map of metal on a lattice whose molten part is `molten`.
SectionMap mapOf(const Shape& metal, const Shape& molten) {
    std::vector<MapParticle> particles;
    const int reach = static_cast<int>(16 / kSpacing);
    for (int y = -reach; y < reach; ++y)
        for (int x = -reach; x < reach; ++x) {
            const glm::dvec2 place = kSpacing * (glm::dvec2(x, y) + 0.5);
            if (metal(place)) particles.push_back({glm::vec2(kMm * place), molten(place) ? 2000.0F : 400.0F, 300});
        }
    return makeSectionMap({-0.016F, -0.016F}, {0.032F, 0.032F}, static_cast<float>(kMm * kSpacing), 1, particles);
}

bool inTee(glm::dvec2 p) {
    return (p.y < 0 && p.y > -6 && std::abs(p.x) < 14) || (p.x < 0 && p.x > -6 && p.y > -6 && p.y < 14);
}

/// True inside a fillet with legs 7 and 5 mm and a flat surface; fused 1.5 mm into the base plate and 1 mm into the
/// upright one.
bool inFillet(glm::dvec2 p) {
    return p.x > 0 && p.y > 0 && p.x / 7 + p.y / 5 < 1;
}
bool moltenInTee(glm::dvec2 p) {
    return inFillet(p) || (p.x > 0 && p.x < 6 && p.y > -1.5 && p.y < 0) || (p.x < 0 && p.x > -1 && p.y > 0 && p.y < 4);
}

WeldStation filletStation() {
    WeldStation station;
    station.leg1 = 7 * kMm;
    station.leg2 = 5 * kMm;
    station.throat = 35 / std::hypot(7.0, 5.0) * kMm;
    station.toeWidth = std::hypot(7.0, 5.0) * kMm;
    station.convexity = 0.1 * kMm;
    station.penetration = 1.5 * kMm;
    station.edgeAngle1 = std::atan2(5, 7);
    station.edgeAngle2 = std::atan2(7, 5);
    station.overlap1 = 1 * kMm;
    station.undercut1 = 0.1 * kMm;
    return station;
}

const SectionMark& markOf(const std::vector<SectionMark>& marks, const std::string& label) {
    const auto found = std::find_if(marks.begin(), marks.end(), [&](const SectionMark& m) { return m.label == label; });
    if (found == marks.end()) {
        std::string all;
        for (const SectionMark& mark : marks)
            all += mark.label + "; ";
        FAIL("no measure " << label << " among " << all);
    }
    return *found;
}

bool near(glm::vec2 place, glm::dvec2 expectedMm) {
    return glm::distance(glm::dvec2(place), kMm * expectedMm) <= 0.5 * kMm * kSpacing;
}

double lengthOf(const SectionMark& mark) {
    return static_cast<double>(glm::distance(mark.from, mark.to));
}

} // namespace

TEST_CASE("a fillet's measures end at its toes, corner and surface, and are as long as the station says",
          "[measures]") {
    const Shape metal = [](glm::dvec2 p) { return inTee(p) || inFillet(p); };
    const SectionMap map = mapOf(metal, moltenInTee);
    const WeldStation station = filletStation();
    const auto marks = sectionMarks(station, WeldKind::fillet, map, kFusion, {});
    CHECK(near(markOf(marks, "leg 7.0").to, {7, 0}));
    CHECK(near(markOf(marks, "leg 5.0").to, {0, 5}));
    const SectionMark& width = markOf(marks, "toe to toe 8.6");
    CHECK(near(width.from, {7, 0}));
    CHECK(near(width.to, {0, 5}));
    const SectionMark& throat = markOf(marks, "throat 4.1");
    CHECK(near(throat.from, {0, 0}));
    CHECK(lengthOf(throat) == Approx(*station.throat));
    const glm::dvec2 foot = glm::dvec2(throat.to) / kMm;
    CHECK(std::abs(foot.x / 7 + foot.y / 5 - 1) * 4.07 < 0.5 * kSpacing); // point on the surface
    const SectionMark& depth = markOf(marks, "penetration 1.5");
    CHECK(lengthOf(depth) == Approx(1.5 * kMm));
    CHECK(depth.from.y == Approx(0).margin(1e-9));
    CHECK(depth.from.x > 0);
    CHECK(depth.to.y == Approx(-1.5 * kMm).margin(1e-9));
}

TEST_CASE("angles open from the plate to the weld's surface", "[measures]") {
    const SectionMap map = mapOf([](glm::dvec2 p) { return inTee(p) || inFillet(p); }, moltenInTee);
    const auto marks = sectionMarks(filletStation(), WeldKind::fillet, map, kFusion, {});
    const SectionMark& lying = markOf(marks, "angle 36\xC2\xB0");
    CHECK(near(lying.from, {7, 0}));
    // The weld's surface runs from toe to toe.
    const glm::dvec2 way = glm::normalize(glm::dvec2(-7, 5));
    CHECK(glm::distance(glm::dvec2(lying.second), way) < 1e-6);
    const SectionMark& standing = markOf(marks, "angle 54\xC2\xB0");
    CHECK(glm::distance(glm::dvec2(standing.second), -way) < 1e-6);
}

TEST_CASE("faults are drawn where they are longer than the particles resolve; shorter measures are told so",
          "[measures]") {
    const SectionMap map = mapOf([](glm::dvec2 p) { return inTee(p) || inFillet(p); }, moltenInTee);
    WeldStation station = filletStation();
    auto marks = sectionMarks(station, WeldKind::fillet, map, kFusion, {});
    const SectionMark& overlap = markOf(marks, "overlap 1.0");
    CHECK(overlap.tint == SectionMark::Tint::fault);
    CHECK(near(overlap.from, {7, 0}));
    CHECK(near(overlap.to, {6, 0}));
    const SectionMark& convexity = markOf(marks, "convexity < 0.25");
    CHECK(convexity.kind == SectionMark::Kind::note);
    CHECK(convexity.tint == SectionMark::Tint::unresolved);
    for (const SectionMark& mark : marks)
        CHECK(mark.label.find("undercut") == std::string::npos);
    // The fillet is unfused from the corner on the plate that is cold there.
    station.lackOfFusion = 2 * kMm;
    const SectionMap cold = mapOf([](glm::dvec2 p) { return inTee(p) || inFillet(p); },
                                  [](glm::dvec2 p) { return moltenInTee(p) && (p.x > 0 || p.y > 2); });
    marks = sectionMarks(station, WeldKind::fillet, cold, kFusion, {});
    CHECK(near(markOf(marks, "not fused 2.0").to, {0, 2}));
}

TEST_CASE("a bead's and a butt's measures stand on the upper face and the lower one", "[measures]") {
    const auto inPlate = [](glm::dvec2 p) { return p.y < 0 && p.y > -6 && std::abs(p.x) < 14; };
    const auto inBead = [](glm::dvec2 p) { return p.y >= 0 && p.y < 2 - std::abs(p.x - 1) * 0.5; };
    const auto molten = [&](glm::dvec2 p) { return inBead(p) || (p.y < 0 && p.y > -3 && p.x > -2 && p.x < 4); };
    const SectionMap map = mapOf([&](glm::dvec2 p) { return inPlate(p) || inBead(p); }, molten);
    WeldStation station;
    station.middle = 1 * kMm;
    station.toeWidth = 8 * kMm;
    station.height = 2 * kMm;
    station.fusedWidth = 6 * kMm;
    station.penetration = 3 * kMm;
    auto marks = sectionMarks(station, WeldKind::bead, map, kFusion, {});
    const SectionMark& toes = markOf(marks, "toe to toe 8.0");
    CHECK(near(toes.from, {-3, 0}));
    CHECK(near(toes.to, {5, 0}));
    CHECK(near(markOf(marks, "height 2.0").to, {1, 2}));
    CHECK(near(markOf(marks, "fused width 6.0").from, {-2, -0.25}));
    CHECK(lengthOf(markOf(marks, "penetration 3.0")) == Approx(3 * kMm));

    station.rootMissing = 0.8 * kMm;
    station.lackOfFusion = 1.2 * kMm;
    marks = sectionMarks(station, WeldKind::butt, map, kFusion, {0, 6 * kMm});
    const SectionMark& unfused = markOf(marks, "not fused 2.0"); // mark of the worse edge
    CHECK(unfused.from.y == Approx(-6 * kMm));
    CHECK(unfused.to.y == Approx(-4 * kMm));
    CHECK(unfused.tint == SectionMark::Tint::fault);
}

TEST_CASE("a section without weld or map has no measures", "[measures]") {
    const SectionMap map = mapOf(inTee, [](glm::dvec2) { return false; });
    CHECK(sectionMarks({}, WeldKind::fillet, map, kFusion, {}).empty());
    CHECK(sectionMarks(filletStation(), WeldKind::fillet, {}, kFusion, {}).empty());
}
