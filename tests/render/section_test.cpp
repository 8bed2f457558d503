// The section's picture: its golden, and exact agreement with its map.
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/render/section.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <functional>
#include <vector>

namespace meltpool {

namespace {

constexpr float kAt = -0.01f;
constexpr int kEdge = 96; ///< edge of the pictures, pixels

/// Returns a map of 6 x 4 fields, each of one weight and one temperature, on the box of the synthetic weld's cut.
SectionMap fields(const std::function<glm::vec2(int, int)>& weightAndKelvin) {
    constexpr int kTexelsPerField = 16;
    SectionMap map{{-0.02f, -0.008f}, {0.04f, 0.018f}, {6 * kTexelsPerField, 4 * kTexelsPerField}, 0.0005f, {}};
    for (int y = 0; y < map.texels.y; ++y)
        for (int x = 0; x < map.texels.x; ++x) {
            const glm::vec2 field = weightAndKelvin(x / kTexelsPerField, y / kTexelsPerField);
            map.sums.emplace_back(field.x, field.x * field.y, field.x * field.y, 0.0f);
        }
    return map;
}

View lookingAlongSeam() {
    return FreeCamera({0.06f, 0.001f, 0.0f}, {kAt, 0.001f, 0.0f}).view({.nearest = 0.002f}, 1);
}

/// Draws the section alone, from the side that is removed.
Image pictureOf(const SectionMap& map, int colours) {
    SceneView scene;
    scene.temperature = {.coldest = 293, .hottest = 2000, .kelvin = true, .solidus = 1768, .liquidus = 1813};
    scene.section = {true, kAt, &map};
    LookParameters look;
    look.showBox = false;
    look.showSky = false;
    look.colours = colours;
    static Renderer renderer(test::shaders());
    const PictureTarget target(kEdge, kEdge, 1);
    const View view = lookingAlongSeam();
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    return target.read();
}

/// Returns the colour at a place of the section, z and y in m.
std::array<int, 3> colourAt(const Image& picture, glm::vec2 place) {
    const View view = lookingAlongSeam();
    const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(kAt, place.y, place.x, 1.0f);
    const glm::vec2 unit = glm::vec2(clip) / clip.w * 0.5f + 0.5f;
    const int x = static_cast<int>(unit.x * kEdge), y = static_cast<int>((1 - unit.y) * kEdge);
    const auto first = 3 * (static_cast<size_t>(y) * kEdge + static_cast<size_t>(x));
    return {picture.rgb[first], picture.rgb[first + 1], picture.rgb[first + 2]};
}

} // namespace

TEST_CASE("the picture of a cut weld is its golden") {
    test::context();
    const test::SyntheticWeld weld;
    const SectionMap map = weld.map();
    SceneView scene = weld.view();
    scene.section = {true, kAt, &map};
    Renderer renderer(test::shaders());
    const PictureTarget target(320, 240, 4);
    const View view =
        FreeCamera({0.016f, 0.010f, 0.006f}, {-0.01f, -0.0015f, 0.0f}).view({.nearest = 0.002f}, 320.0f / 240);
    LookParameters look;
    look.showBox = false;
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    CHECK(test::matchesGolden("render/section", target.read()));
}

TEST_CASE("the section shows the temperatures of its map, each in its place, and nothing where no metal is") {
    test::context();
    const std::array<glm::vec2, 4> kinds{{{1, 400}, {0.8f, 1200}, {1, 1900}, {0.3f, 1900}}};
    const auto kindAt = [](int x, int y) { return static_cast<size_t>(x * 7 + y * 5 + x * y) % 4; };
    const Image mixed = pictureOf(fields([&](int x, int y) { return kinds[kindAt(x, y)]; }), kTemperatureColours);
    std::vector<Image> plain;
    for (const glm::vec2 kind : kinds)
        plain.push_back(pictureOf(fields([&](int, int) { return kind; }), kTemperatureColours));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x) {
            const glm::vec2 middle =
                glm::vec2(-0.02f, -0.008f) + (glm::vec2(x, y) + 0.5f) * glm::vec2(0.04f, 0.018f) / glm::vec2(6, 4);
            INFO(x << " " << y);
            CHECK(colourAt(mixed, middle) == colourAt(plain[kindAt(x, y)], middle));
        }
    const glm::vec2 middle(0.001f, 0.001f);
    for (size_t a = 0; a < plain.size(); ++a)
        for (size_t b = 0; b < a; ++b)
            CHECK(colourAt(plain[a], middle) != colourAt(plain[b], middle));
    const SectionMap none;
    CHECK(colourAt(plain[3], middle) == colourAt(pictureOf(none, kTemperatureColours), middle));
}

TEST_CASE("the etched section tells molten, changed and cold metal apart by their highest temperature") {
    test::context();
    const auto lightness = [](float peak) {
        const Image picture = pictureOf(fields([&](int, int) { return glm::vec2(1, peak); }), kMaterialColours);
        double sum = 0;
        for (float z = -0.008f; z < 0.008f; z += 0.0005f)
            sum += colourAt(picture, {z, 0.001f})[1];
        return sum / 33;
    };
    const double cold = lightness(500), changed = lightness(1300), molten = lightness(1900);
    CHECK(cold > changed + 10);
    CHECK(molten > changed + 10);
}

} // namespace meltpool
