#include "core/render/effects/flight.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kSoonest = 1e-5F; // s: a drop that is born on a face does not land there at once

/// Returns the ages at which height + speed t + gravity t²/2 is 0, the sooner first; negative or not a number: none.
std::array<float, 2> crossings(float height, float speed, float gravity) {
    if (std::abs(gravity) < 1e-6F) return {-height / speed, -1};
    const float root = std::sqrt(speed * speed - 2 * gravity * height);
    const float a = (-speed - root) / gravity, b = (-speed + root) / gravity;
    return a < b ? std::array{a, b} : std::array{b, a};
}

bool within(const WorkpieceBlock& block, const glm::vec3& place, int except) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != except && (place[axis] < block.low[axis] || place[axis] > block.high[axis])) return false;
    return true;
}

/// Finds the first time that the flight comes from outside through a face of the block.
void landOn(const WorkpieceBlock& block, const Flight& flight, std::optional<Landing>& first) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            const float face = side > 0 ? block.high[axis] : block.low[axis];
            for (const float age : crossings(flight.from[axis] - face, flight.velocity[axis], flight.gravity[axis])) {
                if (!(age > kSoonest) || (first && age >= first->age)) continue;
                if (flight.velocityAt(age)[axis] * side >= 0 || !within(block, flight.at(age), axis)) continue;
                glm::vec3 normal(0);
                normal[axis] = side;
                first = Landing{age, normal, false};
            }
        }
}

} // namespace

std::optional<Landing> landingOf(const Flight& flight, const SpatterGround& ground) {
    std::optional<Landing> first;
    for (const WorkpieceBlock& block : ground.blocks)
        landOn(block, flight, first);
    const float height = glm::dot(flight.from, ground.up) - ground.table;
    for (const float age : crossings(height, glm::dot(flight.velocity, ground.up), glm::dot(flight.gravity, ground.up)))
        if (age > kSoonest && (!first || age < first->age) && glm::dot(flight.velocityAt(age), ground.up) < 0)
            first = Landing{age, ground.up, true};
    return first;
}

} // namespace meltpool
