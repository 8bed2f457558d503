// The section: its axes, its sizes against the field it was made of, its picture.
#include "core/render/renderer.hpp"
#include "core/render/section.hpp"
#include "core/render/view/camera.hpp"
#include "core/render/view/picture_target.hpp"
#include "tests/render/synthetic_weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <functional>

namespace meltpool {

namespace {

constexpr double kFused = 1768;

/// The largest value below `limit` at which `peak` still reaches kFused; peak falls outwards.
double reachOf(const std::function<double(double)>& peak, double limit) {
    double low = 0, high = limit;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (peak(middle) >= kFused ? low : high) = middle;
    }
    return low;
}

SceneView cutWeld(const test::SyntheticWeld& weld) {
    SceneView scene = weld.view();
    scene.section.shown = true;
    scene.section.point = {-0.01f, 0, 0};
    scene.section.normal = {1, 0, 0};
    scene.section.heat = &weld.heat();
    scene.section.spacing = 0.0005f;
    return scene;
}

} // namespace

TEST_CASE("the section's axes lie in its plane and its rectangle holds the box's cut") {
    for (const glm::vec3 normal :
         {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, -2, 0.5f), glm::vec3(0, 0, -3)}) {
        SectionView section;
        section.normal = normal;
        const SectionFrame frame = sectionFrame(section, glm::vec3(-1), glm::vec3(2));
        CHECK(std::abs(glm::dot(frame.across, normal)) < 1e-5f);
        CHECK(std::abs(glm::dot(frame.up, normal)) < 1e-5f);
        CHECK(glm::length(frame.across) == Approx(1));
        CHECK(glm::length(frame.up) == Approx(1));
        CHECK(std::abs(frame.across.y) < 1e-5f);
        CHECK(frame.up.y >= -1e-5f);
        CHECK(frame.size.x >= 3.0f);
    }
}

TEST_CASE("the fusion zone's width, depth and area are those of the field, and the picture is its golden") {
    test::context();
    const test::SyntheticWeld weld;
    const SceneView scene = cutWeld(weld);
    Renderer renderer(test::shaders());
    const PictureTarget target(320, 240, 4);
    const View view =
        FreeCamera({0.016f, 0.010f, 0.006f}, {-0.01f, -0.0015f, 0.0f}).view({.nearest = 0.002f}, 320.0f / 240);
    LookParameters look;
    look.showBox = false;
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    CHECK(test::matchesGolden("render/section", target.read()));

    const SectionZone zone = renderer.measureSection(kFused, 0);
    const double behind = 0.015 + 0.01;
    const double half = reachOf([&](double z) { return test::weldPeak(behind, z, 0.00025); }, 0.01);
    const double deep = reachOf([&](double y) { return test::weldPeak(behind, 0, y); }, 0.01);
    CHECK(zone.width == Approx(2 * half).margin(0.0004));
    CHECK(zone.depth == Approx(deep).margin(0.0003));
    // below the plate the zone is half a disc; over it the bead's arch, 1.6 mm high and 8 mm wide
    const double disc = 0.5 * 3.14159265 * deep * half;
    const double arch = 0.0016 * 0.008 * 2 / 3;
    CHECK(zone.area > disc);
    CHECK(zone.area < (disc + arch) * 1.1);
    const SectionZone affected = renderer.measureSection(996, 0);
    CHECK(affected.area > zone.area);
    CHECK(affected.width > zone.width);
    CHECK(renderer.measureSection(9000, 0).area == 0);
}

} // namespace meltpool
