// The arc's light on the table: none under the plate, full light far from it, and a soft edge between.
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <array>

namespace meltpool {

namespace {

constexpr int kSize = 201;  // pixels, one a millimetre
constexpr float kUnit = 25; // world units a metre, as in lessons

/// Draws a table 12 mm under the upper face of an undrawn plate of 50 x 50 x 6 mm, with an arc 20 mm over the plate,
/// seen from straight above.
Image tableUnder(std::span<const WorkpieceBlock> blocks, bool burns) {
    static Renderer renderer(test::shaders());
    SceneView scene;
    scene.modelToWorld = glm::scale(glm::rotate(glm::mat4(1), 0.4f, glm::vec3(0, 1, 0)), glm::vec3(kUnit));
    scene.blocks = blocks;
    scene.arc.position = {0, 0.02f, 0};
    scene.arc.intensity = glm::vec3(burns ? 0.002f : 0.0f);
    Solid table;
    table.toWorld =
        scene.modelToWorld * glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, -0.022f, 0)), {1, 0.02f, 1});
    table.gloss = 0;
    scene.solids = {&table, 1};
    LookParameters look;
    look.arcLight = 1;
    look.showBox = look.showSky = look.showSource = false;
    View view;
    view.worldToEye =
        glm::lookAt(glm::vec3(0, 10, 0), glm::vec3(0), glm::vec3(scene.modelToWorld * glm::vec4(0, 0, -1, 0)));
    const float half = 0.1f * kUnit;
    view.eyeToClip = glm::ortho(-half, half, -half, half, 1.0f, 20.0f);
    view.eye = {0, 1e4f, 0}; // so far away that rays are parallel and the arc's glare vanishes
    const PictureTarget target(kSize, kSize, 1);
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    return target.read();
}

/// Returns the green of the table `mm` along the workpiece's x from the point under the arc.
int greenAt(const Image& image, int mm) {
    return image.rgb[static_cast<size_t>(((kSize / 2) * kSize + kSize / 2 + mm) * 3 + 1)];
}

} // namespace

TEST_CASE("the arc's light does not shine through the plate onto the table", "[render]") {
    test::context();
    const std::array<WorkpieceBlock, 1> plate{{{glm::vec3(-0.025f, -0.006f, -0.025f), glm::vec3(0.025f, 0, 0.025f)}}};
    const Image dark = tableUnder(plate, false), shaded = tableUnder(plate, true), open = tableUnder({}, true);
    for (const int mm : {0, 10, 20, -20, 30}) {
        INFO(mm << " mm beside the arc, under the plate or in its shadow");
        CHECK(greenAt(open, mm) > greenAt(dark, mm) + 15);
        CHECK(greenAt(shaded, mm) == greenAt(dark, mm));
    }
    for (const int mm : {48, 60, 90, -60}) {
        INFO(mm << " mm beside the arc, where it is seen past the plate");
        CHECK(greenAt(shaded, mm) == greenAt(open, mm));
    }
    bool soft = false;
    for (int mm = 31; mm < 48; ++mm) {
        CHECK(greenAt(shaded, mm) >= greenAt(dark, mm));
        CHECK(greenAt(shaded, mm) <= greenAt(open, mm));
        soft = soft || (greenAt(shaded, mm) > greenAt(dark, mm) + 2 && greenAt(shaded, mm) < greenAt(open, mm) - 2);
    }
    CHECK(soft);
}

} // namespace meltpool
