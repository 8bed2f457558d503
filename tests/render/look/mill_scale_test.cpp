// Mill scale on rolled faces: its darkness, the ground band along the seam, and faces without scale.
#include "shaders/shared/surface.h"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <array>
#include <vector>

namespace meltpool {

namespace {

using glm::vec3;

/// A sheet of 60 mm x 60 mm in the plane z = 0 that faces +z, with a vertex each mm, of one temperature and peak (K).
class Sheet {
  public:
    explicit Sheet(float temperature = 300, float peak = 300) {
        test::context();
        constexpr GLuint kCells = 60;
        std::vector<SurfaceVertex> vertices;
        std::vector<GLuint> indices;
        for (GLuint i = 0; i <= kCells; ++i)
            for (GLuint j = 0; j <= kCells; ++j)
                vertices.push_back(
                    {{0.001f * float(i) - 0.03f, 0.001f * float(j) - 0.03f, 0}, temperature, {0, 0, 1}, 0});
        for (GLuint i = 0; i < kCells; ++i)
            for (GLuint j = 0; j < kCells; ++j) {
                const GLuint a = i * (kCells + 1) + j, b = a + kCells + 1;
                indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
            }
        const std::vector<float> peaks(vertices.size(), peak);
        const SurfaceDraw draw{static_cast<uint>(indices.size()), 1, 0, 0, 0};
        vertices_ = gl::Buffer("sheet vertices", std::span<const SurfaceVertex>(vertices));
        indices_ = gl::Buffer("sheet indices", std::span<const GLuint>(indices));
        command_ = gl::Buffer("sheet command", std::span<const SurfaceDraw>(&draw, 1));
        peaks_ = gl::Buffer("sheet peaks", std::span<const float>(peaks));
    }

    /// Returns a scene with a plate 10 mm thick whose upper face is this sheet; its seam runs along x.
    SceneView scene(const MaterialLooks& looks) const {
        SceneView scene;
        scene.mesh = {&vertices_, &indices_, &command_, &peaks_};
        scene.temperature = {293.15f, 2500, true, test::kPatchSolidus, test::kPatchLiquidus};
        scene.looks = &looks;
        scene.rolled.parts[0] = {{-0.03f, -0.03f, -0.01f}, {0.03f, 0.03f, 0}, {0, 0, 1}};
        scene.rolled.count = 1;
        scene.rolled.across = {0, 1, 1};
        return scene;
    }

  private:
    gl::Buffer vertices_, indices_, command_, peaks_;
};

MaterialLooks rolledSteel() {
    MaterialLooks looks;
    looks.heatTint = 1;
    looks.millScale = 1;
    return looks;
}

/// Returns the light of the sheet `y` m from its seam in an even room, seen from straight above.
vec3 lightAt(const SceneView& scene, float y, PictureDetail detail = kHighDetail, float x = 0.003f) {
    LookParameters look = test::roomOnly(0.8f);
    look.detail = detail;
    return test::lightOf(test::evenlyLit(0.5f), scene, look, {x, y + 1e-4f, 0.3f}, {x, y, 0});
}

} // namespace

TEST_CASE("a rolled face is dark and a little blue, with a bright band of 20 mm along the seam") {
    const MaterialLooks looks = rolledSteel();
    const Sheet sheet;
    const SceneView scene = sheet.scene(looks);
    for (const PictureDetail detail : {kMediumDetail, kHighDetail}) {
        INFO("level " << detail);
        const vec3 ground = lightAt(scene, 0, detail), rolled = lightAt(scene, 0.018f, detail);
        CHECK(rolled.g < 0.4f * ground.g);
        CHECK(rolled.g > 0.1f * ground.g);
        CHECK(rolled.b > 1.1f * rolled.r);
        for (const float side : {-1.0f, 1.0f})
            for (const float x : {-0.02f, -0.007f, 0.0f, 0.011f, 0.024f}) {
                float y = 0; // border of the band
                while (y < 0.02f && lightAt(scene, side * y, detail, x).g > 0.5f * (ground.g + rolled.g))
                    y += 0.00025f;
                INFO("at x " << x << " the band ends at " << side * y);
                CHECK(y == Approx(0.01).margin(0.0015));
            }
    }
}

TEST_CASE("the band stays with the workpiece when it is turned") {
    const MaterialLooks looks = rolledSteel();
    const Sheet sheet;
    SceneView scene = sheet.scene(looks);
    const vec3 ground = lightAt(scene, 0), rolled = lightAt(scene, 0.018f);
    scene.modelToWorld = glm::rotate(glm::mat4(1), glm::radians(90.0f), vec3(0, 0, 1));
    CHECK(lightAt(scene, 0.018f, kHighDetail, 0).g == Approx(ground.g).epsilon(0.05)); // now along the seam
    CHECK(lightAt(scene, 0, kHighDetail, 0.018f).g == Approx(rolled.g).epsilon(0.05));
}

TEST_CASE("there is no mill scale on machined edges, other metals, metal that melted, and at low detail") {
    const MaterialLooks looks = rolledSteel(), pickled = [] {
        MaterialLooks bare;
        bare.heatTint = 1;
        return bare;
    }();
    const Sheet sheet, molten(300, 2000);
    constexpr float kAway = 0.018f;
    const float bare = lightAt(sheet.scene(pickled), kAway).g;
    SceneView edge = sheet.scene(looks), other = sheet.scene(looks);
    edge.rolled.parts[0].faces = {1, 0, 0};
    other.rolled.parts[0].low.y = other.rolled.parts[0].high.y = -0.03f; // its plate is elsewhere
    CHECK(lightAt(edge, kAway).g == Approx(bare).epsilon(1e-4));
    CHECK(lightAt(other, kAway).g == Approx(bare).epsilon(1e-4));
    CHECK(lightAt(sheet.scene(looks), kAway).g < 0.4f * bare);
    CHECK(lightAt(molten.scene(looks), kAway) == lightAt(molten.scene(looks), 0));
    CHECK(lightAt(sheet.scene(looks), kAway, kLowDetail) == lightAt(sheet.scene(pickled), kAway, kLowDetail));
}

} // namespace meltpool
