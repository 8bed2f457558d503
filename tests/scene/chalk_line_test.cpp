// The soapstone line: it reaches from end to end, with a mark across either end, and a weld wipes it off.
#include "core/scene/chalk_line.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

struct Extent {
    glm::vec3 low{1}, high{-1};
};

Extent extentOf(const ChalkLine& chalk) {
    Extent extent;
    for (const Solid& stroke : chalk.solids())
        for (const float x : {-0.5F, 0.5F})
            for (const float z : {-0.5F, 0.5F}) {
                const glm::vec3 corner(stroke.toWorld * glm::vec4(x, 0.5F, z, 1));
                extent.low = glm::min(extent.low, corner);
                extent.high = glm::max(extent.high, corner);
            }
    return extent;
}

} // namespace

TEST_CASE("a soapstone line lies on the face from end to end, marked across either end", "[scene]") {
    const ChalkLine chalk({{-0.036F, 0, 0.001F}, {0.036F, 0, 0.001F}});
    const Extent all = extentOf(chalk);
    CHECK(all.low.x == Approx(-0.036F).margin(1e-3));
    CHECK(all.high.x == Approx(0.036F).margin(1e-3));
    CHECK(all.high.y > 0);
    CHECK(all.high.y < 1e-3F);
    CHECK(all.high.z - all.low.z == Approx(0.016F).margin(1e-4));
    CHECK((all.high.z + all.low.z) / 2 == Approx(0.001F).margin(1e-5));
}

TEST_CASE("a weld wipes the line off where it went; the marks beside it stay", "[scene]") {
    ChalkLine chalk({{-0.036F, 0, 0}, {0.036F, 0, 0}});
    const size_t all = chalk.solids().size();
    chalk.wipe([](double from, double to) { return from < 0.03 && to > 0.02; });
    CHECK(chalk.solids().size() < all);
    CHECK(chalk.solids().size() >= all - 6);
    for (const Solid& stroke : chalk.solids())
        CHECK(std::abs(stroke.toWorld[3].x + 0.011F) > 3e-3F);
    chalk.wipe([](double, double) { return true; });
    CHECK(chalk.solids().size() == 7); // beside the ends, and the arrow
    chalk.wipe([](double, double) { return false; });
    CHECK(chalk.solids().size() == all);
    CHECK(ChalkLine({{0, 0, 0}, {0, 0, 0}}).solids().empty());
}

TEST_CASE("the line's arrow points from its first end to its last, on the welder's side", "[scene]") {
    for (const float side : {-1.0F, 1.0F}) {
        ChalkLine chalk({{0.036F, 0, 0}, {-0.036F, 0, 0}, {0, 1, 0}, {0, 0, side}});
        chalk.wipe([](double, double) { return true; });
        REQUIRE(chalk.solids().size() == 7);
        const Solid& shaft = chalk.solids()[4];
        CHECK(glm::normalize(glm::vec3(shaft.toWorld[0])).x == Approx(-1));
        CHECK(shaft.toWorld[3].z == Approx(side * 0.0055F));
        CHECK(shaft.toWorld[3].x < 0.036F);
    }
}
