#include "app/headset/tracked_torch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Shortest frame, s: frames in bursts are no faster than a display shows them.
constexpr double kShortestFrame = 1.0 / 90;
/// Longest frame whose whole way counts, s: a longer way in one slow frame was not steered.
constexpr double kLongestFrame = 1.0 / 30;

} // namespace

TrackedHand HandPose::tracked() const {
    return {hold.position, hold.orientation * glm::vec3(right ? 1 : -1, 0, 0), forearm, right};
}

HandPose handPose(const xr::HandInput& hand, const Workshop& workshop, bool right) {
    constexpr float kDown = 0.25f; // share of the forearm's way that leads down
    const glm::vec3 back = workshop.toWorkshop(hand.aim).orientation * glm::vec3(0, 0, 1);
    return {workshop.toWorkshop(hand.hold), glm::normalize(back - glm::vec3(0, kDown, 0)), right};
}

glm::vec3 forearmFrom(const xr::Pose& head, const HandPose& hand) {
    constexpr glm::vec3 kShoulder(0.19f, -0.24f, 0.04f); // m from the eyes, of a right arm
    constexpr float kUpperArm = 0.30f, kForearm = 0.29f;
    const glm::vec3 side = head.orientation * glm::vec3(1, 0, 0), level(side.x, 0, side.z);
    if (glm::length(level) < 0.1f) return hand.forearm; // the head lies on its side
    const glm::vec3 right = glm::normalize(level), back = glm::cross(right, glm::vec3(0, 1, 0));
    const glm::vec3 shoulder = head.position + right * (hand.right ? kShoulder.x : -kShoulder.x) +
                               glm::vec3(0, kShoulder.y, 0) + back * kShoulder.z;
    const glm::vec3 way = shoulder - hand.hold.position;
    const float far = glm::length(way);
    if (far < 0.05f) return hand.forearm;
    const glm::vec3 line = way / far;
    const glm::vec3 bends = hand.forearm - line * glm::dot(line, hand.forearm);
    const float reach =
        std::clamp((far * far + kForearm * kForearm - kUpperArm * kUpperArm) / (2 * far), 0.0f, kForearm);
    const float out = std::sqrt(kForearm * kForearm - reach * reach), length = glm::length(bends);
    return glm::normalize(line * reach + (length > 0.1f ? bends * (out / length) : glm::vec3(0)) + line * 1e-3f);
}

void TrackedTorch::update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                          double elapsed) {
    if (!hand.tracked) lose(ArcOut::torchLost);
    const bool continues = tracked_;
    const bool pulled = trigger() > 0;
    tracked_ = hand.tracked;
    before_ = now_;
    velocity_ = glm::vec3(0.0f);
    trigger_ = lock_.pass(hand.trigger, hand.tracked);
    if (!hand.tracked) return;
    now_ = calibration.tip(workshop.toWorkshop(hand.grip));
    known_ = true;
    const float way = glm::distance(now_.position, before_.position);
    const bool jumps = way > kFastestHand * static_cast<float>(std::clamp(elapsed, kShortestFrame, kLongestFrame));
    if (continues && jumps && pulled) putOut(ArcOut::tipJumped);
    // A torch that is tracked again starts at its new place; it does not travel there from the place of its loss.
    if (!continues || jumps || jumped_) before_ = now_;
    if (elapsed > 0) velocity_ = (now_.position - before_.position) / static_cast<float>(elapsed);
}

void TrackedTorch::lose(ArcOut reason) {
    if (tracked_) putOut(reason);
    tracked_ = false;
}

void TrackedTorch::putOut(ArcOut reason) {
    lock_.lock(reason);
    jumped_ = true;
    before_ = now_;
}

TorchSample TrackedTorch::sampleAt(const xr::Pose& tip, const WorkpiecePlace& place) const {
    TorchSample sample;
    sample.tip = place.toWorkpiece(tip.position);
    sample.orientation = place.toWorkpiece(glm::normalize(tip.orientation));
    sample.trigger = trigger();
    return sample;
}

TorchSample TrackedTorch::sample(const WorkpiecePlace& place) const {
    return sampleAt(now_, place);
}

TorchSample TrackedTorch::next(const WorkpiecePlace& place, int step, int steps) {
    const float t = static_cast<float>(step + 1) / static_cast<float>(steps > 0 ? steps : 1);
    const bool outFirst = jumped_ && last_ && last_->trigger > 0;
    jumped_ = false;
    if (outFirst)
        last_->trigger = 0;
    else
        last_ = sampleAt(xr::interpolate(before_, now_, t), place);
    return *last_;
}

} // namespace meltpool
