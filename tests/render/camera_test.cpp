// Cameras: their places and directions, no roll or turning over, and the projection of their views.
#include "core/render/camera.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace meltpool {

namespace {

constexpr float kQuarter = 1.57079632679f;

bool near3(const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(a, b) < 1e-5f;
}

/// Returns the place of a world point in the picture, -1..1.
glm::vec3 projected(const View& view, const glm::vec3& point) {
    const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(point, 1.0f);
    return glm::vec3(clip) / clip.w;
}

} // namespace

TEST_CASE("the free camera starts looking where it was told and moves along its own axes") {
    FreeCamera camera({1, 2, 3}, {1, 2, -5});
    CHECK(near3(camera.forward(), {0, 0, -1}));
    camera.move({0.5f, 0, 0});
    CHECK(near3(camera.position(), {1.5f, 2, 3}));
    camera.move({0, 0.25f, 2});
    CHECK(near3(camera.position(), {1.5f, 2.25f, 1}));
    camera.look({kQuarter, 0});
    CHECK(near3(camera.forward(), {1, 0, 0}));
    CHECK(near3(camera.right(), {0, 0, 1}));
    camera.move({0, 0, 1});
    CHECK(near3(camera.position(), {2.5f, 2.25f, 1}));
    const FreeCamera aimed({2, 3, 4}, {-1, 0.5f, 1});
    CHECK(near3(aimed.forward(), glm::normalize(glm::vec3(-3, -2.5f, -3))));
}

TEST_CASE("the free camera neither rolls nor turns over") {
    FreeCamera camera;
    for (int i = 0; i < 1000; ++i) {
        camera.look({0.37f, i % 200 < 100 ? 0.2f : -0.2f});
        CHECK(std::abs(camera.pitch()) < kQuarter);
        CHECK(std::abs(camera.right().y) < 1e-5f);
        CHECK((camera.orientation() * glm::vec3(0, 1, 0)).y > 0.0f);
    }
    camera.look({0, 100});
    CHECK(camera.pitch() == Approx(kQuarter - kPoleMargin));
    camera.look({0, -200});
    CHECK(camera.pitch() == Approx(-kQuarter + kPoleMargin));
}

TEST_CASE("the orbit camera looks at the origin from its sphere") {
    OrbitCamera camera(0, 0, 3);
    CHECK(near3(camera.position(), {0, 0, 3}));
    camera.orbit({kQuarter, 0});
    CHECK(near3(camera.position(), {3, 0, 0}));
    camera.orbit({0, 0.5f});
    CHECK(camera.position().y == Approx(3 * std::sin(0.5f)));
    for (int i = 0; i < 300; ++i) {
        camera.orbit({0.21f, i < 150 ? 0.1f : -0.1f});
        CHECK(near3(camera.forward(), -glm::normalize(camera.position())));
        CHECK(std::abs(camera.right().y) < 1e-5f);
        CHECK(std::abs(camera.elevation()) < kQuarter);
    }
    camera.approach(0.5f);
    CHECK(glm::length(camera.position()) == Approx(1.5f));
    camera.approach(1e-6f);
    CHECK(camera.distance() == OrbitCamera::kNearest);
    camera.approach(1e6f);
    CHECK(camera.distance() == OrbitCamera::kFarthest);
}

TEST_CASE("a view puts what is ahead into the middle and what is right to the right") {
    const OrbitCamera camera(0.8f, 0.3f, 2.5f);
    const Lens lens;
    const View view = camera.view(lens, 1.5f);
    CHECK(near3(view.eye, camera.position()));
    CHECK(std::abs(projected(view, {0, 0, 0}).x) < 1e-5f);
    CHECK(std::abs(projected(view, {0, 0, 0}).y) < 1e-5f);
    CHECK(projected(view, camera.right() * 0.1f).x > 0.0f);
    CHECK(projected(view, {0, 0.1f, 0}).y > 0.0f);
    // Half the field of view upwards is the picture's upper border.
    const glm::vec3 up = camera.orientation() * glm::vec3(0, 1, 0);
    const glm::vec3 border = up * (2.5f * std::tan(0.5f * lens.fieldOfView));
    CHECK(projected(view, border).y == Approx(1.0f).margin(1e-4));
}

} // namespace meltpool
