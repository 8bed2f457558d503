#include "core/training/lesson/changed_path.hpp"

#include <glm/geometric.hpp>
#include <glm/gtx/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

/// Half width (s) of the mean around a still moment: with Hann's window it passes movements slower than 3 Hz and
/// removes all faster than 7 Hz.
constexpr double kWindow = 0.4;
/// Limit of a changed travel angle, rad from the plane across the seam.
constexpr double kMostLean = 80 * std::numbers::pi / 180;

double stepOf(const std::vector<AttemptStep>& steps) {
    if (steps.size() < 2) return 0;
    return (steps.back().torch.time - steps.front().torch.time) / static_cast<double>(steps.size() - 1);
}

/// Half of a low pass's weights, the middle one first: the sine cardinal of kTremorFrom under Hann's window.
std::vector<double> stillWeights(double step) {
    std::vector<double> weights{2 * kTremorFrom * step};
    for (int i = 1; i * step < kWindow; ++i) {
        const double time = i * step, angle = 2 * std::numbers::pi * kTremorFrom * time;
        const double window = 0.5 + 0.5 * std::cos(std::numbers::pi * time / kWindow);
        weights.push_back(std::sin(angle) / (std::numbers::pi * i) * window);
    }
    return weights;
}

/// Place and pose around one step without fast movements.
TorchSample stillSample(const std::vector<AttemptStep>& steps, const std::vector<double>& weights, size_t middle) {
    const glm::quat own = steps[middle].torch.orientation;
    glm::dvec3 tip(0);
    glm::dvec4 pose(0);
    double sum = 0;
    const auto reach = static_cast<std::ptrdiff_t>(weights.size()) - 1;
    for (std::ptrdiff_t i = -reach; i <= reach; ++i) {
        // Beyond the ends the hand keeps its last pose.
        const auto at = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(middle) + i, 0,
                                                   static_cast<std::ptrdiff_t>(steps.size()) - 1);
        const TorchSample& torch = steps[static_cast<size_t>(at)].torch;
        const double weight = weights[static_cast<size_t>(std::abs(i))];
        const glm::quat q = torch.orientation;
        const double sign = glm::dot(own, q) < 0 ? -weight : weight; // q and -q are the same pose
        tip += weight * glm::dvec3(torch.tip);
        pose += sign * glm::dvec4(q.x, q.y, q.z, q.w);
        sum += weight;
    }
    TorchSample still = steps[middle].torch;
    still.tip = glm::vec3(tip / sum);
    pose = glm::normalize(pose);
    still.orientation = glm::quat(static_cast<float>(pose.w), static_cast<float>(pose.x), static_cast<float>(pose.y),
                                  static_cast<float>(pose.z));
    return still;
}

std::vector<TorchSample> samplesOf(const std::vector<AttemptStep>& steps, double stillness) {
    std::vector<TorchSample> samples;
    samples.reserve(steps.size());
    const double step = stepOf(steps);
    const std::vector<double> weights = stillness > 0 && step > 0 ? stillWeights(step) : std::vector<double>{};
    for (size_t i = 0; i < steps.size(); ++i) {
        TorchSample torch = steps[i].torch;
        if (!weights.empty()) {
            const TorchSample still = stillSample(steps, weights, i);
            const auto share = static_cast<float>(stillness);
            torch.tip = glm::mix(torch.tip, still.tip, share);
            torch.orientation = glm::normalize(glm::slerp(torch.orientation, still.orientation, share));
        }
        samples.push_back(torch);
    }
    return samples;
}

std::vector<double> takenUpOf(const std::vector<AttemptStep>& steps) {
    const double rise = stepOf(steps) / kTakeUpSeconds;
    std::vector<double> shares;
    shares.reserve(steps.size());
    double share = 0;
    for (const AttemptStep& step : steps) {
        share = std::clamp(share + (step.burned ? rise : -rise), 0.0, 1.0);
        shares.push_back(share);
    }
    return shares;
}

double placeOf(const Seam& seam, const TorchSample& torch) {
    return seam.nearest(footOf(seam, glm::dvec3(torch.tip), glm::normalize(glm::dvec3(torch.axis())))).place;
}

/// Overall direction of the arc along the seam.
double directionOf(const std::vector<AttemptStep>& steps, const Seam& seam) {
    double way = 0, before = 0;
    bool burned = false;
    for (const AttemptStep& step : steps) {
        const double place = step.burned ? placeOf(seam, step.torch) : 0;
        if (step.burned && burned) {
            double part = place - before;
            if (seam.closed()) part -= std::round(part / seam.length()) * seam.length();
            way += part;
        }
        burned = step.burned;
        before = place;
    }
    return way < 0 ? -1 : 1;
}

} // namespace

ChangedPath::ChangedPath(std::vector<AttemptStep> steps, const Seam& seam, const PathChange& change)
    : steps_(std::move(steps)),
      takenUp_(takenUpOf(steps_)),
      path_(samplesOf(steps_, change.stillness)),
      seam_(seam),
      change_(change),
      direction_(directionOf(steps_, seam)) {}

double ChangedPath::duration() const {
    return path_.duration() / change_.speed;
}

ChangedPath::Moment ChangedPath::momentAt(double time) const {
    const auto next = std::upper_bound(steps_.begin(), steps_.end(), time,
                                       [](double t, const AttemptStep& step) { return t < step.torch.time; });
    if (next == steps_.begin()) return {};
    const auto step = static_cast<size_t>(next - steps_.begin()) - 1;
    if (next == steps_.end()) return {step, 0};
    const double begin = steps_[step].torch.time;
    return {step, (time - begin) / (next->torch.time - begin)};
}

/// Turns the torch about its target, so that aim and distance stay unchanged.
void ChangedPath::turn(TorchSample& torch) const {
    if (change_.workAngle == 0 && change_.travelAngle == 0) return;
    const glm::dvec3 tip(torch.tip), axis = glm::normalize(glm::dvec3(torch.axis()));
    const glm::dvec3 foot = footOf(seam_, tip, axis);
    const SeamFrame frame = seam_.at(seam_.nearest(foot).place);
    // The angles by Technique's definition.
    const double work = std::atan2(-glm::dot(axis, frame.across), -glm::dot(axis, frame.up)) + change_.workAngle;
    const double lean =
        std::clamp(std::asin(std::clamp(glm::dot(axis, frame.tangent), -1.0, 1.0)) + direction_ * change_.travelAngle,
                   -kMostLean, kMostLean);
    const glm::dvec3 wanted =
        std::sin(lean) * frame.tangent - std::cos(lean) * (std::cos(work) * frame.up + std::sin(work) * frame.across);
    const glm::dquat turned = glm::rotation(axis, glm::normalize(wanted));
    torch.tip = glm::vec3(foot + turned * (tip - foot));
    torch.orientation = glm::normalize(glm::quat(turned) * torch.orientation);
}

TorchSample ChangedPath::sample(double time, double burntOff) const {
    const double then = time * change_.speed;
    TorchSample torch = path_.sample(then);
    torch.time = time;
    if (steps_.empty()) return torch;
    if (torch.rod) torch.rod->feed *= static_cast<float>(change_.speed); // unchanged feed for each mm of seam
    turn(torch);
    const Moment moment = momentAt(then);
    const size_t next = std::min(moment.step + 1, steps_.size() - 1);
    const auto between = [&](double a, double b) { return moment.share > 0 ? a + (b - a) * moment.share : a; };
    const double burntThen = between(steps_[moment.step].burntOff, steps_[next].burntOff);
    const double farther = change_.farther * between(takenUp_[moment.step], takenUp_[next]);
    const double along = burntOff - burntThen - farther;
    if (along != 0) torch.tip += static_cast<float>(along) * torch.axis();
    return torch;
}

} // namespace meltpool
