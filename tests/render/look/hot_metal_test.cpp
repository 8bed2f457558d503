// Hot metal: its emission on both sides of its melting point, and its reflection of an even room and of an arc.
#include "core/render/look/heat_colours.hpp"
#include "core/render/look/mirror_shares.hpp"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

using glm::vec3;
using test::lightOf;
using test::Patch;
using test::roomOnly;

MaterialLooks steel() {
    MaterialLooks looks;
    looks.heatTint = 1;
    looks.liquidEmissivity = 0.35f;
    looks.cleanEmissivity = 0.45f;
    looks.scaledEmissivity = 0.85f;
    return looks;
}

/// Returns the green light of the patch alone; a picture without the patch gives the arc's veil over it.
double lightWithoutGlare(Renderer& renderer, const SceneView& scene, const LookParameters& look) {
    SceneView nothing = scene;
    nothing.mesh = {};
    SceneView dark = nothing;
    dark.arc = {};
    const double seen = double(lightOf(renderer, scene, look).g), cleared = double(lightOf(renderer, dark, look).g);
    const double veil = (double(lightOf(renderer, nothing, look).g) - cleared) / (1 - cleared);
    return (seen - veil) / (1 - veil);
}

} // namespace

TEST_CASE("through a visor metal gives out its emissivity's share of a black body's light on both sides of melting") {
    Renderer& renderer = test::patchRenderer();
    MaterialLooks looks = steel();
    LookParameters look = roomOnly(0);
    look.visorShade = 10;
    const auto check = [&](float temperature, float emissivity) {
        INFO(temperature << " K, emissivity " << emissivity);
        const vec3 seen = lightOf(renderer, Patch(temperature, temperature).scene(looks), look);
        const vec3 expected = emissivity * blackBodyLight(double(temperature)) * filterShare(look.visorShade) *
                              look.exposure * vec3(0.75f, 1.1f, 0.5f); // the filter's green
        for (int i = 0; i < 3; ++i)
            CHECK(double(seen[i]) == Approx(double(expected[i])).epsilon(0.01));
    };
    check(1500, 0.85f);
    check(1767, 0.85f);
    check(1813, 0.35f);
    check(2100, 0.35f);
    check(1790.5f,
          (1 - 0.15f * 1.25f + 0.35f) / 2); // half molten: half of the scale is that of frozen metal
    looks.heatTint = 0;                     // no scale
    check(1767, 0.45f);
    check(1813, 0.35f);
}

TEST_CASE("metal that has frozen is brighter than its pool, through a visor and without one") {
    Renderer& renderer = test::patchRenderer();
    const MaterialLooks looks = steel();
    for (const float shade : {0.0f, 10.0f}) {
        LookParameters look = roomOnly(0);
        look.visorShade = shade;
        const vec3 frozen = lightOf(renderer, Patch(1767, 2000).scene(looks), look),
                   pool = lightOf(renderer, Patch(1814, 2000).scene(looks), look);
        INFO("shade " << shade << ": frozen " << frozen.g << ", pool " << pool.g);
        // The frozen metal is colder and yet brighter: twice the emissivity against seven tenths of a black body's
        // light.
        CHECK(frozen.g > (shade > 0 ? 1.4f : 1.01f) * pool.g);
    }
}

TEST_CASE("softened glow keeps its hue, grows with the temperature, and leaves dim light as it is") {
    Renderer& renderer = test::patchRenderer();
    MaterialLooks looks = steel();
    looks.heatTint = 0;
    const LookParameters look = roomOnly(0);
    LookParameters exact = look;
    exact.glowSoftening = 0;
    const auto seen = [&](float kelvin, const LookParameters& by) {
        return lightOf(renderer, Patch(kelvin, kelvin).scene(looks), by);
    };
    const vec3 dim = seen(900, look), asItIs = seen(900, exact);
    CHECK(double(dim.r) == Approx(double(asItIs.r)).epsilon(0.05));
    CHECK(double(asItIs.r) == Approx(0.45 * double(blackBodyLight(900).r)).epsilon(0.01));
    float before = dim.g;
    for (const float kelvin : {1100.0f, 1300.0f, 1500.0f, 1690.0f}) {
        const vec3 now = seen(kelvin, look), black = blackBodyLight(double(kelvin));
        CHECK(now.g > before);
        if (now.r < 0.6f) CHECK(double(now.g / now.r) == Approx(double(black.g / black.r)).epsilon(0.02));
        before = now.g;
    }
}

TEST_CASE("a perfect mirror in an even room cannot be seen, however rough it is") {
    Renderer& renderer = test::evenlyLit(1);
    LookParameters look = roomOnly(1);
    look.dullness = 1;
    look.exposure = 0.5f; // unchanged by the tone curve
    MaterialLooks looks;
    looks.solidColour = looks.liquidColour = vec3(1);
    looks.liquidEmissivity = looks.cleanEmissivity = looks.scaledEmissivity = 0;
    for (const float roughness : {0.05f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
        looks.solidRoughness = looks.liquidRoughness = roughness;
        for (const float temperature : {300.0f, 1790.0f, 1900.0f}) {
            INFO("roughness " << roughness << ", " << temperature << " K");
            const vec3 seen = lightOf(renderer, Patch(temperature, temperature).scene(looks), look);
            for (int i = 0; i < 3; ++i)
                CHECK(double(seen[i]) == Approx(0.5).epsilon(0.02));
        }
    }
}

TEST_CASE("the light of an arc that rough metal reflects towards the eye adds up to the arc's light") {
    Renderer& renderer = test::evenlyLit(0);
    LookParameters look = roomOnly(0);
    look.dullness = 1;
    look.exposure = 2e-4f; // a reflection below the knee of the tone curve
    MaterialLooks looks;
    looks.solidColour = vec3(1);
    looks.liquidRoughness = 0;
    looks.liquidEmissivity = looks.cleanEmissivity = looks.scaledEmissivity = 0;
    const Patch patch(300, 300);
    constexpr int kSteps = 300;
    constexpr double kFar = 0.2;
    for (const float roughness : {0.1f, 0.2f, 0.4f, 0.6f, 0.8f}) {
        looks.solidRoughness = roughness;
        SceneView scene = patch.scene(looks);
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) { // with a direct view, only the angle from the normal counts
            const double part = (i + 0.5) / kSteps, angle = std::numbers::pi / 2 * part * part;
            const double width = std::numbers::pi * part / kSteps;
            const vec3 away(std::sin(angle), 0, std::cos(angle));
            scene.arc = {float(kFar) * away, vec3(float(kFar * kFar)), 1e-4f};
            sum += lightWithoutGlare(renderer, scene, look) / double(look.exposure) * std::sin(angle) * width * 2 *
                   std::numbers::pi;
        }
        INFO("roughness " << roughness);
        CHECK(sum == Approx(1).epsilon(0.05));
    }
}

TEST_CASE("a pool mirrors torch and workpiece in the light of the arc, solid metal the room alone") {
    Renderer& renderer = test::evenlyLit(0.1f);
    LookParameters look = roomOnly(0);
    look.exposure = 0.5f;
    look.ambient = 1;
    MaterialLooks looks;
    looks.liquidColour = vec3(1);
    looks.liquidRoughness = 0;
    looks.liquidEmissivity = 0;
    const Patch pool(2000, 2000), solid(300, 300);
    const vec3 eye(0.5f, 0, 0.5f); // views the pool at 45 degrees and sees the reflection of the other side
    SceneView scene = pool.scene(looks);
    CHECK(double(lightOf(renderer, scene, look, eye).g) == Approx(0.5 * 0.1).epsilon(0.02));

    SECTION("a torch part, by the side that it shows to the pool") {
        Solid nozzle;
        nozzle.shape = SolidShape::cylinder;
        nozzle.colour = {0.8f, 0.4f, 0.2f};
        nozzle.toWorld = alongLine({-0.4f, -0.2f, 0.4f}, {-0.4f, 0.2f, 0.4f}, 0.1f);
        scene.solids = {&nozzle, 1};
        const vec3 dark = lightOf(renderer, scene, look, eye);
        for (int i = 0; i < 3; ++i) // light of the lamp alone
            CHECK(double(dark[i]) == Approx(0.5 * double(nozzle.colour[i])).epsilon(0.01));
        // The arc is 0.15 from the reflecting place, 60 degrees from its normal.
        const vec3 normal = glm::normalize(vec3(1, 0, -1)), place = vec3(-0.4f, 0, 0.4f) + 0.05f * normal;
        scene.arc = {place + 0.15f * (0.5f * normal + std::sqrt(0.75f) * vec3(0, 1, 0)),
                     vec3(0.15f * 0.15f * float(std::numbers::pi) * 0.8f), 1e-6f};
        const vec3 image = lightOf(renderer, scene, look, eye);
        for (int i = 0; i < 3; ++i)
            CHECK(double(image[i]) == Approx(0.5 * 1.4 * double(nozzle.colour[i])).epsilon(0.02));
        scene.solids = {&nozzle, 1};
        scene.arc = {};
        nozzle.toWorld = alongLine({-0.4f, -0.2f, 0.4f}, {-0.4f, -0.1f, 0.4f}, 0.1f); // ends before it meets the ray
        CHECK(double(lightOf(renderer, scene, look, eye).g) == Approx(0.5 * 0.1).epsilon(0.02));
    }
    SECTION("another plate, which stands on this one") {
        const std::array<WorkpieceBlock, 2> blocks{
            {{{-1, -1, -0.1f}, {1, 1, 0.001f}}, {{-0.4f, -1, 0}, {-0.3f, 1, 1}}}};
        scene.blocks = blocks;
        CHECK(double(lightOf(renderer, scene, look, eye).g) == Approx(0.5 * 0.25).epsilon(0.02));
        look.diffuse = 1; // the lamp lights the side that faces the pool
        look.lightPosition = {2, 0, 1};
        const double lamp = 2 / std::sqrt(5.0);
        CHECK(double(lightOf(renderer, scene, look, eye).g) == Approx(0.5 * 0.25 * (1 + lamp)).epsilon(0.02));
    }
    SECTION("solid metal shows no torch") {
        SceneView cold = solid.scene(looks);
        const vec3 before = lightOf(renderer, cold, look, eye);
        Solid nozzle;
        nozzle.shape = SolidShape::cylinder;
        nozzle.toWorld = alongLine({-0.4f, -0.2f, 0.4f}, {-0.4f, 0.2f, 0.4f}, 0.1f);
        cold.solids = {&nozzle, 1};
        CHECK(lightOf(renderer, cold, look, eye) == before);
    }
}

TEST_CASE("shares of an even room: a smooth mirror's by Schlick's law, a rough one's smaller") {
    for (const float cosine : {0.2f, 0.5f, 0.9f}) {
        const glm::vec2 smooth = mirrorShares(0.02f, cosine);
        const double grazing = std::pow(1 - double(cosine), 5);
        CHECK(double(smooth.x) == Approx(1 - grazing).margin(0.005));
        CHECK(double(smooth.y) == Approx(grazing).margin(0.005));
    }
    // The reference is a quadrature of the lobe over the hemisphere along the normal.
    CHECK(double(mirrorShares(0.44f, 1).x + mirrorShares(0.44f, 1).y) == Approx(0.9367).margin(0.005));
    CHECK(double(mirrorShares(0.8f, 1).x + mirrorShares(0.8f, 1).y) == Approx(0.5366).margin(0.01));
}

} // namespace meltpool
