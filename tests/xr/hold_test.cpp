// Tests the direction of a tool in the hand.
#include "tests/support/catch.hpp"
#include "xr/hold.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

/// Pose of an aim that leans up by `degrees` from the grip.
xr::Pose aimOver(const xr::Pose& grip, float degrees) {
    return grip * xr::Pose{glm::angleAxis(glm::radians(degrees), glm::vec3(1, 0, 0)), {0, 0.01f, -0.04f}};
}

float between(const glm::vec3& a, const glm::vec3& b) {
    return glm::degrees(std::acos(std::min(1.0f, glm::dot(glm::normalize(a), glm::normalize(b)))));
}

} // namespace

TEST_CASE("a tool follows the grip, and the aim of a controller whose grip leans by more than 30 degrees") {
    const xr::Pose grip{glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3))), {0.2f, 1.1f, -0.4f}};
    for (const float lean : {-29.0f, 0.0f, 29.0f}) {
        CHECK_FALSE(xr::holdsByAim(grip, aimOver(grip, lean)));
        const glm::quat held = grip.orientation * xr::holdRotation(grip, aimOver(grip, lean));
        CHECK(between(held * glm::vec3(0, 0, -1), grip.forward()) < 0.1f);
    }
    for (const float lean : {-60.0f, 31.0f, 45.0f, 60.0f}) {
        const xr::Pose aim = aimOver(grip, lean);
        CHECK(xr::holdsByAim(grip, aim));
        const glm::quat held = grip.orientation * xr::holdRotation(grip, aim);
        CHECK(between(held * glm::vec3(0, 0, -1), aim.forward()) < 0.1f);
        CHECK(between(held * glm::vec3(0, 1, 0), aim.orientation * glm::vec3(0, 1, 0)) < 0.1f);
    }
}

TEST_CASE("a turn around the grip's own axis alone keeps the grip") {
    const xr::Pose grip{glm::angleAxis(0.3f, glm::vec3(0, 1, 0)), {0, 1, 0}};
    const xr::Pose rolled = grip * xr::Pose{glm::angleAxis(1.5f, glm::vec3(0, 0, 1)), {}};
    CHECK_FALSE(xr::holdsByAim(grip, rolled));
}
