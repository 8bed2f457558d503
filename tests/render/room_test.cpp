// The workshop as geometry: objects of the room are at their places for each eye, and from the sky picture's viewpoint
// the room equals the sky.
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/render/workshop_painter.hpp"
#include "shaders/shared/render.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <array>
#include <cmath>

using namespace meltpool;

namespace {

constexpr int kSize = 384;

Renderer& renderer() {
    static Renderer only(test::shaders());
    return only;
}

LookParameters plainLook() {
    LookParameters look;
    look.showBox = look.showSource = false;
    return look;
}

/// Returns an empty scene in the room, which is 25 world units a metre and shifted, as at the desk.
SceneView emptyRoom() {
    SceneView scene;
    scene.room.shown = true;
    scene.room.toWorld = glm::translate(glm::scale(glm::mat4(1), glm::vec3(25)), {0.1f, 0.35f, -0.2f});
    return scene;
}

glm::vec3 placeInWorld(const SceneView& scene, glm::vec3 inRoom) {
    return scene.room.toWorld * glm::vec4(inRoom, 1);
}

/// Returns a view from `eye` (m of the room) towards `target`.
View eyeAt(const SceneView& scene, glm::vec3 eye, glm::vec3 target) {
    return FreeCamera(placeInWorld(scene, eye), placeInWorld(scene, target)).view({}, 1);
}

Image picture(const SceneView& scene, const LookParameters& look, std::span<const View> views) {
    const PictureTarget target(kSize * static_cast<int>(views.size()), kSize);
    renderer().draw(scene, look, views, target.target(), nullptr);
    CHECK(glGetError() == GL_NO_ERROR);
    return target.read();
}

/// Returns the brightness-weighted centre of the lit area in a column, pixels from its upper left corner; the weight's
/// sum in z.
glm::vec3 litMiddle(const Image& image, int column) {
    glm::dvec3 sum(0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double light = image.rgb[static_cast<size_t>((y * image.width + column * kSize + x) * 3 + 1)];
            if (light > 40) sum += light * glm::dvec3(x + 0.5, y + 0.5, 1);
        }
    return {sum.x / sum.z, sum.y / sum.z, sum.z};
}

glm::vec2 projected(const View& view, glm::vec3 world) {
    const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(world, 1);
    return {(0.5f + 0.5f * clip.x / clip.w) * kSize, (0.5f - 0.5f * clip.y / clip.w) * kSize};
}

/// A face of the cube map and a place on it, by OpenGL's table of faces.
struct CubePlace {
    int face;
    glm::vec2 place; ///< 0..1
};

CubePlace cubePlace(glm::vec3 d) {
    const glm::vec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) return {d.x > 0 ? 0 : 1, 0.5f + 0.5f * glm::vec2(d.x > 0 ? -d.z : d.z, -d.y) / a.x};
    if (a.y >= a.z) return {d.y > 0 ? 2 : 3, 0.5f + 0.5f * glm::vec2(d.x, d.y > 0 ? d.z : -d.z) / a.y};
    return {d.z > 0 ? 4 : 5, 0.5f + 0.5f * glm::vec2(d.z > 0 ? d.x : -d.x, -d.y) / a.z};
}

/// Paints a dark environment with one lit spot of two by two texels around this direction; returns the middle of the
/// spot.
glm::vec3 paintSpot(Renderer& painted, glm::vec3 direction) {
    const gl::Texture& cube = painted.environment();
    const int size = cube.shape().width;
    const std::array<float, 4> black{0, 0, 0, 1};
    glClearTexImage(cube.name(), 0, GL_RGBA, GL_FLOAT, black.data());
    const CubePlace at = cubePlace(direction);
    const glm::ivec2 texel(glm::round(at.place * float(size)) - 1.0f);
    std::array<float, 16> white{};
    white.fill(1);
    glTextureSubImage3D(cube.name(), 0, texel.x, texel.y, at.face, 2, 2, 1, GL_RGBA, GL_FLOAT, white.data());
    const glm::vec2 s = 2.0f * glm::vec2(texel + 1) / float(size) - 1.0f;
    REQUIRE((at.face == 3 || at.face == 5));
    return at.face == 3 ? glm::vec3(s.x, -1, -s.y) : glm::vec3(-s.x, -s.y, -1);
}

} // namespace

TEST_CASE("a place of the room is seen by each eye where it is") {
    Renderer& painted = renderer();
    const SceneView scene = emptyRoom();
    // The spots are on the floor under the metal's side, on the back wall, and on the front of the red cabinet.
    struct Spot {
        glm::vec3 towards;
        glm::vec3 normal;
        float distance; ///< distance of the plane along its normal
    };
    for (const Spot& spot : {Spot{{0.45f, -1, -0.35f}, {0, -1, 0}, 1.25f}, Spot{{0.6f, 0.5f, -1}, {0, 0, -1}, 3.6f},
                             Spot{{-0.60f, -0.28f, -1}, {0, 0, -1}, 2.85f}}) {
        const glm::vec3 way = paintSpot(painted, spot.towards);
        const glm::vec3 place = way * (spot.distance / glm::dot(way, spot.normal));
        const std::array<View, 2> eyes{eyeAt(scene, {0.268f, 0.30f, 0.45f}, place + glm::vec3(0.05f, 0.02f, 0)),
                                       eyeAt(scene, {0.332f, 0.30f, 0.45f}, place + glm::vec3(0.05f, 0.02f, 0))};
        const Image both = picture(scene, plainLook(), eyes);
        for (int eye = 0; eye < 2; ++eye) {
            const glm::vec3 lit = litMiddle(both, eye);
            const glm::vec2 expected = projected(eyes[static_cast<size_t>(eye)], placeInWorld(scene, place));
            INFO("eye " << eye << ": lit at " << lit.x << ", " << lit.y << "; expected at " << expected.x << ", "
                        << expected.y);
            REQUIRE(lit.z > 0);
            CHECK(glm::distance(glm::vec2(lit), expected) < 1);
        }
        // The sky shows the spot in one direction from any viewpoint, so at another place.
        SceneView infinite = scene;
        infinite.room.shown = false;
        const glm::vec3 sky = litMiddle(picture(infinite, plainLook(), eyes), 0);
        CHECK((sky.z == 0 || glm::distance(glm::vec2(sky), projected(eyes[0], placeInWorld(scene, place))) > 10));
    }
}

TEST_CASE(
    "the room looks as the sky from the place of its picture, alike to eyes at one place, and is no room outside") {
    test::context();
    Renderer drawn(test::shaders());
    const SceneView scene = emptyRoom();
    SceneView infinite = scene;
    infinite.room.shown = false;
    const auto draw = [&](const SceneView& shown, const LookParameters& look, std::span<const View> views) {
        const PictureTarget target(kSize * static_cast<int>(views.size()), kSize);
        drawn.draw(shown, look, views, target.target(), nullptr);
        return target.read();
    };
    for (const glm::vec3 target : {glm::vec3(0, -0.3f, -3), glm::vec3(-3, -0.2f, 1), glm::vec3(3, -0.6f, 1),
                                   glm::vec3(2.6f, 0.6f, 3.6f), glm::vec3(0.1f, -1, 0), glm::vec3(0.1f, 2, 0)}) {
        const std::array<View, 1> eye{eyeAt(scene, glm::vec3(0), target)};
        const ImageDifference same = compareImages(draw(infinite, plainLook(), eye), draw(scene, plainLook(), eye), 8);
        INFO("to " << target.x << ", " << target.y << ", " << target.z << ": mean " << same.mean << ", far "
                   << same.farPixels);
        CHECK(same.mean < 0.3);
        CHECK(same.farPixels < 0.003);
    }
    const View once = eyeAt(scene, {0.3f, 0.2f, 0.4f}, {0.5f, -0.4f, -3});
    const std::array<View, 2> twice{once, once};
    const Image pair = draw(scene, plainLook(), twice);
    int different = 0;
    for (int y = 0; y < pair.height; ++y)
        for (int x = 0; x < kSize * 3; ++x)
            different += pair.rgb[static_cast<size_t>(y * pair.width * 3 + x)] !=
                         pair.rgb[static_cast<size_t>((y * pair.width + kSize) * 3 + x)];
    CHECK(different < kSize * kSize / 1000); // rasterisation offsets differ between columns

    // With low detail, and for an eye outside the walls, the sky is drawn.
    LookParameters low = plainLook();
    low.detail = kLowDetail;
    const std::array<View, 1> aside{once};
    CHECK(compareImages(draw(scene, low, aside), draw(infinite, plainLook(), aside), 8).largest == 0);
    CHECK(compareImages(draw(scene, plainLook(), aside), draw(infinite, plainLook(), aside), 8).farPixels > 0.05);
    const std::array<View, 1> outside{eyeAt(scene, {0, 0, 6}, {0, 0, 0})};
    CHECK_FALSE(insideRoom(scene.room, outside));
    CHECK(compareImages(draw(scene, plainLook(), outside), draw(infinite, plainLook(), outside), 8).largest == 0);
}
