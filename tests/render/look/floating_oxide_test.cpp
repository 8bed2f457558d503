// Islands of oxide on a pool: they move with the particles that carry them, and exist where those are liquid and near
// the surface.
#include "shaders/shared/render.h"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/vec4.hpp>

#include <vector>

namespace meltpool {

namespace {

using glm::vec3;
using glm::vec4;

constexpr float kRadius = 0.0011f, kHot = 1900, kCold = 1500;

/// Particles of which one in each OXIDE_STRIDE carries an island. The carrier is unknown here, so all particles of a
/// block are at one place.
class Particles {
  public:
    explicit Particles(const std::vector<vec4>& blocks) : count_(blocks.size() * OXIDE_STRIDE) {
        std::vector<vec4> all;
        for (const vec4& block : blocks)
            all.insert(all.end(), OXIDE_STRIDE, block);
        buffer_ = gl::Buffer("oxide particles", std::span<const vec4>(all));
    }
    ParticleView view() const {
        ParticleView view;
        view.positions = &buffer_;
        view.count = count_;
        return view;
    }

  private:
    size_t count_;
    gl::Buffer buffer_;
};

MaterialLooks steel() {
    MaterialLooks looks;
    looks.heatTint = 1;
    looks.liquidEmissivity = 0.35f;
    looks.scaledEmissivity = 0.85f;
    return looks;
}

/// Returns the glow of a pool in the plane z = 0 at `x` (m), seen from straight above.
float glowAt(const std::vector<vec4>& blocks, float x, PictureDetail detail = kHighDetail, float radius = kRadius) {
    static const MaterialLooks looks = steel();
    test::context();
    const test::Patch pool(kHot, kHot);
    const Particles particles(blocks);
    SceneView scene = pool.scene(looks);
    scene.particles = particles.view();
    scene.oxideRadius = radius;
    LookParameters look = test::roomOnly(0);
    look.detail = detail;
    look.glowSoftening = 0;
    look.exposure = 5e-4f;
    return test::lightOf(test::patchRenderer(), scene, look, {x + 1e-5f, 0, 0.2f}, {x, 0, 0}).g;
}

} // namespace

TEST_CASE("an island glows as scale does amid the mirror of the pool, and moves with the particle that carries it") {
    const float pool = glowAt({{0, 0, 0, kCold}}, 0);
    for (const float x : {-0.008f, 0.0f, 0.005f}) {
        const std::vector<vec4> carrier{{x, 0, -0.0003f, kHot}};
        INFO("carrier at " << x << " m");
        CHECK(glowAt(carrier, x) / pool == Approx((1 - 0.15f * 1.5f) / 0.35f).epsilon(0.03)); // molten scale
        for (const float away : {-0.004f, 0.002f, 0.004f})
            CHECK(glowAt(carrier, x + away) == Approx(pool).epsilon(0.001));
    }
}

TEST_CASE("the deeper its carrier lies the smaller an island is, until there is none") {
    const float pool = glowAt({{0, 0, 0, kCold}}, 0);
    const auto width = [&](float depth) {
        int covered = 0;
        for (float x = -0.002f; x <= 0.002f; x += 0.0001f)
            covered += glowAt({{0, 0, -depth, kHot}}, x) > 1.5f * pool ? 1 : 0;
        return 1e-4f * float(covered);
    };
    const float shallow = width(0.0002f), deeper = width(0.0006f);
    INFO("wide " << shallow << " m near the surface, " << deeper << " m deeper");
    CHECK(shallow > 0.001f);
    CHECK(shallow < 0.0035f);
    CHECK(deeper < shallow);
    CHECK(width(0.0025f) == 0);
}

TEST_CASE("no island is carried by solid metal, without oxide in the weld, and below high detail") {
    const float pool = glowAt({{0, 0, 0, kCold}}, 0);
    const std::vector<vec4> carrier{{0, 0, -0.0003f, kHot}};
    CHECK(glowAt(carrier, 0) > 1.5f * pool);
    CHECK(glowAt({{0, 0, -0.0003f, kCold}}, 0) == pool);
    CHECK(glowAt({{0, 0, -0.0003f, 2350}}, 0) == Approx(pool).epsilon(0.001)); // directly under the arc
    CHECK(glowAt(carrier, 0, kHighDetail, 0) == pool);
    for (const PictureDetail detail : {kLowDetail, kMediumDetail})
        CHECK(glowAt(carrier, 0, detail) == glowAt(carrier, 0, detail, 0));
}

TEST_CASE("of more carriers than the list holds the first count, every time") {
    std::vector<vec4> blocks(700, vec4(0.1f, 0, 0, kHot));
    blocks[OXIDE_MOST - 1] = {-0.005f, 0, -0.0003f, kHot};
    blocks[OXIDE_MOST] = {0.005f, 0, -0.0003f, kHot};
    const float pool = glowAt({{0, 0, 0, kCold}}, 0);
    for (int again = 0; again < 3; ++again) {
        CHECK(glowAt(blocks, -0.005f) > 1.5f * pool);
        CHECK(glowAt(blocks, 0.005f) == Approx(pool).epsilon(0.001));
    }
    // Solid particles use no capacity.
    for (size_t i = 0; i < OXIDE_MOST / 2; ++i)
        blocks[i].w = kCold;
    CHECK(glowAt(blocks, 0.005f) > 1.5f * pool);
}

} // namespace meltpool
