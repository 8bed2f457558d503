// Several views with one draw call or in sequence: equal pictures for every method of the driver.
#include "core/render/camera.hpp"
#include "core/render/look/measures.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/render/synthetic_scene.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cstdlib>
#include <memory>
#include <tuple>

namespace meltpool {

namespace {

constexpr int kSize = 128;
constexpr int kSamples = 4;

/// Returns two eyes as in a headset: apart, turned outwards a little, each with a frustum that opens more to its own
/// side.
std::array<View, 2> headsetEyes() {
    std::array<View, 2> eyes = {OrbitCamera(0.70f, 0.45f, 2.2f).view({}, 1),
                                OrbitCamera(0.80f, 0.45f, 2.2f).view({}, 1)};
    const float n = 0.05f;
    eyes[0].eyeToClip = glm::frustum(-0.50f * n, 0.38f * n, -0.42f * n, 0.46f * n, n, 50.0f);
    eyes[1].eyeToClip = glm::frustum(-0.38f * n, 0.50f * n, -0.42f * n, 0.46f * n, n, 50.0f);
    return eyes;
}

/// Returns a renderer for each method; the drivers of these tests support all.
Renderer& rendererBy(ViewSubmission submission) {
    static std::array<std::unique_ptr<Renderer>, kViewSubmissions.size()> all;
    auto& renderer = all[static_cast<size_t>(submission)];
    if (renderer == nullptr) {
        renderer = std::make_unique<Renderer>(test::shaders());
        REQUIRE(renderer->submitBy(submission).submission == submission);
    }
    return *renderer;
}

Image column(const Image& all, int index, int columns) {
    Image cut{all.width / columns, all.height, {}};
    for (int y = 0; y < all.height; ++y) {
        const auto row = all.rgb.begin() + (std::ptrdiff_t(y) * all.width + std::ptrdiff_t(index) * cut.width) * 3;
        cut.rgb.insert(cut.rgb.end(), row, row + cut.width * 3);
    }
    return cut;
}

/// Writes a picture for a person to look at if $MELTPOOL_PICTURES names a folder.
void keep(const Image& image, const std::string& name) {
    if (const char* folder = std::getenv("MELTPOOL_PICTURES")) writePng(std::filesystem::path(folder) / name, image);
}

/// Draws the views by every method and compares each with its own single-view picture.
void checkAllWays(const std::string& name, const SceneView& scene, const LookParameters& look,
                  std::span<const View> views) {
    const auto count = static_cast<int>(views.size());
    std::vector<Image> alone;
    for (const View& view : views) {
        const PictureTarget single(kSize, kSize, kSamples);
        rendererBy(ViewSubmission::passes).draw(scene, look, {&view, 1}, single.target(), nullptr);
        alone.push_back(single.read());
    }
    for (const ViewSubmission submission : kViewSubmissions) {
        const PictureTarget target(count * kSize, kSize, kSamples);
        rendererBy(submission).draw(scene, look, views, target.target(), nullptr);
        CHECK(glGetError() == GL_NO_ERROR);
        const Image all = target.read();
        keep(all, name + "-" + std::string(submissionName(submission)) + ".png");
        for (int i = 0; i < count; ++i) {
            const ImageDifference difference = compareImages(alone[static_cast<size_t>(i)], column(all, i, count), 8);
            INFO(name << " by " << submissionName(submission) << ", view " << i << ": mean " << difference.mean
                      << ", far " << difference.farPixels << ", largest " << difference.largest);
            CHECK(difference.mean < 0.1);
            CHECK(difference.farPixels < 0.002);
        }
    }
    // Similar views would hide a view drawn in another's place.
    CHECK(compareImages(alone.front(), alone.back(), 8).farPixels > 0.01);
}

const test::SyntheticScene& synthetic() {
    test::context();
    static const test::SyntheticScene only;
    return only;
}

/// Returns a scene with solids of every shape, the source, and a lens near enough that metal and points cross the
/// views' borders.
SceneView crowded(std::vector<Solid>& solids) {
    SceneView scene = synthetic().view();
    for (int i = 0; i < 4; ++i) {
        Solid solid;
        solid.shape = static_cast<SolidShape>(i);
        solid.toWorld = alongLine({-1.1f + 0.7f * float(i), 0.5f, 0.2f}, {-0.8f + 0.7f * float(i), -0.2f, 0.6f}, 0.3f);
        solid.colour = {0.1f + 0.2f * float(i), 0.3f, 0.5f - 0.1f * float(i)};
        solid.gloss = 0.25f * float(i);
        solids.push_back(solid);
    }
    scene.solids = solids;
    return scene;
}

} // namespace

TEST_CASE("every material looks the same in each eye, whichever way the eyes are submitted") {
    std::vector<Solid> solids;
    const SceneView scene = crowded(solids);
    const std::array<const char*, 5> names{"solder", "copper", "gold", "wax", "ice"};
    for (int material = kSolder; material <= kIce; ++material) {
        LookParameters look;
        look.material = material;
        checkAllWays(names[static_cast<size_t>(material)], scene, look, headsetEyes());
    }
}

TEST_CASE("temperature colours, wireframe and points look the same in each eye") {
    std::vector<Solid> solids;
    const SceneView scene = crowded(solids);
    for (const auto& [name, mode, colours] : {std::tuple{"temperature", kSurfaceMode, kTemperatureColours},
                                              std::tuple{"wireframe", kWireframeMode, kMaterialColours},
                                              std::tuple{"points", kPointsMode, kMaterialColours}}) {
        LookParameters look;
        look.mode = mode;
        look.colours = colours;
        checkAllWays(name, scene, look, headsetEyes());
    }
}

TEST_CASE("large points at a view's border do not reach into its neighbour") {
    SceneView scene = synthetic().view();
    LookParameters look;
    look.mode = kPointsMode;
    look.pointSize = 0.12f;
    std::array<View, 2> eyes = headsetEyes();
    for (size_t i = 0; i < eyes.size(); ++i) // the metal crosses the border between the views
        eyes[i].eyeToClip[2][0] += i == 0 ? -0.9f : 0.9f;
    checkAllWays("border", scene, look, eyes);
}

TEST_CASE("hot metal, its section and the far view of an open mesh look the same in each eye") {
    test::context();
    const test::SyntheticWeld weld;
    const SectionMap map = weld.map();
    SceneView scene = weld.view();
    const Lens lens{.nearest = 0.002f};
    const std::array<View, 2> eyes{FreeCamera({0.016f, 0.010f, 0.007f}, {-0.01f, -0.0015f, 0.0f}).view(lens, 1),
                                   FreeCamera({0.017f, 0.010f, 0.004f}, {-0.01f, -0.0015f, 0.0f}).view(lens, 1)};
    for (const bool cut : {false, true}) {
        scene.section = {.shown = cut, .at = -0.01f, .map = &map};
        for (const int mode : {int(kSurfaceMode), int(kPointsMode), int(kWireframeMode)}) {
            LookParameters look;
            look.mode = mode;
            look.pointSize = 0.0004f;
            checkAllWays(std::string(cut ? "cut-weld" : "weld") + std::to_string(mode), scene, look, eyes);
        }
    }
}

TEST_CASE("sparks, smoke, glare and an after-image look the same in each eye") {
    test::context();
    const test::SyntheticWeld weld;
    SceneView scene = weld.view();
    std::vector<Spark> sparks;
    for (int i = 0; i < 60; ++i) {
        const float x = 0.010f + 0.0002f * float(i), z = 0.0003f * float((i * 7) % 31 - 15);
        sparks.push_back(
            {{x, 0.001f + 0.0002f * float(i % 17), z}, 0.0002f, {0.0001f * float(i % 13), 0.001f, z}, 2000});
    }
    scene.effects = {sparks, 0, {20}};
    scene.arc = {{0.015f, 0.002f, 0}, glm::vec3(1), 1e-3f};
    scene.afterImage = {0.8f, glm::normalize(glm::vec3(0.1f, 0.05f, -1))};
    const Lens lens{.nearest = 0.002f};
    const std::array<View, 2> eyes{FreeCamera({0.046f, 0.020f, 0.017f}, {0.015f, 0.0f, 0.0f}).view(lens, 1),
                                   FreeCamera({0.047f, 0.020f, 0.010f}, {0.015f, 0.0f, 0.0f}).view(lens, 1)};
    LookParameters look;
    checkAllWays("effects", scene, look, eyes);
    look.visorShade = 5;
    checkAllWays("effects-visor", scene, look, eyes);
    look.spatter = look.fume = false; // the compared parts are in the picture
    const PictureTarget with(kSize, kSize, kSamples), without(kSize, kSize, kSamples);
    const View& view = eyes[0];
    rendererBy(ViewSubmission::passes).draw(scene, look, {&view, 1}, without.target(), nullptr);
    look.spatter = look.fume = true;
    rendererBy(ViewSubmission::passes).draw(scene, look, {&view, 1}, with.target(), nullptr);
    CHECK(compareImages(with.read(), without.read(), 8).farPixels > 0.01);
}

TEST_CASE("a bead's ripples look the same in each eye") {
    test::context();
    const test::SyntheticWeld weld;
    const Lens lens{.nearest = 0.002f};
    const std::array<View, 2> eyes{FreeCamera({0.003f, 0.009f, 0.007f}, {-0.01f, 0.0015f, 0.0f}).view(lens, 1),
                                   FreeCamera({0.003f, 0.009f, 0.004f}, {-0.01f, 0.0015f, 0.0f}).view(lens, 1)};
    LookParameters look;
    look.showBox = false;
    checkAllWays("ripples", weld.rippledView(), look, eyes);
    PictureTarget rippled(kSize, kSize, kSamples), plain(kSize, kSize, kSamples);
    rendererBy(ViewSubmission::passes).draw(weld.rippledView(), look, {&eyes[0], 1}, rippled.target(), nullptr);
    look.leftOut = bitOf(DetailFeature::ripples);
    rendererBy(ViewSubmission::passes).draw(weld.rippledView(), look, {&eyes[0], 1}, plain.target(), nullptr);
    CHECK(compareImages(rippled.read(), plain.read(), 8).farPixels > 0.02); // ripples are visible
    CHECK(test::matchesGolden("render/ripples", rippled.read()));
}

TEST_CASE("three views are three columns") {
    const std::array<View, 3> views{OrbitCamera(0.2f, 0.4f, 2.4f).view({}, 1),
                                    OrbitCamera(0.8f, 0.4f, 2.4f).view({}, 1),
                                    OrbitCamera(1.4f, 0.4f, 2.4f).view({}, 1)};
    LookParameters look;
    look.material = kIce;
    checkAllWays("three", synthetic().view(), look, views);
}

TEST_CASE("a driver takes the best way that it can, and says why it takes no better one") {
    const SubmissionOffer all{true, 16, 8};
    CHECK(chooseSubmission({}, all, 2).submission == ViewSubmission::viewports);
    CHECK(chooseSubmission({}, all, 2).sentence.find("has no") == std::string::npos);
    CHECK(chooseSubmission(ViewSubmission::clipping, all, 2).submission == ViewSubmission::clipping);
    CHECK(chooseSubmission(ViewSubmission::passes, all, 2).submission == ViewSubmission::passes);
    const SubmissionChoice old = chooseSubmission(ViewSubmission::viewports, {false, 16, 8}, 2);
    CHECK(old.submission == ViewSubmission::clipping);
    CHECK(old.sentence.find("no GL_ARB_shader_viewport_layer_array") != std::string::npos);
    CHECK(chooseSubmission({}, {true, 1, 8}, 2).submission == ViewSubmission::clipping);
    const SubmissionChoice poor = chooseSubmission({}, {false, 1, 2}, 2);
    CHECK(poor.submission == ViewSubmission::passes);
    CHECK(poor.sentence.find("only 2 clip distances") != std::string::npos);
}

TEST_CASE("the hidden part of each eye's picture is black, also over glare, and the rest is drawn as without it") {
    std::vector<Solid> solids;
    SceneView scene = crowded(solids);
    scene.arc = {{0, 0.3f, 0}, glm::vec3(4), 1e-2f};
    scene.effects.fume = {20};
    scene.afterImage = {0.8f, glm::normalize(glm::vec3(-0.2f, 0.05f, -1))};
    const std::array<View, 2> eyes = headsetEyes();
    // All that is left of the middle, in each eye.
    const std::array<glm::vec2, 6> strip{{{-1, -1}, {0, -1}, {-1, 1}, {-1, 1}, {0, -1}, {0, 1}}};
    const HiddenArea hidden{{strip, strip}, 1};
    const auto middle = [&](int eye) { // the column of pixels at x = 0
        const glm::vec4 clip = eyes[static_cast<size_t>(eye)].eyeToClip * glm::vec4(0, 0, -1, 1);
        return static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * kSize);
    };
    for (const ViewSubmission submission : kViewSubmissions) {
        const PictureTarget whole(2 * kSize, kSize, kSamples), spared(2 * kSize, kSize, kSamples);
        rendererBy(submission).draw(scene, {}, eyes, whole.target(), nullptr);
        RenderTarget target = spared.target();
        target.hidden = &hidden;
        rendererBy(submission).draw(scene, {}, eyes, target, nullptr);
        CHECK(glGetError() == GL_NO_ERROR);
        const Image all = whole.read(), part = spared.read();
        keep(part, "hidden-" + std::string(submissionName(submission)) + ".png");
        for (const int eye : {0, 1}) {
            INFO(submissionName(submission) << ", eye " << eye);
            const Image before = column(all, eye, 2), after = column(part, eye, 2);
            int drawn = 0, changed = 0;
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const size_t at = 3 * (static_cast<size_t>(y) * kSize + static_cast<size_t>(x));
                    const bool isBlack = after.rgb[at] + after.rgb[at + 1] + after.rgb[at + 2] == 0;
                    const bool isEqual = std::abs(int(after.rgb[at]) - int(before.rgb[at])) <= 2;
                    if (x < middle(eye) - 1) drawn += isBlack ? 0 : 1;
                    if (x > middle(eye) + 1) changed += isEqual ? 0 : 1;
                }
            CHECK(drawn == 0);
            CHECK(changed == 0);
            CHECK(compareImages(before, after, 8).farPixels > 0.1);
        }
    }
}

} // namespace meltpool
