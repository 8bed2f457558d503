// The throw of a drop against small steps of the motion, and the surface that it hits.
#include "core/render/effects/flight.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <array>

namespace meltpool {

TEST_CASE("a drop flies as Newton's law says, whatever the direction of gravity", "[effects]") {
    const Flight flight{{0.01F, 0.02F, -0.01F}, {1.5F, 2.0F, -0.5F}, {3.0F, -9.0F, 1.0F}};
    glm::dvec3 place = flight.from, velocity = flight.velocity;
    constexpr int kSteps = 100000;
    constexpr double kSeconds = 0.3, kStep = kSeconds / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        velocity += glm::dvec3(flight.gravity) * kStep;
        place += velocity * kStep;
    }
    CHECK(glm::distance(glm::dvec3(flight.at(float(kSeconds))), place) < 1e-5);
    CHECK(glm::distance(glm::dvec3(flight.velocityAt(float(kSeconds))), velocity) < 1e-4);
    CHECK(flight.at(0) == flight.from);
}

TEST_CASE("a drop lands on the plate, beside it on the table, and against an upright plate", "[effects]") {
    const std::array<WorkpieceBlock, 2> tee{
        WorkpieceBlock{{-0.05F, -0.006F, -0.025F}, {0.05F, 0, 0.025F}}, // base plate
        WorkpieceBlock{{-0.05F, 0, -0.006F}, {0.05F, 0.025F, -1e-4F}}}; // upright plate behind
    const SpatterGround ground{tee, {0, 1, 0}, -0.012F};
    const auto thrown = [&](glm::vec3 velocity) {
        return landingOf({{0, 0.002F, 0.003F}, velocity, {0, -9.81F, 0}}, ground);
    };
    // Up and down again: y = 2 mm + v t - g t²/2 is 0.
    const auto plate = thrown({0, 0.3F, 0.05F});
    REQUIRE(plate);
    CHECK(double(plate->age) == Approx((0.3 + std::sqrt(0.09 + 2 * 9.81 * 0.002)) / 9.81).epsilon(1e-4));
    CHECK(plate->normal == glm::vec3(0, 1, 0));
    CHECK_FALSE(plate->onTable);
    const auto table = thrown({0, 0.5F, 1});
    REQUIRE(table);
    CHECK(table->onTable);
    CHECK(double(table->age) == Approx((0.5 + std::sqrt(0.25 + 2 * 9.81 * 0.014)) / 9.81).epsilon(1e-4));
    const auto wall = thrown({0.1F, 0.4F, -1});
    REQUIRE(wall);
    CHECK(wall->normal == glm::vec3(0, 0, 1));
    CHECK(double(wall->age) == Approx(3.1e-3).epsilon(1e-3));
    // The drop flies over the upright plate.
    const auto over = thrown({0, 3, -0.2F});
    REQUIRE(over);
    CHECK(over->onTable);
}

TEST_CASE("upside down a drop falls away from the plate", "[effects]") {
    const std::array<WorkpieceBlock, 1> plate{WorkpieceBlock{{-0.05F, -0.006F, -0.025F}, {0.05F, 0, 0.025F}}};
    const SpatterGround ground{plate, {0, -1, 0}, -0.3F};
    const auto landing = landingOf({{0, 0.002F, 0}, {0.2F, 0.1F, 0}, {0, 9.81F, 0}}, ground);
    REQUIRE(landing);
    CHECK(landing->onTable);
    CHECK(landing->normal == glm::vec3(0, -1, 0));
}

} // namespace meltpool
