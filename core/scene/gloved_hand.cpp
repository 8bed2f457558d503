#include "core/scene/gloved_hand.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr glm::vec3 kLeather(0.34f, 0.22f, 0.11f);
constexpr glm::vec3 kCuff(0.20f, 0.17f, 0.14f);
constexpr glm::vec3 kSleeve(0.035f, 0.05f, 0.085f);
constexpr float kLeatherGloss = 0.06f;

/// Sizes of a large glove, m.
constexpr float kFinger = 0.023f, kFingersApart = 0.021f;
constexpr int kFingers = 4;

/// Returns the transform of a box or the like with axes x, y and z and these edges.
glm::mat4 framed(const glm::vec3& x, const glm::vec3& y, const glm::vec3& z, const glm::vec3& middle,
                 const glm::vec3& size) {
    return {glm::vec4(x * size.x, 0), glm::vec4(y * size.y, 0), glm::vec4(z * size.z, 0), glm::vec4(middle, 1)};
}

} // namespace

HandGrip gripOf(const TrackedHand& hand, const glm::vec3& way, const glm::vec3& tip, float radius) {
    glm::vec3 palm = hand.back - way * glm::dot(way, hand.back);
    if (glm::length(palm) < 0.1f) palm = glm::cross(way, hand.forearm);
    const glm::vec3 away = hand.place - tip;
    glm::vec3 arm = hand.forearm;
    if (const float length = glm::length(away); length > 1e-3f) {
        const glm::vec3 back = away / length;
        arm -= back * std::min(glm::dot(arm, back), 0.0f);
    }
    // An arm straight towards the tip leaves along the handle.
    arm = glm::length(arm) > 0.1f ? glm::normalize(arm) : way;
    return {hand.place, way, glm::normalize(palm), arm, radius, hand.right};
}

HandGrip rodGripOf(const TrackedHand& hand, const glm::vec3& way, const glm::vec3& rodTip) {
    constexpr float kCurled = 0.013f,
                    kPinch = -1.9f; // m; rad from the back of the hand to where thumb and fingers meet
    HandGrip grip = gripOf(hand, way, rodTip, kCurled);
    const glm::vec3 across = glm::cross(way, grip.palm) * (hand.right ? -1.0f : 1.0f);
    grip.middle -= (grip.palm * std::cos(kPinch) + across * std::sin(kPinch)) * (kCurled + 0.004f);
    return grip;
}

void addGlovedHand(std::vector<Solid>& solids, const HandGrip& grip, const glm::mat4& toWorld) {
    const glm::vec3 across = glm::cross(grip.along, grip.palm) * (grip.mirrored ? -1.0f : 1.0f);
    const auto add = [&](SolidShape shape, const glm::mat4& place, const glm::vec3& colour) {
        solids.push_back({shape, toWorld * place, colour, kLeatherGloss});
    };
    // Returns a place round the axis: `turned` from the palm's side, `out` from the surface of the handle.
    const auto round = [&](float along, float turned, float out) {
        return grip.middle + grip.along * along +
               (grip.radius + out) * (grip.palm * std::cos(turned) + across * std::sin(turned));
    };
    const glm::vec3 palm = grip.middle + grip.palm * (grip.radius + 0.016f) - across * 0.004f;
    add(SolidShape::pill,
        framed(grip.palm, glm::cross(grip.along, grip.palm), grip.along, palm, {0.042f, 0.080f, 0.112f}), kLeather);
    for (int finger = 0; finger < kFingers; ++finger) {
        const float along = kFingersApart * (static_cast<float>(finger) - 0.5f * (kFingers - 1));
        const float thick = finger == kFingers - 1 ? 0.85f * kFinger : kFinger; // the little finger
        // Each segment from one joint round the handle to the next.
        constexpr float kJoints[] = {0.75f, 1.75f, 2.65f, 3.45f};
        for (int segment = 0; segment < 3; ++segment) {
            const glm::vec3 from = round(along, kJoints[segment], 0.5f * thick + (segment == 0 ? 0.008f : 0.002f));
            const glm::vec3 to = round(along, kJoints[segment + 1], 0.5f * thick);
            const glm::vec3 way = glm::normalize(to - from) * (0.35f * thick);
            add(SolidShape::pill, alongLine(from - way, to + way, thick), kLeather);
        }
    }
    // The thumb is on the other side and points to the work.
    const glm::vec3 root = round(0.012f, -0.85f, 0.016f), joint = round(-0.030f, -1.25f, 0.013f);
    const glm::vec3 tip = round(-0.062f, -1.45f, 0.010f);
    add(SolidShape::pill, alongLine(root, joint, 0.031f), kLeather);
    add(SolidShape::pill, alongLine(joint + 0.25f * (root - joint), tip, 0.025f), kLeather);
    const glm::vec3 wrist = palm + grip.along * 0.030f + grip.arm * 0.012f;
    add(SolidShape::pill, alongLine(wrist + grip.arm * 0.085f, wrist - grip.arm * 0.012f, 0.072f), kLeather);
    add(SolidShape::taper, alongLine(wrist + grip.arm * 0.20f, wrist + grip.arm * 0.045f, 0.118f), kCuff);
    add(SolidShape::pill, alongLine(wrist + grip.arm * 0.52f, wrist + grip.arm * 0.12f, 0.104f), kSleeve);
}

} // namespace meltpool
