// Colours of vertices for files: against the pictures and against their formulas.
#include "core/render/camera.hpp"
#include "core/render/look/heat_colours.hpp"
#include "core/render/look/material_presets.hpp"
#include "core/render/look/temperature_scale.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/render/surface_colours.hpp"
#include "shaders/shared/surface.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace meltpool {

namespace {

using glm::vec2;
using glm::vec3;

const MaterialLooks kSteel = [] {
    MaterialLooks looks;
    looks.solidColour = {0.5f, 0.4f, 0.3f};
    looks.heatTint = 1;
    return looks;
}();

SceneView steelScene() {
    SceneView scene;
    scene.temperature = {293.15f, 2500, true, 1700, 1800};
    scene.looks = &kSteel;
    return scene;
}

/// Returns light as displayed (IEC 61966-2-1), 0..255.
double shownByte(float light) {
    const double l = double(light);
    return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055);
}

vec3 linearOf(vec3 shown) {
    for (int i = 0; i < 3; ++i)
        shown[i] = shown[i] <= 0.04045f ? shown[i] / 12.92f : std::pow((shown[i] + 0.055f) / 1.055f, 2.4f);
    return shown;
}

/// Leaves grey below 0.6 and compresses brighter light.
vec3 toned(vec3 light) {
    for (int i = 0; i < 3; ++i) {
        const float over = std::max(light[i] - 0.6f, 0.0f) / 0.4f;
        light[i] = std::min(light[i], 0.6f) + 0.4f * over / (1 + over);
    }
    return light;
}

/// Returns the glow as drawn without a visor: its luminance compressed.
vec3 softened(const vec3& glow) {
    const float luminance = glm::dot(glow, vec3(0.2126f, 0.7152f, 0.0722f)), from = LookParameters().glowSoftening;
    return luminance > 0 ? glow * (from * std::log1p(luminance / from) / luminance) : glow;
}

vec3 colourOf(const SceneView& scene, const LookParameters& look, vec2 heat) {
    return surfaceColours(test::shaders(), scene, look, {&heat, 1}).front();
}

/// Near black, one step of the scale's texture is several steps of the displayed byte.
void checkColour(const vec3& colour, const vec3& expected) {
    for (int i = 0; i < 3; ++i)
        CHECK(shownByte(colour[i]) == Approx(shownByte(expected[i])).margin(5));
}

/// Returns the middle pixel of the picture of a wall of this temperature.
vec3 wallInPicture(SceneView scene, const LookParameters& look, float temperature) {
    std::array<SurfaceVertex, 4> corners{};
    for (size_t i = 0; i < 4; ++i)
        corners[i] = {{i == 1 || i == 2 ? 1 : -1, i > 1 ? 1 : -1, 0}, temperature, {0, 0, 1}, 0};
    const std::array<GLuint, 6> indices{0, 1, 2, 0, 2, 3};
    const SurfaceDraw draw{6, 1, 0, 0, 0};
    const gl::Buffer vertexBuffer("wall vertices", std::span<const SurfaceVertex>(corners));
    const gl::Buffer indexBuffer("wall indices", std::span<const GLuint>(indices));
    const gl::Buffer command("wall draw command", std::span<const SurfaceDraw>(&draw, 1));
    scene.mesh = {&vertexBuffer, &indexBuffer, &command, nullptr};
    constexpr int kSize = 32;
    const PictureTarget target(kSize, kSize, 1);
    Renderer renderer(test::shaders());
    const View view = FreeCamera({0, 0, 1}, {0, 0, 0}).view({}, 1);
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    const Image picture = target.read();
    const std::uint8_t* pixel = &picture.rgb[3 * (kSize * kSize / 2 + kSize / 2)];
    return {pixel[0], pixel[1], pixel[2]};
}

LookParameters withoutLamp(float ambient) {
    LookParameters look;
    look.showBox = look.showSky = look.showSource = false;
    look.ambient = ambient;
    look.diffuse = look.specular = 0;
    return look;
}

} // namespace

TEST_CASE("in temperature colours a vertex has the colour that the picture has there") {
    test::context();
    for (const int colours : {kTemperatureColours, kEvenColours, kGreyColours})
        for (const float kelvin : {300.0f, 900.0f, 1600.0f, 2400.0f}) {
            INFO("colours " << colours << ", " << kelvin << " K");
            LookParameters look = withoutLamp(1);
            look.colours = colours;
            const vec3 colour = colourOf(steelScene(), look, {kelvin, kelvin});
            const vec3 picture = wallInPicture(steelScene(), look, kelvin);
            for (int i = 0; i < 3; ++i)
                CHECK(shownByte(colour[i]) == Approx(picture[i]).margin(2));
            checkColour(colour, toned(linearOf(temperatureColour(static_cast<ColourMode>(colours),
                                                                 (kelvin - 293.15f) / (2500 - 293.15f)))));
        }
}

TEST_CASE("hot metal has its own light in the picture and at the vertices, by one formula") {
    test::context();
    const MaterialData material = physicalMaterial(kSteel);
    for (const float kelvin : {300.0f, 1300.0f, 1600.0f, 1850.0f, 2100.0f}) {
        INFO(kelvin << " K");
        const float liquid = glm::clamp((kelvin - 1700) / 100, 0.0f, 1.0f);
        const float scaled = glm::smoothstep(673.0f, 1173.0f, kelvin); // share of the surface under scale
        const float scale = (1 - material.scaledEmissivity) * glm::mix(1.0f, 1.5f, liquid);
        const float solid = glm::mix(material.cleanEmissivity, 1 - scale, scaled);
        const vec3 glow = softened(glm::mix(solid, material.liquidEmissivity, liquid) * blackBodyLight(double(kelvin)));
        const vec3 picture = wallInPicture(steelScene(), withoutLamp(0), kelvin);
        for (int i = 0; i < 3; ++i)
            CHECK(double(picture[i]) == Approx(shownByte(toned(glow)[i])).margin(4));
        const vec3 dull =
            glm::mix(material.cleanReflectance * temperTint(double(kelvin)), scale * vec3(0.93f, 0.97f, 1.05f), scaled);
        const vec3 body = glm::mix(dull, linearOf(material.liquidColour), liquid);
        checkColour(colourOf(steelScene(), {}, {kelvin, 0}), toned(body + glow));
    }
}

TEST_CASE("cold metal keeps the oxide of its peak, and molten metal has none") {
    const SceneView scene = steelScene();
    const vec3 clean = colourOf(scene, {}, {300, 300}), straw = colourOf(scene, {}, {300, 503}),
               blue = colourOf(scene, {}, {300, 583});
    CHECK(straw.b / straw.r < 0.8f * clean.b / clean.r);
    CHECK(blue.b / blue.r > 1.2f * clean.b / clean.r);
    checkColour(straw, toned(physicalMaterial(kSteel).cleanReflectance * temperTint(503)));
    checkColour(colourOf(scene, {}, {1850, 1850}), colourOf(scene, {}, {1850, 2500}));
}

TEST_CASE("the classic metal has the preset's colours, and a filter before the eye changes no file") {
    SceneView scene;
    LookParameters look;
    look.material = kCopper;
    look.visorShade = 10;
    const MaterialData copper = presetMaterial(kCopper);
    checkColour(colourOf(scene, look, {0, 0}), toned(linearOf(copper.solidColour)));
    checkColour(colourOf(scene, look, {1, 0}), toned(linearOf(copper.liquidColour)));
    CHECK(surfaceColours(test::shaders(), scene, look, {}).empty());
}

TEST_CASE("every one of many vertices has its colour") {
    std::vector<vec2> heats;
    for (int i = 0; i < 1000; ++i)
        heats.emplace_back(300 + 2 * i, 0);
    const auto colours = surfaceColours(test::shaders(), steelScene(), {}, heats);
    REQUIRE(colours.size() == heats.size());
    for (const size_t i : {size_t(0), size_t(63), size_t(64), size_t(640), size_t(999)})
        CHECK(colours[i] == colourOf(steelScene(), {}, heats[i]));
}

} // namespace meltpool
