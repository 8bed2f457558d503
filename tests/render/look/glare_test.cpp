// The veil of an arc in the eye: the CIE law at several angles, with a filter, in every scale, and no veil where the
// torch hides the arc.
#include "core/render/look/heat_colours.hpp"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kFar = 0.4; ///< distance from the eye to the arc, model units

/// Returns the light that the eye receives at this angle (degrees) from an arc of this intensity in front of nothing.
double lightBeside(Renderer& renderer, double angle, double intensity, LookParameters look, float scale = 1,
                   std::span<const Solid> solids = {}, double far = kFar, std::span<const Solid> hands = {}) {
    SceneView scene;
    scene.modelToWorld = glm::scale(glm::mat4(1), glm::vec3(scale));
    scene.arc = {{0, 0, 0}, glm::vec3(float(intensity)), 1e-3f};
    scene.solids = solids;
    scene.fittings = scene.hands = hands;
    const double rad = angle * std::numbers::pi / 180;
    const glm::vec3 eye(0, 0, float(far) * scale);
    const glm::vec3 target = eye + scale * glm::vec3(float(std::sin(rad)), 0, float(-std::cos(rad)));
    return double(test::lightOf(renderer, scene, look, eye, target).g);
}

/// Returns that light less the picture's clear colour.
double veilBeside(Renderer& renderer, double angle, double intensity, const LookParameters& look, float scale = 1,
                  std::span<const Solid> solids = {}, double far = kFar, std::span<const Solid> hands = {}) {
    const double empty = lightBeside(renderer, angle, 0, look, scale, solids, far, hands);
    const double seen = lightBeside(renderer, angle, intensity, look, scale, solids, far, hands);
    return (seen - empty) / (1 - empty);
}

} // namespace

TEST_CASE("an arc's glare follows the CIE law of veiling luminance") {
    Renderer& renderer = test::patchRenderer();
    const LookParameters look = test::roomOnly(0);
    const double illuminance = 0.04; // illuminance at the eye: 0.4 of paper white at one degree
    for (const double degrees : {1.0, 2.0, 5.0, 10.0}) {
        INFO(degrees << " degrees beside the arc");
        const double law = illuminance * 10 * (1 + std::pow(25.0 / 70, 4)) / (degrees * degrees);
        CHECK(veilBeside(renderer, degrees, illuminance * kFar * kFar, look) == Approx(law).epsilon(0.05));
        CHECK(veilBeside(renderer, degrees, illuminance * kFar * kFar, look, 25) == Approx(law).epsilon(0.05));
    }
    // A camera closer than a welder's eye sees the veil of that eye's distance.
    CHECK(veilBeside(renderer, 2, illuminance * kFar * kFar, look, 1, {}, 0.1) ==
          Approx(illuminance * kFar * kFar / (0.35 * 0.35) * 10.163 / 4).epsilon(0.05));
    CHECK(veilBeside(renderer, 20, illuminance / 20 * kFar * kFar, look) == 0); // too faint to see
    LookParameters filtered = look;
    filtered.visorShade = 9;
    const double through = veilBeside(renderer, 2, illuminance * kFar * kFar / double(filterShare(9)), filtered);
    CHECK(through == Approx(1.1 * illuminance * 10.163 / 4).epsilon(0.05)); // the filter's green
}

TEST_CASE("an arc that the torch hides does not glare") {
    Renderer& renderer = test::patchRenderer();
    const LookParameters look = test::roomOnly(0);
    Solid bar;
    bar.shape = SolidShape::cylinder;
    bar.toWorld = alongLine({0, -0.3f, 0.2f}, {0, 0.3f, 0.2f}, 0.01f);
    CHECK(veilBeside(renderer, 3, 0.04 * kFar * kFar, look) > 0.03);
    CHECK(veilBeside(renderer, 3, 0.04 * kFar * kFar, look, 1, {&bar, 1}) == 0);
    bar.toWorld = alongLine({0.1f, -0.3f, 0.2f}, {0.1f, 0.3f, 0.2f}, 0.01f);
    CHECK(veilBeside(renderer, 3, 0.04 * kFar * kFar, look, 1, {&bar, 1}) > 0.03);
}

TEST_CASE("an arc behind the person's own forearm does not glare, and one beside it does") {
    Renderer& renderer = test::patchRenderer();
    const LookParameters look = test::roomOnly(0);
    Solid forearm;
    forearm.shape = SolidShape::pill;
    const auto veilPast = [&](float x) {
        forearm.toWorld = alongLine({x, -0.3f, 0.2f}, {x, 0.3f, 0.2f}, 0.01f);
        return veilBeside(renderer, 3, 0.04 * kFar * kFar, look, 1, {}, kFar, {&forearm, 1});
    };
    CHECK(veilPast(0) == Approx(0).margin(1e-6));
    CHECK(veilPast(0.1f) > 0.03);
    CHECK(veilPast(0.005f) == Approx(0.5 * veilPast(0.1f)).epsilon(0.05)); // half of the arc's disc
}

} // namespace meltpool
