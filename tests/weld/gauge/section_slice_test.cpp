// Zones of one slice against fields with known zones, to a small part of a cell.
#include "core/weld/gauge/section_slice.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>

using namespace meltpool;

namespace {

constexpr std::array<glm::ivec2, 2> kUpAndOut{{{0, 1}, {1, 0}}};
constexpr double kPi = 3.14159265358979;

/// A region of a grid of 40 x 30 cells: places in cells from the edge between columns 19 and 20 and the top of row 19.
using Held = std::function<bool(glm::dvec2)>;
using Field = std::function<double(glm::dvec2)>;

SectionSlice sliceOf(const Held& held, const Field& peak) {
    SectionSlice slice({40, 30});
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const glm::dvec2 place(x + 0.5 - 20, y + 0.5 - 20);
            if (held(place)) slice.setPeak({x, y}, peak(place));
        }
    return slice;
}

/// A strip of cells at the side of a zone counts by its middle; the rest of the zone's extent is invisible. The extent
/// is less than a cell at each side.
constexpr double kStripEnd = 0.9;

/// Mean of ratios: the strips' error has no sign and vanishes in the mean over zones.
struct MeanRatio {
    void add(double measured, double exact) {
        sum += measured / exact;
        ++count;
    }
    double mean() const { return sum / count; }

    double sum = 0;
    int count = 0;
};

bool plate(glm::dvec2 p) {
    return p.y < 0;
}

bool tee(glm::dvec2 p) {
    return p.y < 0 || (p.x < 0 && p.x > -6);
}

/// Returns a field that falls by 100 K a cell with the distance from the seam; the zone above 1800 K has the given
/// radius.
Field coneOf(double radius) {
    return [radius](glm::dvec2 p) { return 1800 + 100 * (radius - glm::length(p)); };
}

} // namespace

TEST_CASE("the zone of a plate is measured to a small part of a cell", "[gauge]") {
    MeanRatio area;
    for (double radius = 2; radius < 8; radius += 0.13) {
        INFO(radius);
        const SliceZone zone = measureZone(sliceOf(plate, coneOf(radius)), std::span(kUpAndOut).first(1), 1800);
        const double besideSeam = std::sqrt(radius * radius - 0.25); // half a cell down, or half a cell from the seam
        CHECK(zone.width == Approx(2 * besideSeam).margin(0.03));
        CHECK(zone.depth == Approx(besideSeam).margin(0.03));
        CHECK(zone.area == Approx(0.5 * kPi * radius * radius).margin(2 * kStripEnd));
        area.add(zone.area, 0.5 * kPi * radius * radius);
        CHECK(zone.high.x - zone.low.x ==
              Approx(2 * besideSeam).margin(0.35)); // barely warm cells at the face count whole
        CHECK(zone.high.y == 20);
        CHECK(zone.low.y == Approx(20 - zone.depth));
    }
    CHECK(area.mean() == Approx(1).epsilon(0.015));
}

TEST_CASE("the zone of a tee's corner is measured from both plates' surfaces", "[gauge]") {
    MeanRatio area;
    for (double radius = 2; radius < 5.5; radius += 0.13) {
        INFO(radius);
        const SliceZone zone = measureZone(sliceOf(tee, coneOf(radius)), kUpAndOut, 1800);
        const double leg = std::sqrt(radius * radius - 0.25); // half a cell from the other plate's face
        CHECK(zone.width == Approx(2 * radius).margin(0.35)); // at the faces, beyond the cells' resolution
        CHECK(zone.depth == Approx(radius).margin(0.06));     // under the joint line, far from both surfaces
        CHECK(zone.area == Approx(0.75 * kPi * radius * radius).margin(2 * kStripEnd));
        area.add(zone.area, 0.75 * kPi * radius * radius);
        CHECK(zone.high.y == Approx(20 + leg).margin(0.2));
        CHECK(zone.low.y == Approx(20 - leg).margin(0.2));
    }
    CHECK(area.mean() == Approx(1).epsilon(0.015));
}

TEST_CASE("molten metal that has gone leaves the edges of the zone where they were", "[gauge]") {
    for (double radius = 2; radius < 8; radius += 0.13) {
        INFO(radius);
        const Field cone = coneOf(radius);
        const auto gone = [&](glm::dvec2 p) { return cone(p) >= 1800 ? SectionSlice::kGone : cone(p); };
        const auto sides = std::span(kUpAndOut).first(1);
        const SliceZone full = measureZone(sliceOf(plate, cone), sides, 1800);
        const SliceZone left = measureZone(sliceOf(plate, gone), sides, 1800);
        CHECK(left.width == Approx(full.width).margin(0.15));
        CHECK(left.depth == Approx(full.depth).margin(0.15));
        CHECK(left.area == Approx(full.area).epsilon(0.07));
    }
}

TEST_CASE("a zone less deep than half a cell is found", "[gauge]") {
    // The field has 1800 K at `depth` under the face, 100 K less each cell down; it is 6 cells wide to each side.
    const auto layer = [](double depth) {
        return [depth](glm::dvec2 p) { return std::abs(p.x) < 6 ? 1800 + 100 * (depth + p.y) : 300; };
    };
    for (double depth = 0.03; depth < 2; depth += 0.05) {
        INFO(depth);
        const SectionSlice slice = sliceOf(plate, layer(depth));
        const SliceZone level = measureZone(slice, std::span(kUpAndOut).first(1), 1800);
        CHECK(level.depth == Approx(depth).margin(0.001));
        CHECK(level.area == Approx(depth < 0.5 ? 0 : 12 * depth).margin(0.01));
        CHECK(level.high.y == 20);
        const SliceZone corner = measureZone(slice, kUpAndOut, 1800);
        CHECK(corner.depth == Approx(depth).margin(0.001));
        CHECK(corner.area == Approx(12 * depth).margin(6));
        if (depth < 0.5) CHECK(corner.area == Approx(12 * depth).margin(0.01));
        CHECK(corner.width == Approx(12).margin(1));
    }
    CHECK(measureZone(sliceOf(plate, layer(-0.05)), kUpAndOut, 1800).depth == 0);
}

TEST_CASE("a joint's gap between two hot edges belongs to the width, beside one hot edge it does not", "[gauge]") {
    const auto butt = [](glm::dvec2 p) { return p.y < 0 && std::abs(p.x) > 1; };
    const auto sides = std::span(kUpAndOut).first(1);
    const SliceZone both = measureZone(sliceOf(butt, coneOf(5)), sides, 1800);
    CHECK(both.width == Approx(2 * std::sqrt(24.75)).margin(0.03));
    const Field oneHot = [](glm::dvec2 p) { return p.x > 0 ? coneOf(5)(p) : 300.0; };
    CHECK(measureZone(sliceOf(butt, oneHot), sides, 1800).width == Approx(std::sqrt(24.75) - 1).margin(0.03));
}

TEST_CASE("a plate that is molten through is as deep as it is thick", "[gauge]") {
    const auto thin = [](glm::dvec2 p) { return p.y < 0 && p.y > -4; };
    const SliceZone zone = measureZone(sliceOf(thin, coneOf(9)), std::span(kUpAndOut).first(1), 1800);
    CHECK(zone.depth == Approx(4));
    CHECK(zone.low.y == Approx(16));
}

TEST_CASE("a slice that is cold or empty has no zone", "[gauge]") {
    for (const SectionSlice& slice : {sliceOf(tee, [](glm::dvec2) { return 300.0; }), SectionSlice({8, 8})}) {
        const SliceZone zone = measureZone(slice, kUpAndOut, 1800);
        CHECK(zone.width == 0);
        CHECK(zone.depth == 0);
        CHECK(zone.area == 0);
        CHECK(zone.low.x > zone.high.x);
    }
}

TEST_CASE("the zone's middle is where the hot surface is", "[gauge]") {
    for (const double at : {-7.3, 0.2, 4.0}) {
        const Field aside = [at](glm::dvec2 p) { return coneOf(5)(p - glm::dvec2(at, 0)); };
        const SliceZone zone = measureZone(sliceOf(plate, aside), std::span(kUpAndOut).first(1), 1800);
        CHECK(zone.middle == Approx(20 + at).margin(0.03));
    }
}

TEST_CASE("an elliptic pool has its axes as width and depth, at two resolutions", "[gauge]") {
    // The half axes are 3.2 and 2.1 mm, in cells of 1 and of 0.5 mm.
    for (const double cells : {1.0, 2.0}) {
        const double a = 3.2 * cells, b = 2.1 * cells;
        const Field pool = [&](glm::dvec2 p) { return 1800 + 100 * b * (1 - std::hypot(p.x / a, p.y / b)); };
        const SliceZone zone = measureZone(sliceOf(plate, pool), std::span(kUpAndOut).first(1), 1800);
        CHECK(zone.width == Approx(2 * a * std::sqrt(1 - 0.25 / (b * b))).margin(0.05)); // depth of half a cell
        CHECK(zone.width / cells == Approx(6.4).margin(0.2 / cells));
        CHECK(zone.depth == Approx(b).margin(0.06));
        CHECK(zone.area == Approx(0.5 * kPi * a * b).epsilon(0.1 / cells));
    }
}

TEST_CASE("root fusion is the length along the joint that both plates are fused on", "[gauge]") {
    REQUIRE(jointCorner(sliceOf(tee, coneOf(3))) == glm::ivec2(20, 20));
    CHECK_FALSE(jointCorner(sliceOf(plate, coneOf(3))).has_value());
    for (double radius = 0.8; radius < 5.5; radius += 0.13) {
        INFO(radius);
        const Field cone = coneOf(radius);
        CHECK(rootFusion(sliceOf(tee, cone), {20, 20}, 1800) == Approx(std::sqrt(radius * radius - 0.25)).margin(0.1));
        const auto gone = [&](glm::dvec2 p) { return cone(p) >= 1800 ? SectionSlice::kGone : cone(p); };
        if (radius < 4) // with larger radii the upright plate has too few cells for a slope
            CHECK(rootFusion(sliceOf(tee, gone), {20, 20}, 1800) ==
                  Approx(std::sqrt(radius * radius - 0.25)).margin(0.2));
    }
    // A cold upright plate has no fusion, nor has a corner colder than the level.
    const Field lyingOnly = [](glm::dvec2 p) { return p.y > 0 ? 300.0 : coneOf(4)(p); };
    CHECK(rootFusion(sliceOf(tee, lyingOnly), {20, 20}, 1800) == 0);
    CHECK(rootFusion(sliceOf(tee, coneOf(-0.2)), {20, 20}, 1800) == 0);
    CHECK(rootFusion(sliceOf(tee, coneOf(30)), {20, 20}, 1800) == Approx(6)); // through the upright plate
}
