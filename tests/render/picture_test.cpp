// Pictures: goldens of every mode and material, the thesis's exact colours, several views, plain targets.
#include "core/render/camera.hpp"
#include "core/render/look/temperature_scale.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/render/synthetic_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

Renderer& renderer() {
    static Renderer only(test::shaders());
    return only;
}

const test::SyntheticScene& synthetic() {
    test::context();
    static const test::SyntheticScene only;
    return only;
}

View frontCorner(float aspect = float(kWidth) / kHeight) {
    return OrbitCamera(0.75f, 0.42f, 2.4f).view({}, aspect);
}

Image picture(const SceneView& scene, const LookParameters& look, int samples = 4) {
    const PictureTarget target(kWidth, kHeight, samples);
    const View view = frontCorner();
    renderer().draw(scene, look, {&view, 1}, target.target(), nullptr);
    CHECK(glGetError() == GL_NO_ERROR);
    return target.read();
}

/// A square that faces the eye and fills the picture, of one temperature.
struct FlatScene {
    explicit FlatScene(float temperature) {
        std::vector<SurfaceVertex> corners;
        for (const glm::vec2 at : {glm::vec2(-9, -9), glm::vec2(9, -9), glm::vec2(9, 9), glm::vec2(-9, 9)})
            corners.push_back({glm::vec3(at, 0), temperature, glm::vec3(0, 0, 1), 0});
        const std::array<GLuint, 6> order{0, 1, 2, 0, 2, 3};
        const SurfaceDraw draw{6, 1, 0, 0, 0};
        vertices = gl::Buffer("flat vertices", std::span<const SurfaceVertex>(corners));
        indices = gl::Buffer("flat indices", std::span<const GLuint>(order));
        command = gl::Buffer("flat command", sizeof draw);
        command.writeValue(draw);
    }

    SceneView view() const {
        SceneView scene;
        scene.mesh.vertices = &vertices;
        scene.mesh.indices = &indices;
        scene.mesh.drawCommand = &command;
        return scene;
    }

    gl::Buffer vertices, indices, command;
};

glm::ivec3 pixel(const Image& image, int x, int y) {
    const auto at = static_cast<size_t>(y * image.width + x) * 3;
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// Returns the middle pixel of a flat scene under pure ambient light of 1.
glm::ivec3 flatColour(float temperature, LookParameters look, bool encodesSrgb) {
    test::context();
    const FlatScene flat(temperature);
    look.ambient = 1;
    look.diffuse = 0;
    look.specular = 0;
    look.showBox = false;
    const PictureTarget target(16, 16);
    RenderTarget where = target.target();
    const gl::Texture plainColour("plain colour", {.format = GL_RGBA8, .width = 16, .height = 16});
    const gl::Framebuffer plain("plain");
    const gl::Texture plainDepth("plain depth", {.format = GL_DEPTH_COMPONENT24, .width = 16, .height = 16});
    plain.attach(GL_COLOR_ATTACHMENT0, plainColour);
    plain.attach(GL_DEPTH_ATTACHMENT, plainDepth);
    if (!encodesSrgb) where = {.framebuffer = plain.name(), .viewport = {0, 0, 16, 16}};
    const View view = FreeCamera({0, 0, 2}, {0, 0, 0}).view({}, 1);
    renderer().draw(flat.view(), look, {&view, 1}, where, nullptr);
    return pixel(gl::readPixels(where.framebuffer, 16, 16), 8, 8);
}

} // namespace

TEST_CASE("every material looks like its golden") {
    const std::array<const char*, 5> names{"solder", "copper", "gold", "wax", "ice"};
    for (int material = kSolder; material <= kIce; ++material) {
        LookParameters look;
        look.material = material;
        const std::string name = names[static_cast<size_t>(material)];
        CHECK(test::matchesGolden("render/material-" + name, picture(synthetic().view(), look)));
    }
}

TEST_CASE("every mode and colour scale looks like its golden") {
    const std::array<const char*, 3> modes{"surface", "wireframe", "points"};
    const std::array<const char*, 4> scales{"material", "temperature", "even", "grey"};
    for (int mode = kSurfaceMode; mode <= kPointsMode; ++mode)
        for (int colours = kMaterialColours; colours <= kGreyColours; ++colours) {
            if (mode == kSurfaceMode && colours == kMaterialColours) continue; // covered by the materials
            if (mode != kSurfaceMode && colours > kTemperatureColours) continue;
            LookParameters look;
            look.mode = mode;
            look.colours = colours;
            const std::string name =
                std::string("render/") + modes[static_cast<size_t>(mode)] + "-" + scales[static_cast<size_t>(colours)];
            CHECK(test::matchesGolden(name, picture(synthetic().view(), look)));
        }
}

TEST_CASE("box, sky and source can be switched, the source shows what it does, and shapes look like their golden") {
    SceneView scene = synthetic().view();
    LookParameters look;
    look.showBox = false;
    look.showSky = false;
    look.showSource = false;
    const Image bare = picture(scene, look);
    CHECK(test::matchesGolden("render/bare", bare));
    for (bool LookParameters::*part :
         {&LookParameters::showBox, &LookParameters::showSky, &LookParameters::showSource}) {
        LookParameters with = look;
        with.*part = true;
        CHECK(compareImages(bare, picture(scene, with), 24).farPixels > 0.0005);
    }
    look.showSource = true;
    // The flame is blue over the metal, and warms or cools its place on it.
    const auto sourcePicture = [&](bool on, bool cold) {
        scene.source.on = on;
        scene.source.cold = cold;
        return picture(scene, look);
    };
    const Image off = sourcePicture(false, false), hot = sourcePicture(true, false), cold = sourcePicture(true, true);
    const auto redder = [](const Image& than, const Image& image) {
        int count = 0;
        for (size_t i = 0; i + 2 < image.rgb.size(); i += 3)
            count += image.rgb[i] - image.rgb[i + 2] > than.rgb[i] - than.rgb[i + 2] + 8;
        return count;
    };
    CHECK(redder(bare, off) > 100);
    CHECK(redder(off, hot) > 100);
    CHECK(redder(cold, hot) > redder(off, hot));

    std::vector<Solid> solids;
    for (int i = 0; i < 4; ++i) {
        Solid solid;
        solid.shape = static_cast<SolidShape>(i);
        solid.toWorld = alongLine({-0.9f + 0.6f * float(i), 0.3f, 0.2f}, {-0.7f + 0.6f * float(i), -0.2f, 0.4f}, 0.3f);
        solid.colour = {0.1f + 0.2f * float(i), 0.3f, 0.5f - 0.1f * float(i)};
        solid.gloss = 0.25f * float(i);
        solids.push_back(solid);
    }
    SceneView shapes;
    shapes.solids = solids;
    CHECK(test::matchesGolden("render/solids", picture(shapes, LookParameters{})));
}

TEST_CASE("temperature colours arrive as they are on either kind of target") {
    LookParameters look;
    look.colours = kTemperatureColours;
    for (const bool encodes : {true, false})
        for (const float t : {0.0f, 0.25f, 0.5f, 0.6f, 1.0f}) {
            const glm::vec3 shown = temperatureColour(kTemperatureColours, t) * 255.0f;
            const glm::ivec3 seen = flatColour(t, look, encodes);
            INFO("t " << t << " encodes " << encodes << ": " << seen.r << " " << seen.g << " " << seen.b);
            for (int channel = 0; channel < 3; ++channel) // the tone curve compresses light above 200
                if (shown[channel] < 200) CHECK(std::abs(float(seen[channel]) - shown[channel]) <= 2.0f);
        }
}

TEST_CASE("solder follows the thesis: grey max(1 - T, 0.2) and mirror share min(T, 0.6) from T > 0.3") {
    LookParameters look;
    look.dullness = 0; // one reflection for all temperatures
    const auto linear = [](double shown) { return std::pow((shown + 0.055) / 1.055, 2.4); };
    const auto seen = [&](float t) {
        const glm::ivec3 c = flatColour(t, look, true);
        return std::array<double, 3>{linear(c.r / 255.0), linear(c.g / 255.0), linear(c.b / 255.0)};
    };
    const auto solid = seen(0);
    for (const float t : {0.1f, 0.3f, 0.45f, 0.5f, 0.6f, 0.7f, 0.8f, 1.0f}) {
        const double grey = t > 0.3f ? std::max(1.0 - double(t), 0.2) : 0.7;
        const double share = t > 0.3f ? std::min(double(t), 0.6) : 0.3;
        const auto now = seen(t);
        for (size_t channel = 0; channel < 3; ++channel) {
            const double image = (solid[channel] - 0.7 * linear(0.7)) / 0.3;
            CHECK(now[channel] == Approx((1 - share) * linear(grey) + share * image).margin(0.01));
        }
    }
}

TEST_CASE("particles show exactly the colour of their temperature") {
    test::context();
    const std::array<glm::vec4, 1> one{glm::vec4(0, 0, 0, 0.6f)};
    const gl::Buffer buffer("one particle", std::span<const glm::vec4>(one));
    SceneView scene;
    scene.particles.positions = &buffer;
    scene.particles.count = 1;
    LookParameters look;
    look.mode = kPointsMode;
    look.pointSize = 0.2f;
    look.showBox = false;
    for (const ColourMode colours : {kTemperatureColours, kEvenColours, kGreyColours}) {
        look.colours = colours;
        const glm::ivec3 seen = pixel(picture(scene, look), kWidth / 2, kHeight / 2);
        const glm::vec3 shown = temperatureColour(colours, 0.6f) * 255.0f;
        for (int channel = 0; channel < 3; ++channel)
            CHECK(std::abs(float(seen[channel]) - shown[channel]) <= 2.0f);
    }
}

TEST_CASE("two views side by side are the two pictures, each with its own reflections") {
    const SceneView scene = synthetic().view();
    for (const int material : {int(kSolder), int(kIce)}) {
        LookParameters look;
        look.material = material;
        const std::array<View, 2> eyes{OrbitCamera(0.70f, 0.4f, 2.4f).view({}, 1),
                                       OrbitCamera(0.80f, 0.4f, 2.4f).view({}, 1)};
        const PictureTarget both(256, 128);
        renderer().draw(scene, look, eyes, both.target(), nullptr);
        const Image pair = both.read();
        for (int eye = 0; eye < 2; ++eye) {
            const PictureTarget single(128, 128);
            renderer().draw(scene, look, {&eyes[static_cast<size_t>(eye)], 1}, single.target(), nullptr);
            const Image alone = single.read();
            Image half{128, 128, {}};
            for (int y = 0; y < 128; ++y) {
                const auto row = pair.rgb.begin() + (y * 256 + eye * 128) * 3;
                half.rgb.insert(half.rgb.end(), row, row + 128 * 3);
            }
            const ImageDifference difference = compareImages(alone, half, 8);
            CHECK(difference.farPixels < 0.002);
        }
    }
}

TEST_CASE("a target that does not encode gets the same picture from the shaders") {
    const SceneView scene = synthetic().view();
    LookParameters look;
    look.showSource = false; // its flame lets the metal through, which is blended as the target's values are
    const Image encoded = picture(scene, look, 1);
    const gl::Texture colour("plain colour", {.format = GL_RGBA8, .width = kWidth, .height = kHeight});
    const gl::Texture depth("plain depth", {.format = GL_DEPTH_COMPONENT24, .width = kWidth, .height = kHeight});
    const gl::Framebuffer plain("plain");
    plain.attach(GL_COLOR_ATTACHMENT0, colour);
    plain.attach(GL_DEPTH_ATTACHMENT, depth);
    plain.requireComplete();
    const View view = frontCorner();
    renderer().draw(scene, look, {&view, 1}, {.framebuffer = plain.name(), .viewport = {0, 0, kWidth, kHeight}},
                    nullptr);
    const ImageDifference difference = compareImages(encoded, gl::readPixels(plain.name(), kWidth, kHeight), 6);
    CHECK(difference.farPixels < 0.01); // drivers blend smooth lines differently
    CHECK(difference.mean < 1.0);
}

} // namespace meltpool
