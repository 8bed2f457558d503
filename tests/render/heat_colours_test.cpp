// Light and colours of heat: the old candela, the standard lamp, the table of temper colours, and pictures.
#include "core/render/camera.hpp"
#include "core/render/look/heat_colours.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

TEST_CASE("a black body shines as the definitions say") {
    // Until 1979 the candela was 1/60 of the light of a square centimetre of freezing platinum (2041.4 K).
    CHECK(blackBodyTristimulus(2041.4).y == Approx(60e4).epsilon(0.03));
    // Standard illuminant A: 2856 K, x = 0.4476, y = 0.4074.
    const glm::dvec3 c = blackBodyTristimulus(2856);
    CHECK(c.x / (c.x + c.y + c.z) == Approx(0.4476).margin(0.004));
    CHECK(c.y / (c.x + c.y + c.z) == Approx(0.4074).margin(0.004));
    // The Draper point is 798 K: metal just begins to glow; in a lit room that is not visible.
    CHECK(blackBodyLight(798).r < 1e-3f);
    CHECK(blackBodyTristimulus(0) == glm::dvec3(0.0));
}

TEST_CASE("hotter is brighter and less red") {
    glm::vec3 before = blackBodyLight(700);
    for (double kelvin = 750; kelvin <= 4000; kelvin += 50) {
        const glm::vec3 light = blackBodyLight(kelvin);
        CHECK(light.r > before.r);
        CHECK(light.g * before.r >= before.g * light.r * 0.999f);
        CHECK(light.r >= light.g);
        CHECK(light.g >= light.b);
        before = light;
    }
}

TEST_CASE("temper colours go from straw over purple to blue and grey") {
    const auto tint = [](double celsius) { return temperTint(celsius + 273.15); };
    CHECK(tint(20) == glm::vec3(1.0f));
    CHECK((tint(230).r > tint(230).g && tint(230).g > tint(230).b)); // straw
    CHECK((tint(278).r > tint(278).g && tint(278).b > tint(278).g)); // purple
    CHECK((tint(310).b > tint(310).g && tint(310).g > tint(310).r)); // blue
    CHECK(std::abs(tint(700).r - tint(700).b) < 0.03f);              // grey
    CHECK(tint(1600).g > tint(1200).g);                              // molten metal has lost its scale
}

TEST_CASE("a filter's shade number is EN 169's logarithm") {
    CHECK(filterShare(0) == 1.0f);
    CHECK(filterShare(1) == Approx(1.0f));
    CHECK(filterShare(8) == Approx(1e-3f));
    CHECK(filterShare(10) == Approx(1.389e-4f).epsilon(0.01));
}

TEST_CASE("a weld glows, is tinted where it was hot, and shows its pool through the visor") {
    test::context();
    const test::SyntheticWeld weld;
    Renderer renderer(test::shaders());
    const PictureTarget target(320, 240, 4);
    const View view =
        FreeCamera({0.034f, 0.026f, 0.034f}, {0.006f, 0.0f, 0.0f}).view({.nearest = 0.005f}, 320.0f / 240);
    LookParameters look;
    look.showBox = false;
    const auto shoot = [&] {
        renderer.draw(weld.view(), look, {&view, 1}, target.target(), nullptr);
        return target.read();
    };
    CHECK(test::matchesGolden("render/weld-bare-eye", shoot()));
    look.visorShade = 9;
    CHECK(test::matchesGolden("render/weld-visor", shoot()));
    look.visorShade = 0;
    look.colours = kEvenColours;
    CHECK(test::matchesGolden("render/weld-temperature", shoot()));
}

/// Returns the linear brightness of the middle of a white plate that an arc of intensity 1 lights from 2 cm above,
/// model unit 1 m.
double plateUnderArc(Renderer& renderer, float intensity, float visorShade, float modelScale) {
    constexpr int kSize = 256;
    const PictureTarget target(kSize, kSize, 1);
    Solid plate;
    plate.toWorld = glm::scale(glm::mat4(1), glm::vec3(0.2f, 0.2f, 0.001f) * modelScale);
    plate.colour = glm::vec3(1);
    plate.gloss = 0;
    SceneView scene;
    scene.modelToWorld = glm::scale(glm::mat4(1), glm::vec3(modelScale));
    scene.solids = {&plate, 1};
    scene.arc = {{0, 0, 0.0205f}, glm::vec3(intensity), 0.001f};
    LookParameters look;
    look.showBox = look.showSky = false;
    look.ambient = look.diffuse = look.specular = 0;
    look.arcLight = 1;
    look.visorShade = visorShade;
    // The eye is off the arc's axis: in line with the arc it sees glare and no plate.
    const View view = FreeCamera(glm::vec3(0.3f, 0, 0.3f) * modelScale, {0, 0, 0}).view({.nearest = 0.005f}, 1);
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    const Image picture = target.read();
    const double shown = picture.rgb[3 * (kSize * kSize / 2 + kSize / 2) + 1] / 255.0;
    return std::pow((shown + 0.055) / 1.055, 2.4);
}

TEST_CASE("an arc lights a plate by the inverse square of its distance, in every scale, and less through a filter") {
    test::context();
    Renderer renderer(test::shaders());
    // 0.4 pi * 0.02² gives 0.4 of paper white.
    const auto intensity = static_cast<float>(0.4 * std::numbers::pi * 0.02 * 0.02);
    CHECK(plateUnderArc(renderer, 0, 0, 1) < 1e-3);
    CHECK(plateUnderArc(renderer, intensity, 0, 1) == Approx(0.4).epsilon(0.03));
    CHECK(plateUnderArc(renderer, intensity, 0, 25) == Approx(0.4).epsilon(0.03));
    CHECK(plateUnderArc(renderer, intensity / 2, 0, 1) == Approx(0.2).epsilon(0.03));
    CHECK(plateUnderArc(renderer, intensity * 1e3f, 8, 1) == Approx(0.4 * 1.1).epsilon(0.03)); // the filter's green
}

} // namespace meltpool
