// Independence of pictures from former draws, to the last bit and at every level of detail: neither the renderer nor
// the shared OpenGL context retains a draw's state.
#include "core/render/camera.hpp"
#include "core/render/look/measures.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/render/synthetic_scene.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <array>
#include <string>
#include <vector>

namespace meltpool {

namespace {

using glm::vec3;

constexpr int kWidth = 60, kHeight = 45;

struct Shot {
    std::string name;
    SceneView scene;
    LookParameters look;
    std::vector<View> views;
};

Image pictureOf(Renderer& renderer, const Shot& shot) {
    const PictureTarget target(kWidth * static_cast<int>(shot.views.size()), kHeight);
    renderer.draw(shot.scene, shot.look, shot.views, target.target(), nullptr);
    return target.read();
}

/// The objects of the shots apart from metal.
struct Things {
    Things();
    std::array<Solid, 2> torch;
    Solid fitting, furniture;
    Marker marker;
    Spark spark{{0.020f, 0.003f, 0.002f}, 0.0004f, {0.0002f, 0.001f, 0}, 2000};
    SectionMap map;
    std::array<SectionStroke, 1> strokes{};
};

Things::Things() {
    torch[0].shape = SolidShape::cylinder;
    torch[0].toWorld = alongLine({0.010f, 0.06f, 0}, {0.010f, 0.001f, 0}, 0.006f);
    torch[1].toWorld = glm::translate(glm::mat4(1), {0.0f, 0.012f, 0.01f}) * glm::scale(glm::mat4(1), vec3(0.004f));
    fitting.toWorld = glm::translate(glm::mat4(1), {0.006f, 0.006f, -0.004f}) * glm::scale(glm::mat4(1), vec3(0.002f));
    fitting.gloss = 0.1f;
    furniture.toWorld = glm::translate(glm::mat4(1), {0, 0, -0.02f}) * glm::scale(glm::mat4(1), vec3(0.01f));
    marker.toWorld = glm::translate(glm::mat4(1), {0.02f, 0.004f, 0}) * glm::scale(glm::mat4(1), vec3(0.004f));
    strokes[0] = {{-0.003f, 0}, {0.003f, 0.001f}, {1, 1, 0, 1}, 0.0005f, 0, {}};
}

/// Returns shots of every kind that could leave state behind.
std::vector<Shot> shots(const test::SyntheticWeld& weld, const test::SyntheticScene& cube, const Things& things) {
    const auto from = [](vec3 eye, vec3 to) {
        return FreeCamera(eye, to).view({.nearest = 0.002f}, float(kWidth) / kHeight);
    };
    const View ahead = from({0.036f, 0.010f, 0.007f}, {0.013f, 0, 0}),
               behind = from({0, 0.009f, 0.007f}, {-0.01f, 0, 0});
    SceneView all = weld.rippledView();
    all.solids = things.torch;
    all.fittings = {&things.fitting, 1};
    all.furniture = {&things.furniture, 1};
    all.room.shown = true;
    all.effects = {{&things.spark, 1}, 0, {20}};
    all.arc = {{0.015f, 0.003f, 0}, vec3(0.3f), 1e-3f};
    all.markers = {&things.marker, 1};
    all.afterImage = {0.4f, {0, 0, -1}};
    SceneView bare = weld.view(), cut = all;
    bare.mesh.peaks = nullptr;
    cut.section.shown = true;
    cut.section.at = -0.01f;
    cut.section.map = &things.map;
    cut.section.strokes = things.strokes;
    LookParameters plain, visor, wires, points, ice, colours;
    visor.visorShade = 10;
    wires.mode = kWireframeMode;
    points.mode = kPointsMode;
    points.pointSize = 0.001f;
    ice.material = kIce;
    colours.colours = kEvenColours;
    const View corner = OrbitCamera(0.75f, 0.42f, 2.4f).view({}, float(kWidth) / kHeight);
    std::vector<Shot> shots{{"all", all, plain, {ahead}},
                            {"ripples", all, plain, {behind}},
                            {"both eyes", all, plain, {ahead, behind}},
                            {"visor", all, visor, {ahead}},
                            {"bare", bare, plain, {ahead}},
                            {"no ripples", weld.view(), plain, {behind}},
                            {"section", cut, plain, {behind}},
                            {"wireframe", all, wires, {ahead}},
                            {"points", all, points, {behind}},
                            {"colours", all, colours, {ahead}},
                            {"ice", cube.view(), ice, {corner}},
                            {"cube", cube.view(), plain, {corner}}};
    return shots;
}

} // namespace

TEST_CASE("a picture is the same whatever was drawn before it, at every level of detail") {
    test::context();
    const test::SyntheticWeld weld;
    const test::SyntheticScene cube;
    Things things;
    things.map = weld.map();
    const std::vector<Shot> all = shots(weld, cube, things);
    Renderer renderer(test::shaders());
    for (const PictureDetail level : {kLowDetail, kMediumDetail, kHighDetail}) {
        std::vector<Image> first; // each after the previous one
        for (Shot shot : all) {
            shot.look.detail = level;
            first.push_back(pictureOf(renderer, shot));
        }
        for (size_t before = size_t(level); before < all.size(); before += 3)
            for (size_t i = 0; i < all.size(); ++i) {
                Shot other = all[before], shot = all[i];
                other.look.detail = int((before / 3 + i) % 3);
                shot.look.detail = level;
                pictureOf(renderer, other);
                INFO("level " << level << ": " << shot.name << " after " << other.name << " at level "
                              << other.look.detail);
                CHECK(compareImages(first[i], pictureOf(renderer, shot), 0).largest == 0);
            }
    }
}

TEST_CASE("a renderer of its own draws what one that drew much before draws") {
    test::context();
    const test::SyntheticWeld weld;
    const test::SyntheticScene cube;
    Things things;
    things.map = weld.map();
    const std::vector<Shot> all = shots(weld, cube, things);
    Renderer used(test::shaders());
    std::vector<Image> late;
    for (int round = 0; round < 2; ++round) {
        late.clear();
        for (const Shot& shot : all)
            late.push_back(pictureOf(used, shot));
    }
    for (const size_t i : {size_t(0), size_t(4), size_t(6)}) {
        Renderer fresh(test::shaders());
        INFO(all[i].name);
        CHECK(compareImages(late[i], pictureOf(fresh, all[i]), 0).largest == 0);
    }
}

} // namespace meltpool
