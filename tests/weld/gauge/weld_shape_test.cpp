// Toes, widths, heights, angles, legs and throats of outlines with closed forms: drawn exactly, tilted, and made of
// particles of 1 and 0.5 mm; lengths in mm.
#include "core/weld/gauge/weld_faults.hpp"
#include "core/weld/gauge/weld_shape.hpp"
#include "tests/support/catch.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace meltpool;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMm = 1e-3;

double degrees(double radians) {
    return radians * 180 / kPi;
}

/// A bead whose surface is a circular arc that meets the plate at `angle`.
struct Segment {
    double angle, radius;

    double halfWidth() const { return radius * std::sin(angle); }
    double height() const { return radius * (1 - std::cos(angle)); }
    double area() const { return radius * radius * (angle - std::sin(angle) * std::cos(angle)); }
    /// Returns half the width between the bead's outermost places.
    double halfCover() const { return angle > kPi / 2 ? radius : halfWidth(); }
    glm::dvec2 ends(double y) const {
        const double up = y + radius * std::cos(angle), half = std::sqrt(std::max(radius * radius - up * up, 0.0));
        return {-half, half};
    }
    /// Returns the outline from its high toe over the crown to its low one.
    WeldOutline line() const {
        WeldOutline made;
        constexpr int kPieces = 4000;
        for (int i = 0; i <= kPieces; ++i) {
            const double at = angle * (1 - 2.0 * i / kPieces);
            made.push_back({radius * std::sin(at), radius * (std::cos(at) - std::cos(angle))});
        }
        return made;
    }
};

/// Returns the outline of a plate from z = -20 to 20 mm, 6 mm thick, with `weld` on it; rotated about the origin by
/// `tilt` rad.
WeldOutline plateWith(const WeldOutline& weld, double tilt = 0) {
    WeldOutline outline{{-20, 0}, {-20, -6}, {20, -6}, {20, 0}};
    outline.insert(outline.end(), weld.begin(), weld.end());
    for (glm::dvec2& p : outline)
        p = kMm * glm::dvec2(std::cos(tilt) * p.x - std::sin(tilt) * p.y, std::sin(tilt) * p.x + std::cos(tilt) * p.y);
    return outline;
}

using Shape = std::function<bool(glm::dvec2)>;
/// Begin and end of a weld across the seam at a height.
using Ends = std::function<glm::dvec2(double)>;

bool inPlate(glm::dvec2 p) {
    return p.y < 0 && p.y > -6 && std::abs(p.x) < 14;
}

bool inTee(glm::dvec2 p) {
    return inPlate(p) || (p.x < 0 && p.x > -6 && p.y > -6 && p.y < 14);
}

using Particles = std::vector<glm::dvec2>;

/// Returns settled metal: rows of particles a spacing apart from the plate upwards, each evenly spread from end to end.
/// The rest of a row beyond whole particles is one more particle in that share of the layers.
std::vector<Particles> settled(double spacing, double height, const Ends& ends, int layers = 10) {
    std::vector<Particles> made(static_cast<size_t>(layers));
    for (int layer = 0; layer < layers; ++layer)
        for (double y = 0.5 * spacing; y < height; y += spacing) {
            const glm::dvec2 from = ends(y);
            const double count = std::floor((from.y - from.x) / spacing + (layer + 0.5) / layers);
            for (double i = 0.5; i < count; ++i)
                made[static_cast<size_t>(layer)].push_back({glm::mix(from.x, from.y, i / count), y});
        }
    return made;
}

/// Returns the outline of layers of such metal on a plate, with each particle moved at random by up to `disorder`
/// spacings.
WeldOutline ofParticles(double spacing, const Shape& plate, const std::vector<Particles>& layers, double disorder = 0,
                        unsigned seed = 1) {
    std::minstd_rand random(seed);
    std::uniform_real_distribution<double> moved(-disorder * spacing, disorder * spacing);
    std::vector<MapParticle> particles;
    const int reach = static_cast<int>(16 / spacing);
    for (const Particles& weld : layers) {
        for (int y = -reach; y < reach; ++y)
            for (int x = -reach; x < reach; ++x) {
                const glm::dvec2 place = spacing * (glm::dvec2(x, y) + 0.5);
                if (plate(place)) particles.push_back({glm::vec2(kMm * place), 300, 300});
            }
        for (const glm::dvec2 place : weld) {
            const double across = moved(random), up = moved(random);
            particles.push_back({glm::vec2(kMm * (place + glm::dvec2(across, up))), 300, 300});
        }
    }
    return weldOutline(makeSectionMap({-0.018F, -0.018F}, {0.036F, 0.036F}, static_cast<float>(kMm * spacing),
                                      static_cast<int>(layers.size()), particles));
}

/// Returns a tee's outline with the fillet surface `weld`, from the base plate's toe to the upright plate's.
WeldOutline teeWith(const WeldOutline& weld) {
    WeldOutline outline{{-6, 14}, {-6, 0}, {-14, 0}, {-14, -6}, {14, -6}, {14, 0}};
    outline.insert(outline.end(), weld.begin(), weld.end());
    outline.push_back({0, 14});
    for (glm::dvec2& p : outline)
        p *= kMm;
    return outline;
}

} // namespace

TEST_CASE("a bead of a circle's segment is measured exactly, flat or overhanging, level or tilted", "[gauge]") {
    for (const double angle : {25.0, 50.0, 89.0, 90.0, 110.0, 140.0})
        for (const double tilt : {0.0, 0.3, -1.2, 2.8}) {
            INFO(angle << " degrees, tilted by " << tilt);
            const Segment exact{angle * kPi / 180, 3.7};
            const PlateFace face{{0, 0}, {std::cos(tilt), std::sin(tilt)}, {-std::sin(tilt), std::cos(tilt)}};
            const BeadShape bead = measureBead(plateWith(exact.line(), tilt), face, 0);
            REQUIRE(bead.toes);
            CHECK(bead.toeWidth() == Approx(2 * kMm * exact.halfWidth()).epsilon(1e-3));
            CHECK((*bead.toes)[0].place == Approx(-kMm * exact.halfWidth()).epsilon(1e-3));
            CHECK(bead.height == Approx(kMm * exact.height()).epsilon(1e-5));
            CHECK(bead.reinforcement == Approx(kMm * kMm * exact.area()).epsilon(1e-3));
            CHECK(bead.cover.length() == Approx(2 * kMm * exact.halfCover()).epsilon(1e-3));
            for (const WeldToe& toe : *bead.toes)
                CHECK(degrees(toe.angle) == Approx(angle).margin(0.2));
        }
}

TEST_CASE("a bead that leans has an angle and a toe at each side", "[gauge]") {
    // Two arcs meet in a crown 3 mm high: 4 mm to the high end, 2.5 mm to the low one.
    const auto arcTo = [](double reach, double share) {
        const double radius = (reach * reach + 9) / 6, angle = 2 * std::atan2(3.0, std::abs(reach)) * share;
        return glm::dvec2(std::copysign(radius * std::sin(angle), reach), 3 - radius * (1 - std::cos(angle)));
    };
    WeldOutline weld;
    for (int i = 0; i <= 1000; ++i)
        weld.push_back(arcTo(4, 1 - i / 1000.0));
    for (int i = 1; i <= 1000; ++i)
        weld.push_back(arcTo(-2.5, i / 1000.0));
    const BeadShape bead = measureBead(plateWith(weld), {}, 0);
    REQUIRE(bead.toes);
    CHECK((*bead.toes)[0].place == Approx(-2.5 * kMm).epsilon(0.01));
    CHECK((*bead.toes)[1].place == Approx(4 * kMm).epsilon(0.01));
    // The crown's middle is found from both flanks, and is a little towards the longer one.
    CHECK(degrees((*bead.toes)[0].angle) == Approx(degrees(2 * std::atan2(3, 2.5))).margin(10));
    CHECK(degrees((*bead.toes)[1].angle) == Approx(degrees(2 * std::atan2(3, 4.0))).margin(8));
    CHECK((*bead.toes)[0].angle > (*bead.toes)[1].angle + 0.2);
    // With straight flanks, the low one overhanging, toes and cover are exact.
    const BeadShape block = measureBead(plateWith({{5, 0}, {2, 3}, {-2.8, 3}, {-2, 0}}), {}, 0);
    REQUIRE(block.toes);
    CHECK((*block.toes)[0].place == Approx(-2 * kMm).epsilon(0.02));
    CHECK((*block.toes)[1].place == Approx(5 * kMm).epsilon(0.02));
    CHECK(block.cover.low == Approx(-2.8 * kMm));
}

TEST_CASE("overlap is the bead's metal beyond the fused stretch, at each side", "[gauge]") {
    const Segment exact{120 * kPi / 180, 3};
    const BeadShape bead = measureBead(plateWith(exact.line()), {}, 0);
    const auto overlap = bead.overlap(FaceStretch{-1.5 * kMm, 2.9 * kMm});
    CHECK(overlap[0] == Approx(1.5 * kMm).epsilon(1e-3)); // the bead reaches to -3 mm, beyond its toe at -2.6 mm
    CHECK(overlap[1] == Approx(0.1 * kMm).epsilon(0.02));
    CHECK(bead.overlap(FaceStretch{-4 * kMm, 4 * kMm}) == std::array<double, 2>{0, 0});
    CHECK(bead.overlap(std::nullopt)[0] == Approx(3 * kMm).epsilon(1e-3)); // without fusion: half of the cover
    CHECK(BeadShape{}.overlap(std::nullopt) == std::array<double, 2>{0, 0});
}

TEST_CASE("particles measure a bead to a part of their spacing, at 1 and at 0.5 mm", "[gauge]") {
    for (const double spacing : {1.0, 0.5})
        for (const double angle : {35.0, 60.0, 90.0, 115.0})
            for (const double height : {2.0, 3.0, 4.0}) {
                const double radians = angle * kPi / 180;
                const Segment exact{radians, height / (1 - std::cos(radians))};
                if (exact.halfCover() > 11) continue; // too wide for the plate
                INFO(angle << " degrees, " << height << " mm high, particles of " << spacing << " mm");
                const auto metal = settled(spacing, height, [&](double y) { return exact.ends(y); });
                const BeadShape bead = measureBead(ofParticles(spacing, inPlate, metal), {}, kMm * spacing);
                REQUIRE(bead.toes);
                // Two rows of particles are the least with a shape: less exact than three and more.
                const bool low = height < 2.5 * spacing;
                const double most = (low ? 0.45 : 0.36) * spacing;
                CHECK(bead.height / kMm == Approx(height).margin(0.15 * spacing));
                CHECK(bead.toeWidth() / kMm == Approx(2 * exact.halfWidth()).margin(most));
                CHECK(bead.cover.length() / kMm == Approx(2 * exact.halfCover()).margin(most));
                for (const WeldToe& toe : *bead.toes)
                    CHECK(degrees(toe.angle) == Approx(angle).margin(low ? 11 : 6));
                CHECK(bead.reinforcement / kMm / kMm == Approx(exact.area()).epsilon(low ? 0.08 : 0.06));
            }
}

TEST_CASE("five layers of disordered particles scatter about the bead that they stand for", "[gauge]") {
    const Segment exact{80 * kPi / 180, 3 / (1 - std::cos(80 * kPi / 180))};
    for (const double spacing : {1.0, 0.5}) {
        INFO("particles of " << spacing << " mm");
        const auto metal = settled(
            spacing, 3, [&](double y) { return exact.ends(y); }, 5);
        double width = 0, angle = 0;
        constexpr unsigned kTries = 20;
        for (unsigned seed = 1; seed <= kTries; ++seed) {
            const BeadShape bead = measureBead(ofParticles(spacing, inPlate, metal, 0.25, seed), {}, kMm * spacing);
            REQUIRE(bead.toes);
            width += bead.toeWidth() / kMm / kTries;
            CHECK(bead.height / kMm == Approx(3).margin(0.3 * spacing));
            CHECK(bead.toeWidth() / kMm == Approx(2 * exact.halfWidth()).margin(0.6 * spacing));
            for (const WeldToe& toe : *bead.toes) {
                CHECK(degrees(toe.angle) == Approx(80).margin(15));
                angle += 0.5 * degrees(toe.angle) / kTries;
            }
        }
        CHECK(width == Approx(2 * exact.halfWidth()).margin(0.3 * spacing));
        CHECK(angle == Approx(80).margin(4));
    }
}

TEST_CASE("a plate without a bead has no toes and no height", "[gauge]") {
    for (const double spacing : {1.0, 0.5}) {
        const BeadShape bare = measureBead(ofParticles(spacing, inPlate, {{}}), {}, kMm * spacing);
        CHECK_FALSE(bare.toes);
        CHECK(bare.height == 0);
        CHECK(bare.toeWidth() == 0);
        CHECK(bare.reinforcement == 0);
        // Half a row of metal has a height but no measurable toes.
        std::vector<Particles> film = settled(
            spacing, spacing, [](double) { return glm::dvec2(-4, 4); }, 2);
        film[1].clear();
        const BeadShape thin = measureBead(ofParticles(spacing, inPlate, film), {}, kMm * spacing);
        CHECK_FALSE(thin.toes);
        CHECK(thin.height / kMm == Approx(0.5 * spacing).margin(0.25 * spacing));
    }
    CHECK(measureBead({}, {}, kMm).height == 0);
}

TEST_CASE("the outline is the edge of the largest piece: no pores, no drops in the air", "[gauge]") {
    const auto drop = settled(0.5, 8, [](double y) {
        const double half = std::sqrt(std::max(4 - (y - 6) * (y - 6), 0.0));
        return glm::dvec2(5 - half, 5 + half);
    });
    const auto porous = [](glm::dvec2 p) { return inPlate(p) && glm::distance(p, glm::dvec2(-6, -3)) > 1.6; };
    const WeldOutline outline = ofParticles(0.5, porous, drop);
    CHECK(areaInside(outline) / kMm / kMm == Approx(28 * 6).epsilon(0.01));
    CHECK(measureBead(outline, {}, 0.5 * kMm).height == 0);
    CHECK(weldOutline({}).empty());
}

TEST_CASE("legs, throat and angles of fillets are exact, with equal and unequal legs", "[gauge]") {
    for (const glm::dvec2 legs : {glm::dvec2(5, 5), glm::dvec2(7, 4), glm::dvec2(3, 4.5)}) {
        INFO(legs.x << " mm along the base plate, " << legs.y << " mm up the upright one");
        const auto fillet = measureFillet(teeWith({{legs.x, 0}, {0, legs.y}}), {}, 0);
        REQUIRE(fillet);
        CHECK(fillet->toes[0].place == Approx(legs.x * kMm));
        CHECK(fillet->toes[1].place == Approx(legs.y * kMm));
        CHECK(fillet->throat == Approx(kMm * legs.x * legs.y / glm::length(legs)));
        CHECK(fillet->area == Approx(0.5 * kMm * kMm * legs.x * legs.y));
        CHECK(degrees(fillet->toes[0].angle) == Approx(degrees(std::atan2(legs.y, legs.x))).margin(0.01));
        CHECK(degrees(fillet->toes[1].angle) == Approx(degrees(std::atan2(legs.x, legs.y))).margin(0.01));
    }
}

TEST_CASE("a fillet is measured on its own surface, also where the plates' backs are nearer", "[gauge]") {
    const WeldOutline thin{{-1, 14}, {-1, -1}, {14, -1}, {14, 0}, {5, 0}, {0, 5}, {0, 14}};
    WeldOutline outline;
    for (const glm::dvec2 p : thin)
        outline.push_back(kMm * p);
    const auto fillet = measureFillet(outline, {}, kMm);
    REQUIRE(fillet);
    CHECK(fillet->throat == Approx(5 * kMm / std::numbers::sqrt2));
    CHECK(fillet->toes[0].place == Approx(5 * kMm).epsilon(1e-3));
    CHECK_FALSE(measureFillet(teeWith({{0, 0}}), {}, 0)); // an exact corner without weld
    // The surface is nearest to the corner close to a plate: a bead on the base plate.
    const auto low = measureFillet(teeWith({{3.6, 0}, {2.6, 1.4}, {1.4, 2.2}, {0.5, 2.3}, {0, 3.1}}), {}, kMm);
    REQUIRE(low);
    CHECK(low->throat == Approx(kMm * std::hypot(0.5, 2.3)).epsilon(0.02));
    CHECK(low->toes[0].place / kMm == Approx(3.6).margin(0.6));
    CHECK(low->toes[1].place / kMm == Approx(2.8).margin(0.6));
}

TEST_CASE("a convex fillet's throat and angles are those of its arc", "[gauge]") {
    constexpr double kRadius = 8, kLeg = 5, kChord = kLeg * std::numbers::sqrt2;
    const double half = std::asin(0.5 * kChord / kRadius), depth = kRadius * std::cos(half) - 0.5 * kChord;
    const glm::dvec2 centre(-depth / std::numbers::sqrt2);
    WeldOutline arc;
    for (int i = 0; i <= 2000; ++i) {
        const double at = kPi / 4 - half + 2 * half * i / 2000;
        arc.push_back(centre + kRadius * glm::dvec2(std::cos(at), std::sin(at)));
    }
    const auto fillet = measureFillet(teeWith(arc), {}, 0);
    REQUIRE(fillet);
    CHECK(fillet->throat == Approx(kMm * (kRadius - depth)).epsilon(1e-4));
    for (const WeldToe& toe : fillet->toes) {
        CHECK(toe.place == Approx(kMm * kLeg).epsilon(0.003));
        CHECK(degrees(toe.angle) == Approx(45 + degrees(half)).margin(1));
    }
}

TEST_CASE("particles measure a fillet to a part of their spacing; a bare corner has none", "[gauge]") {
    for (const double spacing : {1.0, 0.5}) {
        for (const glm::dvec2 legs : {glm::dvec2(3, 3), glm::dvec2(5, 5), glm::dvec2(7, 4.5)}) {
            INFO(legs.x << " and " << legs.y << " mm, particles of " << spacing << " mm");
            const auto metal =
                settled(spacing, legs.y, [&](double y) { return glm::dvec2(0, legs.x * (1 - y / legs.y)); });
            const auto fillet = measureFillet(ofParticles(spacing, inTee, metal), {}, kMm * spacing);
            REQUIRE(fillet);
            CHECK(fillet->throat / kMm == Approx(legs.x * legs.y / glm::length(legs)).margin(0.1 * spacing));
            const bool small = legs.y < 4 * spacing;
            const double most = (small ? 0.35 : 0.2) * spacing, mostAngle = small ? 14 : 6;
            CHECK(fillet->toes[0].place / kMm == Approx(legs.x).margin(most));
            CHECK(fillet->toes[1].place / kMm == Approx(legs.y).margin(most));
            CHECK(degrees(fillet->toes[0].angle) == Approx(degrees(std::atan2(legs.y, legs.x))).margin(mostAngle));
            CHECK(degrees(fillet->toes[1].angle) == Approx(degrees(std::atan2(legs.x, legs.y))).margin(mostAngle));
        }
        CHECK_FALSE(measureFillet(ofParticles(spacing, inTee, {{}}), {}, kMm * spacing));
    }
    CHECK_FALSE(measureFillet({}, {}, kMm));
}

TEST_CASE("convexity is the surface's height over the line from toe to toe", "[gauge]") {
    constexpr double kRadius = 8, kLeg = 6, kChord = kLeg * std::numbers::sqrt2;
    const double half = std::asin(0.5 * kChord / kRadius), rise = kRadius * (1 - std::cos(half));
    const glm::dvec2 centre(-(kRadius * std::cos(half) - 0.5 * kChord) / std::numbers::sqrt2);
    const auto arc = [&](double sign) { // bulging or hollow
        WeldOutline made;
        for (int i = 0; i <= 2000; ++i) {
            const double at = kPi / 4 - half + 2 * half * i / 2000;
            const glm::dvec2 place = centre + kRadius * glm::dvec2(std::cos(at), std::sin(at));
            made.push_back(sign > 0 ? place : glm::dvec2(kLeg - place.y, kLeg - place.x));
        }
        return made;
    };
    const auto bulging = measureFillet(teeWith(arc(1)), {}, 0);
    REQUIRE(bulging);
    CHECK(bulging->convexity == Approx(kMm * rise).epsilon(0.02));
    CHECK(bulging->faceWidth() == Approx(kMm * kChord).epsilon(0.003));
    CHECK(bulging->legDifference() == Approx(0).margin(1e-6));
    const auto hollow = measureFillet(teeWith(arc(-1)), {}, 0);
    REQUIRE(hollow);
    CHECK(hollow->convexity == 0);
    const auto flat = measureFillet(teeWith({{7, 0}, {0, 4}}), {}, 0);
    REQUIRE(flat);
    CHECK(flat->convexity == Approx(0).margin(1e-8));
    CHECK(flat->legDifference() == Approx(3 * kMm));
    for (const double spacing : {1.0, 0.5}) {
        INFO("particles of " << spacing << " mm");
        const auto metal = settled(spacing, kLeg, [&](double y) {
            return glm::dvec2(0, centre.x + std::sqrt(kRadius * kRadius - (y - centre.y) * (y - centre.y)));
        });
        const auto fillet = measureFillet(ofParticles(spacing, inTee, metal), {}, kMm * spacing);
        REQUIRE(fillet);
        CHECK(fillet->convexity / kMm == Approx(rise).margin(0.5 * spacing));
    }
}

TEST_CASE("undercut is the depth of the groove beside each toe, on plates and in corners", "[gauge]") {
    const Segment exact{60 * kPi / 180, 5};
    WeldOutline grooved{{exact.halfWidth() + 1.2, 0}, {exact.halfWidth() + 0.6, -0.8}};
    for (const glm::dvec2 place : exact.line())
        grooved.push_back(place);
    const FaceStretch toes{-kMm * exact.halfWidth(), kMm * exact.halfWidth()};
    const auto drawn = undercutBeside(plateWith(grooved), {}, toes, 0);
    CHECK(drawn[0] == 0);
    CHECK(*drawn[1] == Approx(0.8 * kMm).epsilon(0.05));
    CHECK(undercutBeside(plateWith(exact.line()), {}, toes, 0) == std::array<std::optional<double>, 2>{0, 0});
    for (const double spacing : {1.0, 0.5}) {
        INFO("particles of " << spacing << " mm");
        // The grooves are 2 mm wide and 1 mm deep, behind the low toe of a bead and over a fillet.
        const auto plate = [](glm::dvec2 p) { return inPlate(p) && !(p.x > -6 && p.x < -4 && p.y > -1); };
        const auto bead = settled(spacing, 2, [](double) { return glm::dvec2(-4, 4); });
        const auto beside =
            undercutBeside(ofParticles(spacing, plate, bead), {}, FaceStretch{-4 * kMm, 4 * kMm}, kMm * spacing);
        CHECK(*beside[0] / kMm == Approx(1).margin(0.5 * spacing));
        CHECK(*beside[1] / kMm == Approx(0).margin(0.01));
        const auto tee = [](glm::dvec2 p) { return inTee(p) && !(p.y > 5 && p.y < 7 && p.x > -1); };
        const auto metal = settled(spacing, 5, [](double y) { return glm::dvec2(0, 5 - y); });
        const WeldOutline outline = ofParticles(spacing, tee, metal);
        const auto fillet = measureFillet(outline, {}, kMm * spacing);
        REQUIRE(fillet);
        const auto over = undercutBeside(outline, {}, *fillet, kMm * spacing);
        CHECK(*over[0] / kMm == Approx(0).margin(0.01));
        CHECK(*over[1] / kMm == Approx(1).margin(0.5 * spacing));
    }
}

TEST_CASE("a groove is as deep as the surface lies under the face, and no plate's end is one", "[gauge]") {
    const WeldOutline sunk = plateWith({{3, 0}, {1, -1.5}, {-1, -1.5}, {-3, 0}});
    CHECK(*grooveDepth(sunk, {}, {-2 * kMm, 2 * kMm}, 0) == Approx(1.5 * kMm));
    CHECK(grooveDepth(sunk, {}, {4 * kMm, 9 * kMm}, 0) == 0);
    CHECK(grooveDepth(sunk, {}, {18 * kMm, 40 * kMm}, kMm) == 0); // beyond the plate's end at 20 mm
    const PlateFace under{{0, -6 * kMm}, {-1, 0}, {0, -1}};
    CHECK(*grooveDepth(sunk, under, {-4 * kMm, 4 * kMm}, 0) == Approx(0).margin(1e-9));
    CHECK_FALSE(grooveDepth({}, {}, {-1, 1}, 0));
    CHECK_FALSE(grooveDepth(sunk, {}, {19 * kMm, 40 * kMm}, kMm)); // only the rounded edge is there
}
