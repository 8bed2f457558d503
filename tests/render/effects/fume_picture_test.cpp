// Puffs of smoke in pictures: lit by the arc and by the room, next to the pool and never in front of it, one ball for
// both eyes.
#include "core/render/camera.hpp"
#include "core/render/look/measures.hpp"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace meltpool {

namespace {

constexpr int kSize = 96;
constexpr float kFar = 0.3f; // m from the eye to the arc

FumePuff puffAt(glm::vec3 place, float radius, float depth) {
    return {place, radius, {0, radius, 0}, depth, {3, 4, 5}, 0};
}

LookParameters smokeOnly() {
    LookParameters look = test::roomOnly(0.4f);
    look.showSource = true;
    look.leftOut = bitOf(DetailFeature::glare);
    return look;
}

/// Returns the light of the pixels in front of the arc at the origin, row after row from below, from an eye `beside`
/// the middle.
std::vector<float> lightSeen(const SceneView& scene, const LookParameters& look, float beside = 0) {
    const View view = FreeCamera({beside, 0, kFar}, {beside, 0, 0}).view({}, 1); // both eyes look in one direction
    return test::lightOfPixels(test::patchRenderer(), scene, look, view, kSize);
}

std::vector<float> gained(const std::vector<float>& with, const std::vector<float>& without) {
    std::vector<float> gain(with);
    for (size_t i = 0; i < gain.size(); ++i)
        gain[i] -= without[i];
    return gain;
}

double sum(const std::vector<float>& light) {
    double all = 0;
    for (const float each : light)
        all += double(each);
    return all;
}

/// Returns the column and row of the light's middle.
glm::dvec2 middleOf(const std::vector<float>& light) {
    glm::dvec2 at(0);
    for (size_t i = 0; i < light.size(); ++i)
        at += double(light[i]) * glm::dvec2(double(i % kSize) + 0.5, double(i / kSize) + 0.5);
    return at / sum(light);
}

/// Returns the number of pixels that a metre at the arc's distance spans.
double pixelsAMetre() {
    const View view = FreeCamera({0, 0, kFar}, {0, 0, 0}).view({}, 1);
    return 0.5 * kSize * double(view.eyeToClip[1][1]) / double(kFar);
}

} // namespace

TEST_CASE("a puff above the arc is lit by it and by the room, and is switched off", "[effects]") {
    SceneView scene;
    LookParameters look = smokeOnly();
    const auto none = lightSeen(scene, look);
    const std::array<FumePuff, 1> puffs{puffAt({0, 0.06f, 0}, 0.02f, 0.2f)};
    scene.effects.fume.puffs = puffs;
    const auto roomLit = gained(lightSeen(scene, look), none);
    CHECK(sum(roomLit) > 1);
    scene.arc = {{0, 0, 0}, glm::vec3(5e-2f), 1e-3f};
    const auto arcLit = gained(lightSeen(scene, look), none);
    CHECK(sum(arcLit) > 2 * sum(roomLit));
    CHECK(middleOf(arcLit).y > 0.5 * kSize + 0.04 * pixelsAMetre());
    // A nearer arc gives a brighter puff.
    const std::array<FumePuff, 1> farther{puffAt({0, 0.1f, 0}, 0.02f, 0.2f)};
    scene.effects.fume.puffs = farther;
    CHECK(sum(gained(lightSeen(scene, look), none)) < 0.7 * sum(arcLit));
    scene.effects.fume.puffs = puffs;
    const auto showsNone = [&](const LookParameters& other) {
        SceneView clear = scene;
        clear.effects = {};
        return lightSeen(scene, other) == lightSeen(clear, other);
    };
    CHECK_FALSE(showsNone(look));
    LookParameters off = look;
    off.fume = false;
    CHECK(showsNone(off));
    off = look;
    off.detail = kLowDetail;
    CHECK(showsNone(off));
    off = look;
    off.leftOut |= bitOf(DetailFeature::fume);
    CHECK(showsNone(off));
    off = look;
    off.colours = kTemperatureColours;
    CHECK(showsNone(off));
}

TEST_CASE("no smoke is drawn before the pool, whatever stands between it and the eye", "[effects]") {
    SceneView scene;
    const LookParameters look = smokeOnly();
    const glm::vec3 pool(0.01f, 0, 0);
    scene.arc = {pool, glm::vec3(5e-2f), 1e-3f};
    const auto none = lightSeen(scene, look);
    const std::array<FumePuff, 2> puffs{puffAt({0.01f, 0, 0}, 0.05f, 1), puffAt({0.005f, 0.01f, 0.1f}, 0.05f, 1)};
    scene.effects.fume.puffs = puffs;
    scene.effects.fume.pool = pool;
    const auto gain = gained(lightSeen(scene, look), none);
    size_t clear = 0, veiled = 0;
    for (size_t i = 0; i < gain.size(); ++i) {
        const glm::dvec2 at(double(i % kSize) + 0.5, double(i / kSize) + 0.5);
        const double beside =
            glm::distance(at, glm::dvec2(0.5 * kSize) + double(pool.x) * glm::dvec2(pixelsAMetre(), 0)) /
            pixelsAMetre();
        if (beside < 0.0115) {
            CHECK(gain[i] == 0);
            ++clear;
        }
        if (beside > 0.03 && beside < 0.04 && gain[i] > 0.05f) ++veiled;
    }
    CHECK(clear > 10);
    CHECK(veiled > 50);
}

TEST_CASE("both eyes see a puff where it is", "[effects]") {
    const LookParameters look = smokeOnly();
    SceneView scene;
    const auto none = lightSeen(scene, look);
    const std::array<FumePuff, 1> puffs{puffAt({0, 0.04f, 0.05f}, 0.02f, 0.3f)};
    scene.effects.fume.puffs = puffs;
    constexpr float kApart = 0.03f;
    const auto left = gained(lightSeen(scene, look, -0.5f * kApart), none),
               right = gained(lightSeen(scene, look, 0.5f * kApart), none);
    // A point before the arc's plane has a larger offset between both pictures than one in the plane.
    const double apart = middleOf(left).x - middleOf(right).x;
    CHECK(apart == Approx(double(kApart) * pixelsAMetre() * double(kFar) / (double(kFar) - 0.05)).margin(0.35));
    CHECK(middleOf(left).y == Approx(middleOf(right).y).margin(0.2));
    CHECK(sum(left) == Approx(sum(right)).epsilon(0.05));
}

TEST_CASE("smoke ends softly at workpiece and table", "[effects]") {
    const LookParameters look = smokeOnly();
    SceneView scene;
    const auto none = lightSeen(scene, look);
    const std::array<FumePuff, 1> puffs{puffAt({0, 0.05f, 0}, 0.02f, 0.3f)};
    scene.effects.fume.puffs = puffs;
    const double whole = sum(gained(lightSeen(scene, look), none));
    // As a plate's face approaches from behind, less smoke remains in front of it, and the last part vanishes
    // gradually.
    double before = whole;
    for (const float behind : {-0.025f, -0.015f, -0.01f, -0.005f, -0.001f, 0.001f}) {
        const std::array<WorkpieceBlock, 1> plate{WorkpieceBlock{{-0.1f, -0.1f, behind - 0.02f}, {0.1f, 0.1f, behind}}};
        scene.blocks = plate;
        const double now = sum(gained(lightSeen(scene, look), none));
        INFO("a plate " << -behind << " m behind the puff's middle");
        CHECK(now <= before * 1.0001);
        CHECK(now > before - 0.55 * whole);
        before = now;
    }
    CHECK(before < 0.05 * whole);
}

} // namespace meltpool
