// Sparks and smoke in pictures: their light in numbers against closed forms on the CPU.
#include "core/render/camera.hpp"
#include "core/render/effects/haze.hpp"
#include "core/render/look/heat_colours.hpp"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace meltpool {

namespace {

LookParameters effectsOnly() {
    LookParameters look = test::roomOnly(0);
    look.showSource = true;
    return look;
}

/// Returns the light of all pixels of a 64 x 64 picture from an eye 0.2 before the origin.
double allLight(const SceneView& scene, const LookParameters& look) {
    constexpr int kSize = 64;
    const View view = FreeCamera({0, 0, 0.2f}, {0, 0, 0}).view({}, 1);
    double sum = 0;
    for (const float light : test::lightOfPixels(test::patchRenderer(), scene, look, view, kSize))
        sum += double(light);
    return sum;
}

} // namespace

TEST_CASE("the light of smoke along a ray has a closed form, even smoke and smoke that thins out", "[effects]") {
    const double intensity = 8, scattering = 0.7, passing = 6e-3, nearest = 0.11, begin = 0.09, end = 0.13;
    for (const double reach : {1e9, 0.03}) {
        double sum = 0;
        constexpr int kParts = 200000;
        for (int i = 0; i < kParts; ++i) {
            const double at = begin + (i + 0.5) * (end - begin) / kParts - nearest,
                         square = at * at + passing * passing;
            const double thick = scattering * (1 - square / (reach * reach));
            sum += thick * intensity / (4 * 3.14159265358979 * square) * (end - begin) / kParts;
        }
        CHECK(hazeLight(intensity, scattering, passing, nearest, begin, end, reach) == Approx(sum).epsilon(1e-6));
    }
}

TEST_CASE("a picture's smoke is the closed form's, ends at the workpiece, and is switched off", "[effects]") {
    Renderer& renderer = test::patchRenderer();
    LookParameters look = effectsOnly();
    SceneView scene;
    constexpr double kFar = 0.2, kReach = 0.02, kScattering = 0.9;
    const double intensity = 5e-3;
    scene.arc = {{0, 0, 0}, glm::vec3(float(intensity)), 1e-3f};
    const auto veil = [&](double passing) {
        const double angle = std::asin(passing / kFar);
        const glm::vec3 eye(0, 0, float(kFar)),
            target = eye + glm::vec3(float(std::sin(angle)), 0, -float(std::cos(angle)));
        scene.effects.fume.scattering = 0;
        const double without = double(test::lightOf(renderer, scene, look, eye, target).g);
        scene.effects.fume.scattering = float(kScattering);
        const double with = double(test::lightOf(renderer, scene, look, eye, target).g);
        return (with - without) / (1 - without); // inverts the blending, with glare on top
    };
    for (const double passing : {3e-3, 8e-3, 15e-3}) {
        INFO(passing << " m beside the arc");
        const double nearest = std::sqrt(kFar * kFar - passing * passing),
                     half = std::sqrt(kReach * kReach - passing * passing);
        CHECK(veil(passing) ==
              Approx(hazeLight(intensity, kScattering, passing, nearest, nearest - half, nearest + half, kReach))
                  .epsilon(0.02));
        // A plate is 4 mm behind the arc.
        const std::array<WorkpieceBlock, 1> plate{WorkpieceBlock{{-0.1f, -0.1f, -0.024f}, {0.1f, 0.1f, -0.004f}}};
        scene.blocks = plate;
        const double meets = (kFar + 5e-3) / (nearest / kFar); // a shadow's box begins a millimetre below the face
        const double free = std::min(nearest + half, meets);
        CHECK(veil(passing) ==
              Approx(hazeLight(intensity, kScattering, passing, nearest, nearest - half, free, kReach)).epsilon(0.02));
        scene.blocks = {};
    }
    CHECK(veil(21e-3) == 0);
    look.fume = false;
    CHECK(veil(8e-3) == 0);
    look.fume = true;
    look.detail = kLowDetail;
    CHECK(veil(8e-3) == 0);
}

TEST_CASE("a spark has the light of its metal's temperature, and drawn out along its way no more of it", "[effects]") {
    Renderer& renderer = test::patchRenderer();
    const MaterialLooks looks;
    LookParameters look = effectsOnly();
    look.visorShade = 8;
    std::array<Spark, 1> sparks{Spark{{0, 0, 0}, 0.05f, {0, 0, 0}, 1760}};
    SceneView scene;
    scene.temperature = {293.15f, 2500, true, test::kPatchSolidus, test::kPatchLiquidus};
    scene.looks = &looks;
    scene.effects.sparks = sparks;
    const double seen = double(test::lightOf(renderer, scene, look, {0, 0, 0.2f}).g);
    const double glow = double(looks.scaledEmissivity) * double(blackBodyLight(1760).g) * double(filterShare(8)) * 1.1;
    CHECK(seen == Approx(glow).epsilon(0.03));
    look.spatter = false;
    CHECK(double(test::lightOf(renderer, scene, look, {0, 0, 0.2f}).g) < 0.3 * glow);
    look.spatter = true;
    // Small, at rest, drawn out, or smaller than a pixel: the picture contains all of the light, however it spreads.
    sparks[0].radius = 6e-3f;
    const double empty = [&] {
        SceneView nothing = scene;
        nothing.effects = {};
        return allLight(nothing, look);
    }();
    const double still = allLight(scene, look) - empty;
    sparks[0].way = {0.05f, 0.03f, 0};
    const double flies = allLight(scene, look) - empty;
    CHECK(flies == Approx(still).epsilon(0.15));
    sparks[0].way = {};
    sparks[0].radius = 0.4e-3f;
    CHECK(allLight(scene, look) - empty == Approx(still / 225).epsilon(0.4));
}

TEST_CASE("beads on the table are drawn where there is one", "[effects]") {
    const MaterialLooks looks;
    const LookParameters look = effectsOnly();
    const std::array<Spark, 2> sparks{Spark{{0, 0.02f, 0}, 4e-3f, {0, 0, 0}, 1800},
                                      Spark{{0, -0.02f, 0}, 4e-3f, {0, 0, 0}, 1800}};
    SceneView scene;
    scene.temperature = {293.15f, 2500, true, test::kPatchSolidus, test::kPatchLiquidus};
    scene.looks = &looks;
    const double none = allLight(scene, look);
    scene.effects.sparks = sparks;
    scene.effects.onTable = 1;
    const double one = allLight(scene, look) - none;
    scene.tableShown = true;
    CHECK(one > 1);
    CHECK(allLight(scene, look) - none == Approx(2 * one).epsilon(0.05));
}

} // namespace meltpool
