// The drawn ghost: the objects behind it remain visible, the objects in front hide it, and a visor shows it.
#include "core/scene/ghost_model.hpp"

#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace meltpool {

namespace {

constexpr int kSize = 128;

/// A ghost over a plate, in a world of 25 units to the metre, seen by two eyes.
struct Stage {
    Stage() {
        torch.tip = {0, 2e-3F, 0};
        torch.orientation = glm::angleAxis(-glm::radians(90.0F), glm::vec3(1, 0, 0));
        gtaw.choose<Gtaw>();
        plate.toWorld =
            toWorld * glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, -3e-3F, 0)), glm::vec3(0.12F, 6e-3F, 0.06F));
        plate.colour = {0.12F, 0.12F, 0.13F};
    }

    std::vector<Marker> ghost(float strength = 1, float size = 1) const {
        std::vector<Marker> markers;
        std::vector<Solid> parts;
        addGhostTorch(markers, parts, torch, gtaw, {}, strength, size, toWorld);
        return markers;
    }

    /// `side`: 1: seen from the welder's side, -1: from the other one.
    Image picture(std::span<const Marker> markers, LookParameters look = {}, bool hidden = false,
                  float side = 1) const {
        look.showSky = false;
        static Renderer renderer(test::shaders());
        const PictureTarget target(2 * kSize, kSize);
        std::vector<Solid> solids{plate};
        if (hidden) {
            Solid wall;
            wall.toWorld = toWorld * glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 0.05F, 0.05F)),
                                                glm::vec3(0.4F, 0.4F, 2e-3F));
            solids.push_back(wall);
        }
        SceneView scene;
        scene.modelToWorld = toWorld;
        scene.solids = solids;
        scene.ghost = markers;
        const glm::vec3 target0(0, 0.8F, 0);
        const std::array<View, 2> eyes{FreeCamera({-0.6F, 2.2F, 4 * side}, target0).view({}, 1),
                                       FreeCamera({0.6F, 2.2F, 4 * side}, target0).view({}, 1)};
        renderer.draw(scene, look, eyes, target.target(), nullptr);
        return target.read();
    }

    TorchSample torch;
    ProcessSettings gtaw;
    Solid plate;
    glm::mat4 toWorld = glm::scale(glm::mat4(1), glm::vec3(25));
};

int green(const Image& image, int x, int y) {
    return image.rgb[static_cast<size_t>(y * image.width + x) * 3 + 1];
}

/// Counts of one eye's pixels: those where the opaque torch differs clearly from the background, and those among them
/// that the ghost mixes.
struct Mixed {
    int torch = 0, between = 0, changed = 0;
};

Mixed mixedIn(int eye, const Image& behind, const Image& ghost, const Image& opaque) {
    Mixed found;
    for (int y = 0; y < kSize; ++y)
        for (int x = eye * kSize; x < (eye + 1) * kSize; ++x) {
            const int far = green(behind, x, y), near = green(opaque, x, y), seen = green(ghost, x, y);
            if (std::abs(far - near) < 40) continue;
            ++found.torch;
            found.between += seen >= std::min(far, near) - 2 && seen <= std::max(far, near) - 5 ? 1 : 0;
            found.changed += std::abs(seen - far) >= 5 ? 1 : 0;
        }
    return found;
}

} // namespace

TEST_CASE("in both eyes a ghost lies between what is behind it and an opaque torch") {
    const Stage stage;
    const std::vector<Marker> ghost = stage.ghost();
    REQUIRE(ghost.size() >= 3);
    for (const Marker& part : ghost)
        CHECK(part.opacity <= kGhostOpacity);
    std::vector<Marker> opaque = ghost;
    for (Marker& part : opaque)
        part.opacity = part.face = 1;
    const Image without = stage.picture({}), half = stage.picture(ghost), whole = stage.picture(opaque);
    for (const int eye : {0, 1}) {
        const Mixed mixed = mixedIn(eye, without, half, whole);
        INFO("eye " << eye << ": " << mixed.torch << " pixels, " << mixed.between << " between, " << mixed.changed
                    << " changed");
        CHECK(mixed.torch > 100);
        CHECK(mixed.between > 0.95 * mixed.torch);
        CHECK(mixed.changed > 0.95 * mixed.torch);
    }
    // A fading ghost is closer to its background.
    const double full = compareImages(without, half, 5).mean;
    CHECK(compareImages(without, stage.picture(stage.ghost(0.25F)), 5).mean < 0.5 * full);
}

TEST_CASE("a ghost is seen from both sides") {
    const Stage stage;
    std::vector<double> changed;
    for (const float side : {1.0F, -1.0F}) {
        const Image without = stage.picture({}, {}, false, side), with = stage.picture(stage.ghost(), {}, false, side);
        changed.push_back(compareImages(without, with, 5).farPixels);
        CHECK(changed.back() > 0.01);
    }
    CHECK(changed[1] == Approx(changed[0]).epsilon(0.2));
}

TEST_CASE("a wall before the ghost hides it, and the ghost hides no marker behind it") {
    const Stage stage;
    CHECK(compareImages(stage.picture({}, {}, true), stage.picture(stage.ghost(), {}, true), 0).largest == 0);
    // A sign entirely behind the ghost for both eyes is drawn later: the ghost leaves no depth.
    Marker sign;
    sign.shape = SolidShape::sphere;
    sign.toWorld =
        stage.toWorld * glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 0.03F, -0.02F)), glm::vec3(0.008F));
    sign.colour = {0, 1, 0};
    std::vector<Marker> both = stage.ghost();
    both.push_back(sign);
    const Image with = stage.picture(both), without = stage.picture(stage.ghost());
    int covered = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < 2 * kSize; ++x)
            covered += green(with, x, y) - green(without, x, y) > 20 && green(with, x, y) > 120 ? 1 : 0;
    CHECK(covered > 30);
}

TEST_CASE("through the visor the ghost is still seen, and its outline best") {
    const Stage stage;
    LookParameters dark;
    dark.visorShade = 10;
    const Image without = stage.picture({}, dark), with = stage.picture(stage.ghost(), dark);
    int seen = 0, outline = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < 2 * kSize; ++x) {
            const int more = green(with, x, y) - green(without, x, y);
            seen += more > 60 ? 1 : 0;
            outline = std::max(outline, more);
        }
    CHECK(seen > 200);
    CHECK(outline > 90);
}

TEST_CASE("the ghost's torch keeps its tip at any size") {
    const Stage stage;
    const auto lengthOf = [](const std::vector<Marker>& ghost) {
        float low = 1e9F, high = -1e9F;
        for (const Marker& part : ghost)
            for (const float end : {-0.5F, 0.5F}) {
                const float y = (part.toWorld * glm::vec4(0, 0, end, 1)).y;
                low = std::min(low, y);
                high = std::max(high, y);
            }
        return std::pair(low, high);
    };
    const auto [tip, handle] = lengthOf(stage.ghost());
    const auto [sameTip, nearHandle] = lengthOf(stage.ghost(1, 0.25F));
    CHECK(tip == Approx(0.05F)); // 2 mm in the world
    CHECK(sameTip == Approx(tip).margin(1e-5));
    CHECK(nearHandle - sameTip == Approx((handle - tip) / 4).margin(1e-4));
}

} // namespace meltpool
