// Picture of the classic model's solder cube from the real simulation and surface: its front corner liquid and glossy,
// the rest solid and dull.
#include "core/metal/classic/classic_metal.hpp"
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/surface/surface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>

namespace meltpool {

namespace {

/// Mean and spread of the brightness of a square of pixels.
struct Brightness {
    double mean = 0;
    double spread = 0;
};

Brightness brightness(const Image& image, int x0, int y0, int size) {
    double sum = 0, squares = 0;
    for (int y = y0; y < y0 + size; ++y)
        for (int x = x0; x < x0 + size; ++x) {
            const auto at = static_cast<size_t>(y * image.width + x) * 3;
            const double value = (image.rgb[at] + image.rgb[at + 1] + image.rgb[at + 2]) / 3.0;
            sum += value;
            squares += value * value;
        }
    const double count = size * size;
    return {sum / count, std::sqrt(std::max(0.0, squares / count - sum / count * sum / count))};
}

} // namespace

TEST_CASE("the melted corner is dark and glossy on a dull grey cube") {
    gl::ShaderLibrary& shaders = test::shaders();
    ClassicMetal metal(shaders, {.particles = 20032});
    metal.parameters.supportRadius = 0.06f;
    metal.parameters.particleMass = 0.012f;
    metal.parameters.viscosity = 5;
    metal.parameters.heatRadius = 0.22f;
    metal.parameters.heatTemperature = 0.05f;
    metal.parameters.solidifyRate = 0.004f;
    const glm::vec3 flame(0.575f, 0.6f, 0.575f);
    for (int step = 0; step < 60; ++step)
        metal.step({.position = flame, .strength = 1}, nullptr);
    Surface surface(shaders, {}, glm::vec3(-1), glm::vec3(1));
    surface.update(metal.particles(), nullptr);

    SceneView scene;
    scene.mesh = surface.mesh();
    scene.particles = metal.particles();
    scene.source = {.shown = true, .position = flame, .on = true};
    Renderer renderer(shaders);
    const PictureTarget target(320, 240, 4);
    const View view = OrbitCamera(0.75f, 0.42f, 2.4f).view({}, 320.0f / 240);
    const auto shoot = [&](const LookParameters& look) {
        renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
        return target.read();
    };
    const Image metalColours = shoot({});
    CHECK(test::matchesGolden("render/melted-corner", metalColours, 0.03));
    LookParameters temperature;
    temperature.colours = kTemperatureColours;
    CHECK(test::matchesGolden("render/melted-corner-temperature", shoot(temperature), 0.03));

    const Brightness liquid = brightness(metalColours, 140, 100, 40);
    const Brightness solid = brightness(metalColours, 95, 110, 20);
    CHECK(liquid.mean < solid.mean);
    CHECK(liquid.spread > 4 * solid.spread);
}

} // namespace meltpool
