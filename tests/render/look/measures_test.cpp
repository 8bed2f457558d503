// The levels of detail: the measures of each, the omissions of the lowest, and its remaining parts.
#include "core/render/camera.hpp"
#include "core/render/look/heat_colours.hpp"
#include "core/render/look/measures.hpp"
#include "core/render/picture_target.hpp"
#include "shaders/shared/render.h"
#include "tests/render/look/patch.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <array>
#include <bit>
#include <vector>

namespace meltpool {

namespace {

using glm::vec3;
using test::lightOf;
using test::Patch;
using test::roomOnly;

LookParameters atLevel(LookParameters look, PictureDetail detail) {
    look.detail = detail;
    return look;
}

/// Returns a view of the pool.
View viewFrom(vec3 eye) {
    return FreeCamera(eye, {0.013f, 0, 0}).view({.nearest = 0.002f}, 160.0f / 120);
}

Image pictureOf(const SceneView& scene, const LookParameters& look, std::span<const View> views) {
    const PictureTarget target(160 * static_cast<int>(views.size()), 120);
    test::patchRenderer().draw(scene, look, views, target.target(), nullptr);
    return target.read();
}

} // namespace

TEST_CASE("each level has all measures of the one before, the highest has all, the lowest none") {
    LookParameters look;
    unsigned before = 0;
    for (const PictureDetail level : {kLowDetail, kMediumDetail, kHighDetail}) {
        look.detail = level;
        CHECK((measuresOf(look) & before) == before);
        before = measuresOf(look);
        if (level == kLowDetail) CHECK(before == 0);
    }
    CHECK(std::popcount(before) == static_cast<int>(kMeasures.size()));
    for (size_t i = 0; i < kMeasures.size(); ++i) {
        CHECK(static_cast<size_t>(kMeasures[i].measure) == i);
        look.leftOut = bitOf(kMeasures[i].measure);
        CHECK_FALSE(has(look, kMeasures[i].measure));
        CHECK(std::popcount(measuresOf(look)) == static_cast<int>(kMeasures.size()) - 1);
    }
}

TEST_CASE("at every level the pool's edge can be seen: emissivity jumps, and what froze is duller") {
    MaterialLooks looks;
    looks.heatTint = 1;
    looks.liquidEmissivity = 0.35f;
    looks.cleanEmissivity = 0.45f;
    looks.scaledEmissivity = 0.85f;
    Renderer& renderer = test::patchRenderer();
    for (const PictureDetail level : {kLowDetail, kMediumDetail, kHighDetail}) {
        INFO("level " << level);
        LookParameters look = atLevel(roomOnly(0), level);
        look.visorShade = 10;
        const float frozen = lightOf(renderer, Patch(1767, 2000).scene(looks), look).g;
        const float pool = lightOf(renderer, Patch(1814, 2000).scene(looks), look).g;
        CHECK(double(frozen) ==
              Approx(0.85 * double(blackBodyLight(1767).g) * double(filterShare(10)) * 1.1).epsilon(0.2));
        CHECK(frozen > 1.4f * pool);
        // Towards the arc's reflection liquid metal is bright in a small area, solid metal faintly in a wide one.
        const Patch liquid(1900, 1900), solid(300, 300);
        SceneView arcOver = liquid.scene(looks);
        arcOver.arc = {{0.004f, 0, 0.2f}, vec3(1e-3f), 1e-4f};
        SceneView arcOverSolid = solid.scene(looks);
        arcOverSolid.arc = arcOver.arc;
        LookParameters seen = atLevel(roomOnly(0), level);
        seen.arcLight = 1;
        seen.leftOut = bitOf(DetailFeature::glare);
        seen.exposure = 1e-2f;
        const float image = lightOf(renderer, arcOver, seen).g - lightOf(renderer, liquid.scene(looks), seen).g;
        const float imageInSolid =
            lightOf(renderer, arcOverSolid, seen).g - lightOf(renderer, solid.scene(looks), seen).g;
        CHECK(imageInSolid > 1e-4f);
        CHECK(image > 2 * imageInSolid);
    }
}

TEST_CASE("the lowest level has no torch shadow and no glare") {
    Renderer& renderer = test::patchRenderer();
    std::array<Solid, 2> solids;
    solids[0].toWorld = glm::scale(glm::mat4(1), vec3(2, 2, 1e-3f));
    solids[0].gloss = 0;
    solids[1].shape = SolidShape::cylinder;
    solids[1].toWorld = alongLine({0, -0.3f, 0.3f}, {0, 0.3f, 0.3f}, 0.1f);
    SceneView scene, without;
    scene.solids = solids;
    without.solids = std::span(solids).first(1);
    for (const PictureDetail level : {kLowDetail, kHighDetail}) {
        LookParameters look = atLevel(roomOnly(0), level);
        look.diffuse = 0.5f;
        look.lightPosition = {0, 0, 2};
        const vec3 eye(0.5f, 0, 0.5f);
        const float shaded = lightOf(renderer, scene, look, eye).g, lit = lightOf(renderer, without, look, eye).g;
        CHECK((level == kLowDetail ? shaded == lit : shaded < 0.2f * lit));
        SceneView arc, dark;
        arc.arc = {{0, 0, 0}, vec3(0.04f * 0.16f), 1e-3f};
        look.arcLight = 1;
        const vec3 beside(0.02f, 0, 0), from(0, 0, 0.4f);
        const float veil = lightOf(renderer, arc, look, from, beside).g,
                    none = lightOf(renderer, dark, look, from, beside).g;
        CHECK((level == kLowDetail ? veil == none : veil > none + 0.02f));
    }
}

TEST_CASE("a weld's picture differs by the level, and by each measure that is left out where it shows") {
    test::context();
    const test::SyntheticWeld weld;
    SceneView scene = weld.rippledView();
    MaterialLooks looks = *scene.looks;
    looks.millScale = 1;
    scene.looks = &looks;
    scene.rolled.parts[0] = {{-0.04f, -0.008f, -0.02f}, {0.04f, 0, 0.02f}, {0, 1, 0}};
    scene.rolled.count = 1;
    scene.rolled.across = {0, 1, 1};
    const std::vector<glm::vec4> carriers(OXIDE_STRIDE, {0.013f, 0.001f, 0.001f, 2000.0f});
    const gl::Buffer carried("carriers", std::span<const glm::vec4>(carriers));
    scene.particles.positions = &carried;
    scene.particles.count = carriers.size();
    scene.oxideRadius = 0.0015f;
    Solid torch;
    torch.shape = SolidShape::cylinder;
    torch.toWorld = scene.modelToWorld * alongLine({0.010f, 0.06f, 0}, {0.010f, 0.001f, 0}, 0.006f);
    scene.solids = {&torch, 1};
    Solid fitting, furniture;
    fitting.toWorld = glm::translate(glm::mat4(1), {0.006f, 0.006f, -0.004f}) * glm::scale(glm::mat4(1), vec3(0.002f));
    furniture.toWorld = glm::translate(glm::mat4(1), {0.0f, 0.0f, -0.02f}) * glm::scale(glm::mat4(1), vec3(0.01f));
    scene.fittings = {&fitting, 1};
    scene.furniture = {&furniture, 1};
    scene.room.shown = true;
    const Spark spark{{0.020f, 0.003f, 0.002f}, 0.0004f, {0.0002f, 0.001f, 0}, 2000};
    scene.effects = {{&spark, 1}, 0, {20}};
    scene.arc = {{0.015f, 0.003f, 0}, vec3(0.3f), 1e-3f};
    const View ahead = viewFrom({0.036f, 0.010f, 0.007f}); // a view of the pool
    const View behind =
        FreeCamera({0.003f, 0.009f, 0.007f}, {-0.01f, 0.0015f, 0}).view({.nearest = 0.002f}, 160.0f / 120);
    LookParameters look;
    for (const MeasureRow& row : kMeasures) {
        INFO(row.key);
        const View& view = row.measure == DetailFeature::ripples ? behind : ahead;
        look.leftOut = 0;
        const Image high = pictureOf(scene, look, {&view, 1});
        look.leftOut = bitOf(row.measure);
        CHECK(compareImages(high, pictureOf(scene, look, {&view, 1}), 2).largest > 2);
    }
    look.leftOut = 0;
    const Image high = pictureOf(scene, look, {&ahead, 1});
    CHECK(compareImages(high, pictureOf(scene, atLevel(look, kLowDetail), {&ahead, 1}), 2).largest > 2);
}

TEST_CASE("at every level both eyes by one submission see what each sees alone") {
    test::context();
    const test::SyntheticWeld weld;
    SceneView scene = weld.view();
    scene.arc = {{0.015f, 0.003f, 0}, vec3(0.3f), 1e-3f};
    const std::array<View, 2> eyes{viewFrom({0.036f, 0.010f, 0.007f}), viewFrom({0.037f, 0.010f, 0.004f})};
    for (const PictureDetail level : {kLowDetail, kMediumDetail}) {
        INFO("level " << level);
        const LookParameters look = atLevel({}, level);
        const Image both = pictureOf(scene, look, eyes);
        for (size_t i = 0; i < 2; ++i) {
            const Image alone = pictureOf(scene, look, {&eyes[i], 1});
            Image half{160, 120, {}};
            for (size_t y = 0; y < 120; ++y) {
                const auto row = both.rgb.begin() + std::ptrdiff_t((y * 320 + i * 160) * 3);
                half.rgb.insert(half.rgb.end(), row, row + 160 * 3);
            }
            CHECK(compareImages(alone, half, 16).farPixels < 0.002);
        }
    }
}

} // namespace meltpool
