// Lines of sight past solids: the share of a light that an eye sees past an arm, and the arc past the person's hands.
#include "core/render/line_of_sight.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>

using namespace meltpool;

namespace {

constexpr glm::vec3 kEye(0, 0, 0.5f), kLight(0, 0, 0);
constexpr float kRadius = 2e-3f;

Solid armAcross(float height, float z, SolidShape shape = SolidShape::pill) {
    Solid arm;
    arm.shape = shape;
    arm.toWorld = alongLine({-0.3f, height, z}, {0.3f, height, z}, 0.1f);
    return arm;
}

} // namespace

TEST_CASE("an arm in the line of sight hides a light, and one beside, behind or beyond does not", "[render]") {
    CHECK(seenPast(armAcross(0, 0.3f), kEye, kLight, kRadius) == 0);
    CHECK(seenPast(armAcross(0.06f, 0.3f), kEye, kLight, kRadius) == 1);
    CHECK(seenPast(armAcross(-0.06f, 0.3f), kEye, kLight, kRadius) == 1);
    CHECK(seenPast(armAcross(0, 0.7f), kEye, kLight, kRadius) == 1);
    CHECK(seenPast(armAcross(0, -0.2f), kEye, kLight, kRadius) == 1);
    Solid aside = armAcross(0, 0.3f); // ends before the line of sight
    aside.toWorld = alongLine({0.06f, 0, 0.3f}, {0.6f, 0, 0.3f}, 0.1f);
    CHECK(seenPast(aside, kEye, kLight, kRadius) == 1);
    aside.toWorld = alongLine({0.04f, 0, 0.3f}, {0.6f, 0, 0.3f}, 0.1f); // its round end is 4 cm beside
    CHECK(seenPast(aside, kEye, kLight, kRadius) == 1);
    aside.toWorld = alongLine({-0.02f, 0, 0.3f}, {0.6f, 0, 0.3f}, 0.1f);
    CHECK(seenPast(aside, kEye, kLight, kRadius) == 0);
    // A forearm that leads from the eye to the light.
    Solid along;
    along.shape = SolidShape::pill;
    along.toWorld = alongLine({0, 0, 0.4f}, {0, 0, 0.1f}, 0.1f);
    CHECK(seenPast(along, kEye, kLight, kRadius) == 0);
}

TEST_CASE("an edge hides a light bit by bit, and a thin wire only as much as its width", "[render]") {
    double last = 0;
    for (const float height : {0.049f, 0.0495f, 0.05f, 0.0505f, 0.051f}) { // the light's cone has 0.8 mm there
        const auto share = static_cast<double>(seenPast(armAcross(height, 0.2f), kEye, kLight, kRadius / 0.6f * 0.4f));
        CHECK(share >= last);
        last = share;
    }
    CHECK(seenPast(armAcross(0.05f, 0.3f), kEye, kLight, kRadius) == Approx(0.5).margin(0.01));
    CHECK(last > 0.9);
    Solid wire;
    wire.shape = SolidShape::cylinder;
    wire.toWorld = alongLine({-0.1f, 0, 0.002f}, {0.1f, 0, 0.002f}, 0.8e-3f);
    const float share = seenPast(wire, kEye, kLight, kRadius);
    CHECK(share > 0.7f);
    CHECK(share < 0.8f); // a strip of a fifth of the disc's width across its middle
}

TEST_CASE("a flat palm hides as much as its width on the side that the eye sees", "[render]") {
    Solid palm;
    palm.shape = SolidShape::pill;
    const auto turned = [&](float angle) { // about its length, which is x
        const glm::mat4 place = glm::rotate(glm::translate(glm::mat4(1), {0, 0.03f, 0.3f}), angle, {1, 0, 0});
        palm.toWorld = place * glm::mat4({0, 0.04f, 0, 0}, {0, 0, 0.08f, 0}, {0.11f, 0, 0, 0}, {0, 0, 0, 1});
        return seenPast(palm, kEye, kLight, kRadius);
    };
    CHECK(turned(0) == 1);       // 4 cm high
    CHECK(turned(1.5708f) == 0); // 8 cm high
    CHECK(turned(-1.5708f) == 0);
}

TEST_CASE("a bend hides what its rod hides", "[render]") {
    Solid neck;
    neck.shape = SolidShape::bend; // from the origin along +z, to +x
    neck.toWorld = glm::translate(glm::mat4(1), {-0.01f, 0, 0.25f}) * glm::scale(glm::mat4(1), glm::vec3(0.02f));
    neck.toWorld = neck.toWorld * glm::mat4({0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}); // along +x, to +y
    CHECK(seenPast(neck, kEye, kLight, kRadius) == 0);
    neck.toWorld[3].y = -0.05f;
    CHECK(seenPast(neck, kEye, kLight, kRadius) == 1);
}

TEST_CASE("the arc is hidden from the eye whose line of sight the arm crosses, while hands are tracked", "[render]") {
    SceneView scene;
    scene.modelToWorld = glm::scale(glm::mat4(1), glm::vec3(4));
    scene.arc = {{0, 0, 0.01f}, glm::vec3(1), 0.5e-3f};
    const std::array<Solid, 2> arms{armAcross(0.3f, 0.3f), armAcross(0, 0.3f)};
    scene.fittings = arms;
    CHECK(arcPastHands(scene, kEye) == 1); // a free camera
    scene.hands = arms;
    CHECK(arcPastHands(scene, kEye) == 0);
    CHECK(arcPastHands(scene, {0, 0.3f, 0.5f}) == 1); // between both arms
    scene.fittings = std::span(arms).first(1);
    CHECK(arcPastHands(scene, kEye) == 1);
    scene.fittings = arms;
    scene.arc.intensity = {};
    CHECK(arcPastHands(scene, kEye) == 1);
}
