// Pictures drawn tile by tile: equal to pictures drawn at once, in any size, with the light of finer pixels averaged.
#include "core/render/camera.hpp"
#include "core/render/large_picture.hpp"
#include "core/render/picture_target.hpp"
#include "tests/render/look/patch.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

TEST_CASE("the largest size of a shape is found in both directions") {
    CHECK(fitInto({1280, 720}, {3840, 2160}) == glm::ivec2(3840, 2160));
    CHECK(fitInto({1280, 800}, {3840, 2160}) == glm::ivec2(3456, 2160));
    CHECK(fitInto({1000, 100}, {3840, 2160}) == glm::ivec2(3840, 384));
    CHECK(fitInto({5000, 1}, {3840, 2160}) == glm::ivec2(3840, 1));
    CHECK(fitInto({0, 0}, {10, 10}) == glm::ivec2(10, 10));
}

TEST_CASE("tiles of a picture show what the whole picture shows, also where they reach over its edge") {
    test::context();
    const test::SyntheticWeld weld;
    const SceneView scene = weld.view();
    const LookParameters look;
    const glm::ivec2 size(150, 90);
    View view = FreeCamera({0.016f, 0.010f, 0.007f}, {-0.01f, -0.0015f, 0}).view({.nearest = 0.002f}, 150.0f / 90);
    view.eyeToClip[2][0] -= 0.2f; // off centre, as next to panels
    Renderer& renderer = test::patchRenderer();
    const auto draw = [&](const View& part, const RenderTarget& target) {
        renderer.draw(scene, look, {&part, 1}, target, nullptr);
    };
    const PictureTarget target(size.x, size.y);
    draw(view, target.target());
    const Image whole = target.read();
    int tiles = 0;
    const auto counted = [&](const View& part, const RenderTarget& into) {
        ++tiles;
        draw(part, into);
    };
    const Image tiled = drawLargePicture({size, 1, 1, {64, 64}}, view, counted);
    CHECK(tiles == 3 * 2);
    REQUIRE(tiled.width == size.x);
    REQUIRE(tiled.height == size.y);
    CHECK(compareImages(whole, tiled, 16).farPixels < 0.01); // edges fall on other sides of a pixel's centre
    const Image fine = drawLargePicture({size, 2, 4, {64, 64}}, view, draw);
    CHECK(fine.width == size.x);
    const double jagged = compareImages(whole, fine, 0).mean;
    CHECK(jagged > 0);
    CHECK(jagged < 4);
}

TEST_CASE("particles drawn as points are whole where tiles meet") {
    test::context();
    const test::SyntheticWeld weld;
    const SceneView scene = weld.view();
    LookParameters look;
    look.mode = kPointsMode;
    look.pointSize = 0.0006f;
    const glm::ivec2 size(120, 90);
    const View view =
        FreeCamera({0.016f, 0.010f, 0.007f}, {-0.01f, -0.0015f, 0}).view({.nearest = 0.002f}, 120.0f / 90);
    const auto pictureBy = [&](glm::ivec2 tile, int margin) {
        return drawLargePicture({size, 1, 1, tile, margin}, view, [&](const View& part, const RenderTarget& target) {
            test::patchRenderer().draw(scene, look, {&part, 1}, target, nullptr);
        });
    };
    const Image whole = pictureBy(size, 0);
    const double cut = compareImages(whole, pictureBy({30, 30}, 0), 16).farPixels;
    const double kept = compareImages(whole, pictureBy({30, 30}, 12), 16).farPixels;
    CHECK(kept < 0.01);
    CHECK(cut > 2 * kept);
}

TEST_CASE("the light of finer pixels is averaged, not their displayed values") {
    const auto stripes = [](const View&, const RenderTarget& target) {
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        glEnable(GL_SCISSOR_TEST);
        for (int x = 0; x < target.viewport.width; ++x) {
            glScissor(x, 0, 1, target.viewport.height);
            const float light = x % 2 == 0 ? 0.0f : 1.0f;
            glClearColor(light, light, light, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
    };
    const Image grey = drawLargePicture({{8, 4}, 2, 1, {8, 4}}, {}, stripes);
    for (const std::uint8_t channel : grey.rgb)
        CHECK(int(channel) == 188); // half of the light
    const Image same = drawLargePicture({{8, 4}, 1, 1, {3, 3}}, {}, [](const View&, const RenderTarget& target) {
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glClearColor(7 / 255.0f, 100 / 255.0f, 250 / 255.0f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    });
    CHECK(int(same.rgb[0]) == 7);
    CHECK(int(same.rgb[1]) == 100);
    CHECK(int(same.rgb[2]) == 250);
}

} // namespace meltpool
