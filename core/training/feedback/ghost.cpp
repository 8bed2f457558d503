#include "core/training/feedback/ghost.hpp"

#include "core/base/words.hpp"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

/// Arc state for Technique, from a path that knows only its trigger.
ArcState arcOf(const TorchSample& torch) {
    ArcState arc;
    arc.action = torch.trigger > 0 ? ArcAction::burning : ArcAction::out;
    arc.noArc = torch.trigger > 0 ? NoArc::burns : NoArc::released;
    return arc;
}

/// Interpolates; a value known at one end only is held.
double between(double a, double b, double share) {
    if (share <= 0 || std::isnan(b)) return a;
    return std::isnan(a) ? b : glm::mix(a, b, share);
}

} // namespace

GhostPath::GhostPath(const TorchPath& torch, const Seam& seam, const TechniqueSettings& settings)
    : torch_(torch), turn_(seam.closed() ? seam.length() : 0) {
    if (torch_.empty()) return;
    const double duration = torch_.duration();
    const double grain = std::max(kGrain, duration / kMostMoments);
    Technique technique(seam, settings);
    for (size_t i = 0;; ++i) {
        const double time = std::min(static_cast<double>(i) * grain, duration);
        const TorchSample sample = torch_.sample(time);
        technique.add(sample, arcOf(sample));
        const TechniqueStep& step = technique.steps().back();
        if (step.welds && std::isfinite(step.place))
            moments_.push_back({time, step.place, step.height, technique.now()[TechniqueQuantity::travelSpeed],
                                step.workAngle, step.lean, step.joined});
        if (direction_ == 0) direction_ = technique.direction();
        if (time >= duration) break;
    }
    for (size_t i = 0; i < moments_.size(); ++i)
        addReach(i > 0 ? &moments_[i - 1] : nullptr, moments_[i]);
}

/// Notes the farthest place so far. If the path comes back to its farthest place and goes beyond it, both are noted:
/// that place at the time of the return, and the new one.
void GhostPath::addReach(const Moment* before, const Moment& moment) {
    const double sign = direction_ < 0 ? -1 : 1, way = sign * moment.place;
    if (before == nullptr) return reached_.push_back({way, moment.time, false});
    const double farthest = reached_.back().way;
    if (way <= farthest) return;
    const bool joined = moment.joined;
    if (joined) {
        const double last = sign * before->place;
        const double share = way > last ? (farthest - last) / (way - last) : 0;
        reached_.push_back({farthest, glm::mix(before->time, moment.time, share), true});
    }
    reached_.push_back({way, moment.time, joined});
}

GhostMoment GhostPath::momentAt(double time) const {
    const auto next = std::upper_bound(moments_.begin(), moments_.end(), time,
                                       [](double t, const Moment& moment) { return t < moment.time; });
    const Moment& b = next == moments_.end() ? moments_.back() : *next;
    const Moment& a = next == moments_.begin() ? b : *(next - 1);
    const double share = b.joined && b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
    const double sign = direction_ < 0 ? -1 : 1;
    GhostMoment result;
    result.torch = torch_.sample(time);
    result.place = between(a.place, b.place, share);
    result.height = between(a.height, b.height, share);
    result.speed = between(a.speed, b.speed, share);
    result.workAngle = between(a.workAngle, b.workAngle, share);
    result.travelAngle = sign * between(a.lean, b.lean, share);
    return result;
}

std::optional<GhostMoment> GhostPath::atWay(double way) const {
    if (way < reached_.front().way || way > reached_.back().way) return std::nullopt;
    const auto next = std::upper_bound(reached_.begin(), reached_.end(), way,
                                       [](double w, const Reach& reach) { return w < reach.way; });
    if (next == reached_.end()) return momentAt(reached_.back().time);
    const Reach& before = *(next - 1);
    if (way == before.way) return momentAt(before.time);
    if (!next->joined) return std::nullopt;
    return momentAt(glm::mix(before.time, next->time, (way - before.way) / (next->way - before.way)));
}

std::optional<GhostMoment> GhostPath::atPlace(double place) const {
    if (empty() || !std::isfinite(place)) return std::nullopt;
    const double way = direction_ < 0 ? -place : place;
    if (turn_ <= 0) return atWay(way);
    // The place some turns on, within the path; this turn first.
    if (auto here = atWay(way)) return here;
    const double turns = std::ceil((reached_.front().way - way) / turn_);
    return atWay(way + turns * turn_);
}

std::optional<GhostMoment> GhostPath::atTime(double seconds) const {
    if (empty() || !(seconds <= duration())) return std::nullopt;
    return momentAt(moments_.front().time + std::max(seconds, 0.0));
}

GhostDelta ghostDelta(const Technique& hand, int direction, const GhostMoment& moment, const GhostPath& ghost) {
    const TechniqueStep& step = hand.steps().back();
    GhostDelta delta;
    delta.speed = hand.now()[TechniqueQuantity::travelSpeed] - moment.speed;
    delta.workAngle = step.workAngle - moment.workAngle;
    const double pushed = direction == 0 ? std::numeric_limits<double>::quiet_NaN() : direction * step.lean;
    delta.travelAngle = pushed - moment.travelAngle;
    double way = step.place - moment.place;
    if (const Seam& seam = hand.seam(); seam.closed()) way -= std::round(way / seam.length()) * seam.length();
    delta.ahead = ghost.direction() < 0 ? -way : way;
    return delta;
}

GhostWords::Line& GhostWords::Line::operator+=(std::string_view piece) {
    const size_t fits = std::min(piece.size(), text.size() - length);
    std::copy_n(piece.begin(), fits, text.begin() + static_cast<std::ptrdiff_t>(length));
    length += fits;
    return *this;
}

void GhostWords::add(std::string_view key, double amount, int digits) {
    appendPhrase(lines_[count_++], key, {{"amount", PhraseNumber(amount, digits)}});
}

GhostWords::GhostWords(const GhostDelta& delta, GhostPace pace) {
    // A comparison with an unknown value is false.
    const double speed = std::round(std::abs(delta.speed) * 1e4) / 10;
    if (speed > 0) add(delta.speed > 0 ? "ghost.faster" : "ghost.slower", speed, 1);
    const auto angle = [&](double radians, std::string_view more, std::string_view less) {
        const double degrees = std::round(std::abs(glm::degrees(radians)));
        if (degrees > 0) add(radians > 0 ? more : less, degrees, 0);
    };
    angle(delta.workAngle, "ghost.work_angle.more", "ghost.work_angle.less");
    angle(delta.travelAngle, "ghost.travel_angle.more", "ghost.travel_angle.less");
    const double ahead = std::round(std::abs(delta.ahead) * 1e3);
    if (pace == GhostPace::time && ahead > 0) add(delta.ahead > 0 ? "ghost.ahead" : "ghost.behind", ahead, 0);
}

} // namespace meltpool
