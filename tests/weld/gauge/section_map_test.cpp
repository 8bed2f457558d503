// The map of a cut: the places that it shows as metal.
#include "core/weld/gauge/section_map.hpp"
#include "tests/support/catch.hpp"

#include <functional>

namespace meltpool {

namespace {

constexpr float kSpacing = 1e-3F;
constexpr glm::ivec2 kCells{30, 16};

/// Returns a map with metal in the cells for which `holds` is true, two lattice layers thick.
SectionMap mapOf(const std::function<bool(int, int)>& holds, const std::function<bool(int, int)>& onLattice) {
    std::vector<MapParticle> particles;
    for (int layer = 0; layer < 2; ++layer)
        for (int y = 0; y < kCells.y; ++y)
            for (int x = 0; x < kCells.x; ++x)
                if (holds(x, y)) particles.push_back({kSpacing * (glm::vec2(x, y) + 0.5F), 300, 300, onLattice(x, y)});
    return makeSectionMap({0, 0}, kSpacing * glm::vec2(kCells), kSpacing, 2, particles);
}

const glm::vec4& at(const SectionMap& map, glm::vec2 cells) {
    const glm::ivec2 texel(cells * kSpacing / map.size * glm::vec2(map.texels));
    return map.sums[static_cast<size_t>(texel.y * map.texels.x + texel.x)];
}

bool plate(int x, int y) {
    return x >= 4 && x < 24 && y >= 5 && y < 11;
}

bool everywhere(int, int) {
    return true;
}

} // namespace

TEST_CASE("the square corners of a plate are metal, though weights round them", "[gauge]") {
    const SectionMap map = mapOf(plate, everywhere);
    for (const glm::vec2 corner : {glm::vec2(4.1F, 5.1F), {23.9F, 5.1F}, {4.1F, 10.9F}, {23.9F, 10.9F}}) {
        CHECK(at(map, corner).x < 0.5F);
        CHECK(at(map, corner).w == 1);
        CHECK(at(map, corner).y / at(map, corner).x == Approx(300));
    }
    for (const glm::vec2 beside : {glm::vec2(3.9F, 5.1F), {4.1F, 4.9F}, {12.5F, 10.9F}, {4.1F, 8.0F}, {12.5F, 8.0F}})
        CHECK(at(map, beside).w == 0);
}

TEST_CASE("steps of a bevel, inner corners and metal off the lattice are what the weights say", "[gauge]") {
    const SectionMap bevel = mapOf([](int x, int y) { return plate(x, y) && x - 4 >= y - 5; }, everywhere);
    for (int step = 1; step < 6; ++step)
        CHECK(at(bevel, {4.1F + static_cast<float>(step), 5.9F + static_cast<float>(step)}).w == 0);
    const SectionMap tee =
        mapOf([](int x, int y) { return plate(x, y) || (x >= 10 && x < 15 && y >= 11); }, everywhere);
    CHECK(at(tee, {10.1F, 10.9F}).w == 0);
    const SectionMap melted = mapOf(plate, [](int x, int y) { return x > 6 || y < 8; });
    CHECK(at(melted, {4.1F, 10.9F}).w == 0);
    CHECK(at(melted, {23.9F, 10.9F}).w == 1);
}

} // namespace meltpool
