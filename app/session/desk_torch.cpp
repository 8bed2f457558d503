#include "app/session/desk_torch.hpp"

#include "core/training/lesson/lesson.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <numeric>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRunUp = 5 * kMm;         // distance at which the torch begins before the judged range
constexpr double kFromEnd = 3 * kMm;       // least distance of that start from the seam's end
constexpr double kBeyond = 10 * kMm;       // way beyond the seam's ends that the torch can go
constexpr double kFarthest = 40 * kMm;     // greatest aim across the seam
constexpr double kNotch = 0.5 * kMm;       // distance per wheel notch or page key
constexpr double kKeyAngle = kDegree;      // angle per arrow key
constexpr double kLeanRate = 40 * kDegree; // rad/s, with a stick pushed all the way
constexpr double kDistanceRate = 8 * kMm;  // m/s, with a shoulder button held
constexpr double kSteepest = 60 * kDegree;
constexpr double kNearest = 0.5 * kMm; // least distance of a contact tip
constexpr double kInto = -0.5 * kMm;   // of an electrode or iron, which touches the metal
constexpr double kLongest = 60 * kMm;
constexpr double kRise = 4 * kMm;       // m/s at which a hand rises with the growing pool
constexpr double kKeyRamp = 0.12;       // s in which the keys' speed changes
constexpr double kUsualSpeed = 6 * kMm; // m/s of the keys in a lesson that asks for none
constexpr float kSteepSeam = 0.4F;      // of the seam's direction on the screen, to the side
constexpr double kStickAside = 0.5;     // share of a stick's push that counts as its error to the other side
constexpr double kPointsPerMove = 100;  // points of mouse travel per move of ControlParameters::torchMouse
constexpr double kRodFeed = 4 * kMm;    // m/s of the fingers while a rod is dipped, without a demonstration
constexpr double kRodShare = 0.5;       // of the time that it is dipped, to feed as much as the demonstration
constexpr double kRodTime = 0.15;       // s from rest into the pool

/// Ideal of a band in SI, or `otherwise`.
double idealOf(const Lesson& lesson, TechniqueQuantity quantity, double otherwise) {
    if (!lesson.technique) return otherwise;
    const TechniqueBand* band = lesson.technique->find(quantity);
    if (band == nullptr) return otherwise;
    return band->ideal / quantityInfo(quantity, lesson.technique->distance).perSi;
}

/// DeskPose::distance of the demonstration's torch halfway through its weld; nothing without a demonstration. It allows
/// for the pool, which in a corner rises some mm over the seam.
std::optional<double> expertDistance(const Lesson& lesson, const Seam& seam) {
    const std::optional<double> strikes = lesson.torch.firstPull();
    if (!strikes) return std::nullopt;
    const double halfway = std::midpoint(*strikes, lesson.torch.duration());
    const TorchSample torch = lesson.torch.sample(halfway);
    const SeamFrame frame = seam.at(seam.nearest(torch.tip).place);
    const double leaning = glm::dot(-glm::dvec3(torch.axis()), frame.up);
    if (leaning < std::cos(kSteepest)) return std::nullopt;
    return heldBehind(lesson.process) + glm::dot(glm::dvec3(torch.tip) - frame.point, frame.up) / leaning;
}

/// Unit vectors on the screen, x right and y up.
struct ScreenAxes {
    glm::vec2 along;
    glm::vec2 across; ///< to the seam's side
};

ScreenAxes axesOf(const SeamFrame& seam, const glm::mat3& toScreen) {
    glm::vec2 along(toScreen * glm::vec3(seam.tangent));
    // Seen from its end a seam has no direction on the screen: then up is along.
    along = glm::length(along) > 0.2F ? glm::normalize(along) : glm::vec2(0, 1);
    const glm::vec2 across(-along.y, along.x);
    const bool turned = glm::dot(across, glm::vec2(toScreen * glm::vec3(seam.across))) < 0;
    return {along, turned ? -across : across};
}

/// Leaves out the smaller part of a stick's push, as far as it is small beside the greater one: a thumb does not aim as
/// well as a torch has to go.
glm::dvec2 alongOrAcross(const glm::dvec2& push) {
    const auto kept = [](double part, double other) {
        const double size = std::abs(part), rest = size - kStickAside * std::abs(other);
        if (size >= std::abs(other)) return part;
        return std::copysign(std::max(rest, 0.0) / (1 - kStickAside), part);
    };
    return {kept(push.x, push.y), kept(push.y, push.x)};
}

/// True if a hand leads the torch from one pose to the other; keys that were let go still move it a little.
bool hasMoved(const DeskPose& from, const DeskPose& to) {
    constexpr double kLeast = 1e-6; // m, or rad
    const auto differ = [](double a, double b) { return std::abs(a - b) > kLeast; };
    return differ(from.place, to.place) || differ(from.aim, to.aim) || differ(from.distance, to.distance) ||
           differ(from.work, to.work) || differ(from.travel, to.travel) || differ(from.dip, to.dip);
}

double between(double from, double to, double share) {
    return from + (to - from) * share;
}

} // namespace

void DeskTorch::begin(const Lesson& lesson) {
    seam_.reset();
    if (lesson.model != LessonModel::Weld) return;
    seam_ = seamOf(lesson.workpiece);
    kind_ = traitsOf(lesson.process).distance;
    take(lesson.process);
    const double usual = kind_ == DistanceKind::arcLength ? 3 * kMm : stickOut_ + 3 * kMm;
    wanted_ = {};
    wanted_.aim = idealOf(lesson, TechniqueQuantity::aim, 0);
    wanted_.distance = idealOf(lesson, TechniqueQuantity::distance, usual);
    pool_ = rise_ = 0;
    // A touch-struck arc's distance at the start says nothing of how it is held.
    if (kind_ == DistanceKind::ctwd)
        pool_ = std::max(expertDistance(lesson, *seam_).value_or(wanted_.distance) - wanted_.distance, 0.0);
    wanted_.work = idealOf(lesson, TechniqueQuantity::workAngle, 0);
    wanted_.travel = idealOf(lesson, TechniqueQuantity::travelAngle, 0);
    askedSpeed_ = std::abs(idealOf(lesson, TechniqueQuantity::travelSpeed, kUsualSpeed));
    const double first = lesson.technique ? lesson.technique->lengthFromMm * kMm : seam_->begin() + kRunUp;
    // The end of the plate is no metal to strike on.
    wanted_.place = std::max(first - kRunUp, seam_->begin() + kFromEnd);
    held_ = wanted_;
    left_ = time_ = 0;
    keyPace_ = {};
    keyWays_ = glm::dmat2(0);
    guided_ = paced_ = asideAsked_ = aside_ = false;
    weave_.begin(lesson.torch);
    hold_ = lesson.torch.rod().value_or(RodHold{});
    hold_.feed = hold_.feed > 0 ? hold_.feed / kRodShare : kRodFeed;
    led_.reset();
}

void DeskTorch::take(const ProcessSettings& process) {
    stickOut_ = heldBehind(process);
    rod_ = holdsRod(process);
}

void DeskTorch::standAt(double place) {
    wanted_.place = held_.place = place;
    left_ = 0;
}

void DeskTorch::update(const InputFrame& input, const DeskFrame& frame, const ControlParameters& parameters,
                       const ProcessSettings& process) {
    if (!seam_) return;
    take(process);
    // The way that the guide went since the last frame counts as the hand's, too.
    wanted_.place += left_;
    left_ = 0;
    const DeskPose before = wanted_;
    guide_ = static_cast<double>(parameters.guideSpeed) * kMm;
    tremor_ = static_cast<double>(parameters.tremor);
    const auto pointWay = parameters.torchMouse * static_cast<float>(kMm / kPointsPerMove);
    lead(glm::vec2(input.mouseMove.x, -input.mouseMove.y) * pointWay, frame.toScreen);
    takeKeys(input);
    const double keySpeed = static_cast<double>(parameters.keySpeed) * kMm;
    leadByKeys(input, frame, keySpeed > 0 ? keySpeed : askedSpeed_);
    keysKeepPace_ = keySpeed <= 0 && std::abs(keyPace_.x) > 0.5;
    takeGamepad(input.gamepad, frame, static_cast<double>(parameters.gamepadSpeed) * kMm);
    if (!seam_->closed()) wanted_.place = std::clamp(wanted_.place, seam_->begin() - kBeyond, seam_->end() + kBeyond);
    wanted_.aim = std::clamp(wanted_.aim, -kFarthest, kFarthest);
    wanted_.distance = std::clamp(wanted_.distance, kind_ == DistanceKind::ctwd ? kNearest : kInto, kLongest);
    wanted_.work = std::clamp(wanted_.work, -kSteepest, kSteepest);
    wanted_.travel = std::clamp(wanted_.travel, -kSteepest, kSteepest);
    stirs_ = hasMoved(before, wanted_);
    if (aside_ && stirs_) aside_ = asideAsked_ = false;
}

/// `way`: m on the screen, x right and y up.
void DeskTorch::lead(const glm::vec2& way, const glm::mat3& toScreen) {
    const SeamFrame frame = seam_->at(wanted_.place);
    const ScreenAxes axes = axesOf(frame, toScreen);
    wanted_.place += static_cast<double>(glm::dot(way, axes.along));
    wanted_.aim += static_cast<double>(glm::dot(way, axes.across));
}

void DeskTorch::takeKeys(const InputFrame& input) {
    wanted_.distance += static_cast<double>(input.scroll) * kNotch;
    const bool leads = input.isHeld(Key::shift); // then the arrow keys lead the torch, see leadByKeys()
    for (const Key key : input.pressed) {
        if (leads && key >= Key::left && key <= Key::down) continue;
        if (key == Key::right) wanted_.travel += kKeyAngle;
        if (key == Key::left) wanted_.travel -= kKeyAngle;
        if (key == Key::up) wanted_.work -= kKeyAngle;
        if (key == Key::down) wanted_.work += kKeyAngle;
        if (key == Key::pageUp) wanted_.distance += kNotch;
        if (key == Key::pageDown) wanted_.distance -= kNotch;
    }
    for (const Key key : input.struck)
        if (key == Key::g) weave_.toggle();
    const bool dips = input.isHeld(Key::r) || input.gamepad.leftTrigger > 0.5F;
    wanted_.dip = rod_ && dips ? 1 : 0;
}

/// Leads the torch along and across the seam while Shift and arrow keys are held, with soft starts and ends.
void DeskTorch::leadByKeys(const InputFrame& input, const DeskFrame& frame, double speed) {
    glm::dvec2 held{0};
    if (input.isHeld(Key::shift)) {
        held.x = static_cast<double>(input.isHeld(Key::right)) - static_cast<double>(input.isHeld(Key::left));
        held.y = static_cast<double>(input.isHeld(Key::up)) - static_cast<double>(input.isHeld(Key::down));
    }
    if (held == glm::dvec2(0) || keyWays_ == glm::dmat2(0)) { // a held key keeps its way round a pipe
        const ScreenAxes axes = axesOf(seam_->at(wanted_.place), frame.toScreen);
        const bool steep = std::abs(axes.along.x) < kSteepSeam;
        const auto sign = [](float way) { return std::copysign(1.0, static_cast<double>(way)); };
        keyWays_ = steep ? glm::dmat2(0, sign(axes.across.x), sign(axes.along.y), 0)
                         : glm::dmat2(sign(axes.along.x), 0, 0, sign(axes.across.y));
    }
    if (asideAsked_ && held == glm::dvec2(0)) keyPace_ = {}; // keys that were let go do not lead a torch put aside
    keyPace_ += (keyWays_ * held - keyPace_) * (1 - std::exp(-frame.seconds / kKeyRamp));
    wanted_.place += keyPace_.x * speed * frame.seconds;
    wanted_.aim += keyPace_.y * speed * frame.seconds;
}

void DeskTorch::takeGamepad(const GamepadFrame& gamepad, const DeskFrame& frame, double speed) {
    const ScreenAxes axes = axesOf(seam_->at(wanted_.place), frame.toScreen);
    const glm::dvec2 push = alongOrAcross({glm::dot(gamepad.left, axes.along), glm::dot(gamepad.left, axes.across)});
    wanted_.place += push.x * speed * frame.seconds;
    wanted_.aim += push.y * speed * frame.seconds;
    const double lean = kLeanRate * frame.seconds;
    // A pushing torch leans its handle back against its direction.
    wanted_.travel -= static_cast<double>(glm::dot(gamepad.right, axes.along)) * lean;
    wanted_.work += static_cast<double>(glm::dot(gamepad.right, axes.across)) * lean;
    const double farther = static_cast<double>(gamepad.rightShoulder) - static_cast<double>(gamepad.leftShoulder);
    wanted_.distance += farther * kDistanceRate * frame.seconds;
}

/// Way that the guide can still go, m.
double DeskTorch::wayLeft() const {
    if (seam_->closed()) return std::numeric_limits<double>::infinity();
    return std::max(seam_->end() + kBeyond - wanted_.place - left_, 0.0);
}

/// Notes which quantities the hand leads on the way to `target`.
void DeskTorch::noteLed(const DeskPose& target) {
    using enum TechniqueQuantity;
    const auto note = [this](double from, double to, std::initializer_list<TechniqueQuantity> quantities) {
        constexpr double kLeast = 1e-7; // m, or rad
        if (std::abs(to - from) <= kLeast) return;
        for (const TechniqueQuantity each : quantities)
            led_.set(static_cast<size_t>(each));
    };
    note(held_.place, target.place, {travelSpeed, whipLength, whipPeriod, whipDwell});
    note(held_.aim, target.aim, {aim, weaveWidth, weaveFrequency, weaveDwell});
    note(held_.distance, target.distance, {distance});
    note(held_.work, target.work, {workAngle});
    note(held_.travel, target.travel, {travelAngle});
    note(held_.dip, target.dip, {rodFrequency});
}

QuantitySet DeskTorch::held() const {
    QuantitySet held = ~led_;
    using enum TechniqueQuantity;
    if (guided_ || paced_) held.set(static_cast<size_t>(travelSpeed));
    if (weave_.swung())
        for (const TechniqueQuantity each : {weaveWidth, weaveFrequency, weaveDwell})
            held.set(static_cast<size_t>(each));
    return held;
}

TorchSample DeskTorch::next(int step, int due, double seconds, float burntOff, float trigger) {
    if (aside_ && trigger > 0) aside_ = asideAsked_ = false;
    aside_ = aside_ || (asideAsked_ && !stirs_ && trigger <= 0);
    if (trigger > 0) { // guide and tremor go on by themselves; only the hand's own way is divided among the steps
        guided_ = guided_ || guide_ > 0;
        paced_ = paced_ || keysKeepPace_;
        const double way = std::min(guide_ * seconds, wayLeft());
        left_ += way;
        held_.place += way;
        rise_ = std::min(rise_ + kRise * seconds, pool_);
    }
    const double share = 1.0 / (due - step);
    DeskPose target = wanted_;
    target.place += left_;
    if (trigger > 0) noteLed(target);
    held_.place = between(held_.place, target.place, share);
    held_.aim = between(held_.aim, target.aim, share);
    held_.distance = between(held_.distance, target.distance, share);
    held_.work = between(held_.work, target.work, share);
    held_.travel = between(held_.travel, target.travel, share);
    // A rod takes its time, however short the frame is.
    held_.dip += std::clamp(target.dip - held_.dip, -seconds / kRodTime, seconds / kRodTime);
    TorchSample torch = sampleOf(held_, burntOff, weave_.next(seconds, trigger > 0));
    torch.trigger = trigger;
    time_ += seconds;
    if (tremor_ > 0) hand_.shake(torch, time_, tremor_ * HandTremor::kPlace, tremor_ * HandTremor::kAngle);
    return torch;
}

/// `swing`: m at right angles to torch and seam, to the seam's side.
TorchSample DeskTorch::sampleOf(const DeskPose& pose, float burntOff, double swing) const {
    const SeamFrame frame = seam_->at(pose.place);
    const glm::dvec3 lean = std::cos(pose.work) * frame.up + std::sin(pose.work) * frame.across;
    const glm::dvec3 back = std::cos(pose.travel) * lean - std::sin(pose.travel) * frame.tangent;
    const glm::dvec3 right = glm::normalize(frame.tangent - glm::dot(frame.tangent, back) * back);
    const glm::dvec3 foot = frame.point + pose.aim * frame.across;
    TorchSample torch;
    const glm::dvec3 side = glm::normalize(glm::cross(frame.tangent, back));
    const double aside = glm::dot(side, frame.across) < 0 ? -swing : swing;
    torch.tip =
        glm::vec3(foot + (pose.distance + rise_ - stickOut_ - static_cast<double>(burntOff)) * back + aside * side);
    torch.orientation = glm::normalize(
        glm::quat_cast(glm::mat3(glm::vec3(right), glm::vec3(glm::cross(back, right)), glm::vec3(back))));
    if (rod_) torch.rod = rodOf(torch, pose, frame);
    return torch;
}

RodSample DeskTorch::rodOf(const TorchSample& torch, const DeskPose& pose, const SeamFrame& frame) const {
    RodHold hold = hold_;
    hold.travel = glm::vec3(frame.tangent);
    hold.up = glm::vec3(frame.up);
    hold.below = pose.distance + rise_;
    if (pose.dip <= 0.5) hold.feed = 0;
    return hold.at(torch.tip, between(hold.rest, -hold.depth, pose.dip));
}

} // namespace meltpool
