#include "core/training/judging/technique.hpp"

#include "core/base/text.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using enum TechniqueQuantity;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kStepsAtFirst = size_t(1) << 15;

double finite(float value) {
    return std::isfinite(value) ? static_cast<double>(value) : kUnknown;
}

/// True if no samples are missing between two steps that weld, and the torch did not jump.
bool follows(const TechniqueStep& step, const TechniqueStep& before) {
    const double elapsed = step.time - before.time, way = std::abs(step.place - before.place);
    return before.welds && elapsed > 0 && elapsed <= kLongestTechniqueStep &&
           way <= std::max(kJump, kJumpSpeed * elapsed);
}

} // namespace

ShortText droppedText(double seconds) {
    return ShortText("dropped ").addNumber(seconds);
}

double droppedSeconds(std::string_view value) {
    constexpr std::string_view kWord = "dropped ";
    if (!value.starts_with(kWord)) return kLongestGuess;
    return std::clamp(parseDouble(value.substr(kWord.size())).value_or(kLongestGuess), 0.0, kLongestGuess);
}

int DirectionSense::add(double place) {
    if (!begun_) low_ = high_ = place;
    begun_ = true;
    low_ = std::min(low_, place);
    high_ = std::max(high_, place);
    const double threshold = direction_ == 0 ? kDirectionSense : kDirectionTurn;
    if (direction_ <= 0 && place - low_ >= threshold) {
        direction_ = 1;
        high_ = place;
    } else if (direction_ >= 0 && high_ - place >= threshold) {
        direction_ = -1;
        low_ = place;
    }
    return direction_;
}

void SlidingSlope::add(double time, double value) {
    count_ += 1;
    sumT_ += time;
    sumV_ += value;
    sumTT_ += time * time;
    sumTV_ += time * value;
}

void SlidingSlope::remove(double time, double value) {
    count_ -= 1;
    sumT_ -= time;
    sumV_ -= value;
    sumTT_ -= time * time;
    sumTV_ -= time * value;
}

double SlidingSlope::slope() const {
    const double spread = count_ * sumTT_ - sumT_ * sumT_;
    return count_ > 1.5 && spread > 0 ? (count_ * sumTV_ - sumT_ * sumV_) / spread : kUnknown;
}

Technique::Technique(const Seam& seam, const TechniqueSettings& settings) : seam_(seam), settings_(settings) {
    steps_.reserve(kStepsAtFirst);
}

void Technique::reset() {
    steps_.clear();
    now_ = {};
    faults_ = {};
    sense_.reset();
    slope_ = {};
    oldest_ = 0;
    burned_ = lost_ = false;
    guessedTo_ = kNever;
}

void Technique::noteDropped(double seconds) {
    if (!burned_) return;
    ++faults_.dropped;
    constexpr double kRounding = 1e-6; // rounding of the sum of many steps
    guessedTo_ = steps_.back().time + seconds + kRounding;
}

/// A place on a circle, with as many turns added as bring it next to the step before.
double Technique::continued(double place) const {
    if (!seam_.closed() || steps_.empty()) return place;
    return place + std::round((steps_.back().place - place) / seam_.length()) * seam_.length();
}

TechniqueStep Technique::measure(const TorchSample& torch, const ArcState& arc) const {
    const glm::dvec3 tip(torch.tip);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(torch.axis()));
    const glm::dvec3 foot = footOf(seam_, tip, axis);
    const SeamPlace at = seam_.nearest(foot);
    const SeamFrame frame = seam_.at(at.place);
    TechniqueStep step;
    step.time = torch.time;
    step.place = continued(at.place);
    step.aim = at.across;
    step.height = glm::dot(tip - frame.point, frame.up);
    step.distance = finite(arc.distance);
    if (settings_.distance == DistanceKind::arcLength) step.distance = arc.burns() ? finite(arc.length) : kUnknown;
    step.workAngle = std::atan2(-glm::dot(axis, frame.across), -glm::dot(axis, frame.up));
    step.lean = std::asin(std::clamp(glm::dot(axis, frame.tangent), -1.0, 1.0));
    step.current = static_cast<double>(arc.current);
    step.voltage = static_cast<double>(arc.voltage);
    step.rodAngle = step.rodGap = kUnknown;
    if (torch.rod) {
        const glm::dvec3 rod(torch.rod->orientation * glm::vec3(0, 0, -1));
        step.rodAngle = std::asin(std::clamp(-glm::dot(glm::normalize(rod), frame.up), -1.0, 1.0));
        step.rodGap = glm::dot(foot - glm::dvec3(torch.rod->tip), glm::normalize(rod));
    }
    return step;
}

/// Notes the faults of the new step; true if the hand is known in it.
bool Technique::noteFaults(double elapsed, bool burns, bool tracked) {
    if (burns) faults_.arcSeconds += elapsed;
    lost_ = !tracked && (lost_ || burns || burned_);
    if (lost_) faults_.lostSeconds += elapsed;
    const bool gap = burns && burned_ && elapsed > kLongestTechniqueStep;
    if (gap) ++faults_.dropped;
    burned_ = burns;
    return !lost_ && !gap;
}

void Technique::add(const TorchSample& torch, const ArcState& arc, bool tracked) {
    const double elapsed = steps_.empty() ? 0 : torch.time - steps_.back().time;
    const bool known = noteFaults(elapsed, arc.burns(), tracked);
    TechniqueStep step = measure(torch, arc);
    step.known = known && !(arc.burns() && step.time <= guessedTo_);
    step.welds = arc.burns() && tracked;
    step.joined = step.welds && !steps_.empty() && follows(step, steps_.back());
    steps_.push_back(step);
    updateNow();
}

void Technique::updateNow() {
    const TechniqueStep& step = steps_.back();
    if (!step.joined) {
        sense_.reset();
        slope_ = {};
        oldest_ = steps_.size() - 1;
        origin_ = step.time;
    }
    double speed = kUnknown;
    if (step.welds) {
        sense_.add(step.place);
        slope_.add(step.time - origin_, step.place);
        for (; steps_[oldest_].time < step.time - settings_.speedWindow; ++oldest_)
            slope_.remove(steps_[oldest_].time - origin_, steps_[oldest_].place);
        if (step.time - steps_[oldest_].time >= kLeastSpeedSpan) speed = slope_.slope();
    }
    const int direction = sense_.direction();
    now_ = {};
    now_[aim] = step.aim;
    now_[height] = step.height;
    now_[distance] = step.distance;
    now_[workAngle] = step.workAngle;
    now_[rodAngle] = step.rodAngle;
    now_[travelAngle] = direction == 0 ? kUnknown : direction * step.lean;
    now_[travelSpeed] = direction == 0 ? std::abs(speed) : direction * speed;
}

} // namespace meltpool
