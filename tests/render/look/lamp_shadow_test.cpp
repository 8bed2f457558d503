// The torch's shadow in the lamp's light: the exact share of a disc, the width of the penumbra, and no shadow without a
// torch.
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kLampFar = 2, kLampRadius = 0.2; // model units
constexpr double kHigh = 0.3, kRadius = 0.05;     // height of the bar over the plate, and its radius

/// Returns the light of a plate at x = `place` under a lamp above the origin, with or without a bar along y over it.
double lightUnderBar(Renderer& renderer, double place, bool withBar, float radius = float(kRadius)) {
    std::array<Solid, 2> solids;
    solids[0].toWorld = glm::scale(glm::mat4(1), glm::vec3(2, 2, 1e-3f));
    solids[0].colour = glm::vec3(0.8f);
    solids[0].gloss = 0;
    solids[1].shape = SolidShape::cylinder;
    solids[1].toWorld = alongLine({0, -0.3f, float(kHigh)}, {0, 0.3f, float(kHigh)}, 2 * radius);
    SceneView scene;
    scene.solids = std::span(solids).first(withBar ? 2 : 1);
    LookParameters look = test::roomOnly(0);
    look.diffuse = 0.5f;
    look.lightPosition = {0, 0, float(kLampFar)};
    const auto x = static_cast<float>(place);
    return double(test::lightOf(renderer, scene, look, {x + 0.5f, 0, 0.5f}, {x, 0, 0}).g);
}

/// Returns the share of a disc on one side of a straight line, whose signed distance from the centre is `x` radii.
double discShare(double x) {
    x = std::clamp(x, -1.0, 1.0);
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
}

} // namespace

TEST_CASE(
    "the torch's shadow is the share of the lamp's disc that it covers, dark in the middle and soft at its edge") {
    Renderer& renderer = test::evenlyLit(0);
    double dark = -1, lit = -1;
    for (int mm = 0; mm <= 200; mm += 2) {
        const double place = mm * 1e-3;
        const double share = lightUnderBar(renderer, place, true) / lightUnderBar(renderer, place, false);
        // The bar covers a part of the lamp's disc as seen from the plate.
        const double gap = place * (kLampFar - kHigh) / std::hypot(place, kLampFar),
                     lamp = kLampRadius * kHigh / kLampFar;
        INFO(mm << " thousandths from under the bar");
        CHECK(share == Approx(1 - discShare((gap + kRadius) / lamp) + discShare((gap - kRadius) / lamp)).margin(0.02));
        if (share < 0.002) dark = place;
        if (lit < 0 && share > 0.998) lit = place;
    }
    CHECK(dark > 0.015);
    // The penumbra is the light source's diameter times (bar to plate) over (lamp to bar).
    CHECK(lit - dark == Approx(2 * kLampRadius * kHigh / (kLampFar - kHigh)).epsilon(0.1));
}

TEST_CASE("a wire thinner than the lamp looks from the plate takes only its share of the light") {
    Renderer& renderer = test::evenlyLit(0);
    const double radius = 0.006, lamp = kLampRadius * kHigh / kLampFar;
    const double share =
        lightUnderBar(renderer, 0, true, float(radius)) / lightUnderBar(renderer, 0, false, float(radius));
    CHECK(share == Approx(1 - discShare(radius / lamp) + discShare(-radius / lamp)).margin(0.02));
}

} // namespace meltpool
