#include "app/session/desk_torch.hpp"

#include "core/training/lesson.hpp"
#include "core/weld/torch/torch_moves.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRunUp = 5 * kMm;     // the torch begins so far before what counts
constexpr double kFromEnd = 3 * kMm;   // but at least so far from the seam's end
constexpr double kBeyond = 10 * kMm;   // of the seam's ends that it can be led to
constexpr double kFarthest = 40 * kMm; // across
constexpr double kNotch = 0.5 * kMm;   // of distance, a wheel notch or page key
constexpr double kKeyAngle = kDegree;  // an arrow key
constexpr double kSteepest = 60 * kDegree;
constexpr double kNearest = 0.5 * kMm, kLongest = 60 * kMm; // of the distance
constexpr double kPointsPerMove = 100;                      // of mouse travel, see ControlParameters::torchMouse
/// A filler rod: angle over the plate, place before the electrode, way back at rest, way beyond in the pool, and feed
/// of the fingers while it is dipped.
constexpr double kRodAngle = 20 * kDegree, kRodAhead = 1.5 * kMm, kRodRest = 12 * kMm, kRodDepth = 3.5 * kMm;
constexpr double kRodFeed = 4 * kMm; // m/s
constexpr double kRodTime = 0.15;    // s from rest into the pool

/// The ideal of a band in SI, or `otherwise`.
double idealOf(const Lesson& lesson, TechniqueQuantity quantity, double otherwise) {
    if (!lesson.technique) return otherwise;
    const TechniqueBand* band = lesson.technique->find(quantity);
    if (band == nullptr) return otherwise;
    return band->ideal / quantityInfo(quantity, lesson.technique->distance).perSi;
}

double between(double from, double to, double share) {
    return from + (to - from) * share;
}

} // namespace

void DeskTorch::begin(const Lesson& lesson) {
    seam_.reset();
    if (lesson.model != LessonModel::Weld) return;
    seam_ = seamOf(lesson.workpiece);
    kind_ = distanceKindOf(lesson.process);
    rod_ = lesson.process.is<Gtaw>();
    stickOut_ = lesson.process.is<Gmaw>() ? static_cast<double>(lesson.process.of<Gmaw>().stickOutMm) * kMm : 0.0;
    const double usual = kind_ == DistanceKind::arcLength ? 3 * kMm : stickOut_ + 3 * kMm;
    wanted_ = {};
    wanted_.distance = idealOf(lesson, TechniqueQuantity::distance, usual);
    wanted_.work = idealOf(lesson, TechniqueQuantity::workAngle, 0);
    wanted_.travel = idealOf(lesson, TechniqueQuantity::travelAngle, 0);
    const double first = lesson.technique ? lesson.technique->lengthFromMm * kMm : seam_->begin() + kRunUp;
    // An end of the plate is no metal to strike on.
    wanted_.place = std::max(first - kRunUp, seam_->begin() + kFromEnd);
    held_ = wanted_;
    left_ = 0;
    guided_ = false;
}

void DeskTorch::update(const InputFrame& input, const glm::mat3& toScreen, const ControlParameters& parameters) {
    if (!seam_) return;
    // The way that the guide has gone since the last frame is the hand's way, too.
    wanted_.place += left_;
    left_ = 0;
    guide_ = static_cast<double>(parameters.guideSpeed) * kMm;
    const SeamFrame frame = seam_->at(wanted_.place);
    glm::vec2 along(toScreen * glm::vec3(frame.tangent));
    // Seen from its end a seam has no way on the screen: then up is along.
    along = glm::length(along) > 0.2F ? glm::normalize(along) : glm::vec2(0, 1);
    glm::vec2 across(-along.y, along.x);
    if (glm::dot(across, glm::vec2(toScreen * glm::vec3(frame.across))) < 0) across = -across;
    const glm::vec2 hand = glm::vec2(input.mouseMove.x, -input.mouseMove.y) *
                           (parameters.torchMouse * static_cast<float>(kMm / kPointsPerMove));
    wanted_.place += static_cast<double>(glm::dot(hand, along));
    wanted_.aim += static_cast<double>(glm::dot(hand, across));
    wanted_.distance += static_cast<double>(input.scroll) * kNotch;
    for (const Key key : input.pressed) {
        if (key == Key::right) wanted_.travel += kKeyAngle;
        if (key == Key::left) wanted_.travel -= kKeyAngle;
        if (key == Key::up) wanted_.work -= kKeyAngle;
        if (key == Key::down) wanted_.work += kKeyAngle;
        if (key == Key::pageUp) wanted_.distance += kNotch;
        if (key == Key::pageDown) wanted_.distance -= kNotch;
    }
    if (!seam_->closed()) wanted_.place = std::clamp(wanted_.place, seam_->begin() - kBeyond, seam_->end() + kBeyond);
    wanted_.aim = std::clamp(wanted_.aim, -kFarthest, kFarthest);
    wanted_.distance = std::clamp(wanted_.distance, kNearest, kLongest);
    wanted_.work = std::clamp(wanted_.work, -kSteepest, kSteepest);
    wanted_.travel = std::clamp(wanted_.travel, -kSteepest, kSteepest);
    wanted_.dip = rod_ && input.isHeld(Key::r) ? 1 : 0;
}

TorchSample DeskTorch::next(int step, int due, double seconds, float burntOff, float trigger) {
    if (trigger > 0) { // both go on by themselves, and only the hand's own way is shared out among the steps
        guided_ = guided_ || guide_ > 0;
        left_ += guide_ * seconds;
        held_.place += guide_ * seconds;
    }
    const double share = 1.0 / (due - step);
    DeskPose target = wanted_;
    target.place += left_;
    held_.place = between(held_.place, target.place, share);
    held_.aim = between(held_.aim, target.aim, share);
    held_.distance = between(held_.distance, target.distance, share);
    held_.work = between(held_.work, target.work, share);
    held_.travel = between(held_.travel, target.travel, share);
    // A rod takes its time, however short the frame is.
    held_.dip += std::clamp(target.dip - held_.dip, -seconds / kRodTime, seconds / kRodTime);
    TorchSample torch = sampleOf(held_, burntOff);
    torch.trigger = trigger;
    return torch;
}

TorchSample DeskTorch::sampleOf(const DeskPose& pose, float burntOff) const {
    const SeamFrame frame = seam_->at(pose.place);
    const glm::dvec3 lean = std::cos(pose.work) * frame.up + std::sin(pose.work) * frame.across;
    const glm::dvec3 back = std::cos(pose.travel) * lean - std::sin(pose.travel) * frame.tangent;
    const glm::dvec3 right = glm::normalize(frame.tangent - glm::dot(frame.tangent, back) * back);
    const glm::dvec3 foot = frame.point + pose.aim * frame.across;
    TorchSample torch;
    torch.tip = glm::vec3(foot + (pose.distance - stickOut_ - static_cast<double>(burntOff)) * back);
    torch.orientation = glm::normalize(
        glm::quat_cast(glm::mat3(glm::vec3(right), glm::vec3(glm::cross(back, right)), glm::vec3(back))));
    if (rod_) torch.rod = rodOf(torch, pose, frame);
    return torch;
}

RodSample DeskTorch::rodOf(const TorchSample& torch, const DeskPose& pose, const SeamFrame& frame) const {
    RodHold hold;
    hold.travel = glm::vec3(frame.tangent);
    hold.up = glm::vec3(frame.up);
    hold.angle = kRodAngle;
    hold.ahead = kRodAhead;
    hold.below = pose.distance;
    hold.feed = pose.dip > 0.5 ? kRodFeed : 0;
    return hold.at(torch.tip, between(kRodRest, -kRodDepth, pose.dip));
}

} // namespace meltpool
