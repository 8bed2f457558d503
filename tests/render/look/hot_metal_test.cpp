// Hot metal: what it gives out on both sides of its melting point, what it mirrors of an even room and of an arc.
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
using test::paintEvenly;
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

/// Green light of the patch itself: the same picture without the patch shows the veil that the arc throws over it.
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
                              look.exposure * vec3(0.75f, 1.1f, 0.5f); // the filter is green
        for (int i = 0; i < 3; ++i)
            CHECK(double(seen[i]) == Approx(double(expected[i])).epsilon(0.01));
    };
    check(1500, 0.85f);
    check(1767, 0.85f);
    check(1813, 0.35f);
    check(2100, 0.35f);
    check(1790.5f,
          (1 - 0.15f * 1.25f + 0.35f) / 2); // half molten: scale that has half begun to be that of frozen metal
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
        // Colder and yet brighter: twice the emissivity against seven tenths of a black body's light.
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
    Renderer& renderer = test::patchRenderer();
    paintEvenly(renderer, 1);
    LookParameters look = roomOnly(1);
    look.dullness = 1;
    look.exposure = 0.5f; // the tone curve leaves that as it is
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
    Renderer& renderer = test::patchRenderer();
    paintEvenly(renderer, 0);
    LookParameters look = roomOnly(0);
    look.dullness = 1;
    look.exposure = 2e-4f; // a mirror's highlight stays below the knee of the tone curve
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
        for (int i = 0; i < kSteps; ++i) { // looking straight at it, only the angle from the normal counts
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

TEST_CASE("shares of an even room: a smooth mirror's by Schlick's law, a rough one's smaller") {
    for (const float cosine : {0.2f, 0.5f, 0.9f}) {
        const glm::vec2 smooth = mirrorShares(0.02f, cosine);
        const double grazing = std::pow(1 - double(cosine), 5);
        CHECK(double(smooth.x) == Approx(1 - grazing).margin(0.005));
        CHECK(double(smooth.y) == Approx(grazing).margin(0.005));
    }
    // By quadrature of the lobe over the hemisphere, looking along the normal.
    CHECK(double(mirrorShares(0.44f, 1).x + mirrorShares(0.44f, 1).y) == Approx(0.9367).margin(0.005));
    CHECK(double(mirrorShares(0.8f, 1).x + mirrorShares(0.8f, 1).y) == Approx(0.5366).margin(0.01));
}

} // namespace meltpool
