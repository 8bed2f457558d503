// A person at the joint with the torch in the hand: hand, arm and torch leave the pool in both eyes' sight.
#include "app/headset/workshop_scene.hpp"
#include "core/render/solid_meshes.hpp"
#include "core/scene/torch_geometry.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <span>
#include <string>

using namespace meltpool;

namespace {

constexpr float kTable = 0.9f;

/// Returns true if a triangle of the solid is on the way from `from` to `to`.
bool blocks(const Solid& solid, const glm::vec3& from, const glm::vec3& to) {
    static const SolidMeshes meshes = makeSolidMeshes();
    const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(solid.shape)];
    const glm::vec3 ray = to - from;
    const auto corner = [&](int i) {
        return glm::vec3(solid.toWorld *
                         glm::vec4(meshes.vertices[meshes.indices[static_cast<size_t>(i)]].position, 1));
    };
    for (int i = range.first; i < range.first + range.count; i += 3) {
        const glm::vec3 a = corner(i), ab = corner(i + 1) - a, ac = corner(i + 2) - a;
        const glm::vec3 normal = glm::cross(ab, ac);
        const float towards = glm::dot(ray, normal);
        if (std::abs(towards) < 1e-12f) continue;
        const float t = glm::dot(a - from, normal) / towards;
        if (t <= 0 || t >= 1) continue;
        const glm::vec3 p = from + ray * t - a;
        const float u = glm::dot(glm::cross(p, ac), normal), v = glm::dot(glm::cross(ab, p), normal);
        const float area = glm::dot(normal, normal);
        if (u >= 0 && v >= 0 && u + v <= area) return true;
    }
    return false;
}

/// One person with the torch at the joint. The torch leans by `lean` (rad) towards the welder and `aside` to the hand's
/// own side, to which its handle leads, too. The head is `beside` (m) the joint, on the other side.
struct Person {
    float eyes = kTable + Workshop::kDrop; ///< m over the floor
    bool right = true;
    float beside = 0;
    glm::vec3 joint{0, kTable + 0.012f, 0};
    xr::Pose head() const {
        return {glm::angleAxis(-0.8f, glm::vec3(1, 0, 0)), {right ? -beside : beside, eyes, Workshop::kReach}};
    }

    /// Returns the torch's pose with its handle turned by `turn` (rad) from the hand's side to the welder.
    xr::Pose torch(float lean, float aside, float turn) const {
        const float side = right ? 1.0f : -1.0f;
        const glm::vec3 back = glm::normalize(glm::vec3(side * std::tan(aside), std::cos(lean), std::sin(lean)));
        glm::vec3 down = -glm::vec3(side * std::cos(turn), 0, std::sin(turn)); // away from the handle
        down = glm::normalize(down - back * glm::dot(down, back));
        return {glm::quat_cast(glm::mat3(glm::cross(down, back), down, back)), joint};
    }
    HandPose hand(const xr::Pose& hold) const {
        HandPose hand{hold, glm::normalize(hold.orientation * glm::vec3(0, 0.6f, 1)), right};
        hand.forearm = forearmFrom(head(), hand);
        return hand;
    }
    /// Returns the numbers of the solids that are before the pool's edge in an eye's sight.
    std::string covered(std::span<const Solid> solids) const {
        std::string covering;
        // Ahead of the torch, which leans to the hand.
        const glm::vec3 pool = joint + glm::vec3(right ? -0.005f : 0.005f, 0, 0.004f);
        for (const float eye : {-0.0315f, 0.0315f})
            for (size_t i = 0; i < solids.size(); ++i)
                if (blocks(solids[i], head() * glm::vec3(eye, 0, 0), pool))
                    covering += std::to_string(i) + " of " + std::to_string(solids.size()) + ", ";
        return covering;
    }
};

} // namespace

TEST_CASE("torch, hand and arm leave the pool in sight, for three heads and both hands") {
    const float eyes = kTable + Workshop::kDrop + GENERATE(-0.05f, 0.0f, 0.1f); // persons bow and stretch
    const bool right = GENERATE(true, false);
    struct Work {
        float lean, aside, turn; ///< rad
        float beside;            ///< m: over a tee's lean the person looks past the torch
    };
    HeadsetParameters parameters;
    parameters.tableHeight = kTable;
    WorkshopScene scene;
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind)
        for (const Work work : {Work{0, 0.17f, 0.2f, 0}, Work{0.1f, 0.17f, 0.5f, 0}, Work{0.7f, 0.26f, 0.5f, 0.12f}}) {
            const Person person{eyes, right, work.beside};
            ProcessSettings process;
            process.kind = kind;
            INFO(AllProcesses::kNames[static_cast<size_t>(kind)]
                 << ", eyes at " << eyes << " m, " << (right ? "right" : "left") << ", lean " << work.lean << ", turn "
                 << work.turn);
            const TorchGeometry geometry = torchGeometry(process);
            const xr::Pose tip = person.torch(work.lean, work.aside, work.turn);
            const xr::Pose hold = tip * xr::Pose{geometry.tipOrientation(), geometry.tip()}.inverse();
            HandsView hands;
            hands.torch = true;
            hands.tip = tip;
            hands.holder = person.hand(hold);
            hands.process = &process;
            scene.build(parameters, hands);
            REQUIRE(scene.fittings().size() > 30);
            const std::string by = person.covered(scene.fittings());
            CHECK(by == "");
        }
}

TEST_CASE("a hand with the rod leaves the pool in sight") {
    const float eyes = kTable + Workshop::kDrop + GENERATE(-0.05f, 0.0f, 0.1f);
    const bool right = GENERATE(true, false); // the torch's hand: the rod is in the other
    const Person person{eyes, !right};
    const float side = right ? -1.0f : 1.0f;
    const glm::vec3 back = glm::normalize(glm::vec3(side, 0.35f, 0.2f)); // 20 degrees over the plate
    const glm::vec3 up = glm::normalize(glm::cross(glm::cross(back, glm::vec3(0, 1, 0)), back));
    const glm::vec3 end = person.joint + glm::vec3(side * 0.003f, 0, 0);
    // The palm is down: the back of a left hand is at -x of its hold, that of a right one at +x.
    const glm::vec3 x = person.right ? up : -up;
    const xr::Pose hold{glm::quat_cast(glm::mat3(x, glm::cross(back, x), back)), end + back * 0.30f};
    const TrackedHand hand = person.hand(hold).tracked();
    CHECK(hand.back.y > 0.8f);
    std::vector<Solid> solids;
    addGlovedHand(solids, rodGripOf(hand, back, end), glm::mat4(1));
    CHECK(person.covered(solids) == "");
    // The rod is between thumb and fingers: near the glove, and not in the palm.
    CHECK(glm::dot(solids.front().toWorld[3], glm::vec4(up, 0)) > glm::dot(hold.position, up) + 0.02f);
}

TEST_CASE("the elbow is to the side of the person, below the shoulder, and the forearm leads to it") {
    for (const bool right : {true, false}) {
        const Person person{.right = right};
        const float side = right ? 1.0f : -1.0f;
        HandPose hand{
            {{1, 0, 0, 0}, {side * 0.1f, 1.1f, 0.1f}}, glm::normalize(glm::vec3(side * 0.4f, -0.5f, 1)), right};
        const glm::vec3 forearm = forearmFrom(person.head(), hand);
        CHECK(glm::length(forearm) == Approx(1).margin(1e-4));
        CHECK(forearm.z > 0.3f); // back to the person
        CHECK(side * (hand.hold.position.x + 0.29f * forearm.x) > 0.1f);
        CHECK(hand.hold.position.y + 0.29f * forearm.y < 1.40f); // the shoulder's height
        hand.hold.position = {side * 0.1f, 1.1f, -2.0f};         // beyond any arm's reach
        CHECK(forearmFrom(person.head(), hand).z > 0.9f);
    }
}
