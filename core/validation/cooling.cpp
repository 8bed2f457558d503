// Cooling of a weld: a bead on a plate, and the temperature of its surface at one place as a pyrometer sees it.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/case_weld.hpp"
#include "core/validation/plate_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace meltpool {

namespace {

constexpr double kLongest = 180; // s after the arc that a case waits for
constexpr int kBetween = 4;      // steps between two looks
// Spacings that the torch is past the place before the first look: drops in flight are no surface.
constexpr double kBehind = 2.5;
constexpr double kEightHundred = 1073.15, kFiveHundred = 773.15;

/// A temperature and the last time at which the surface fell through it, s.
struct Fall {
    double level;
    std::optional<double> at;
};

/// Watcher of the mean temperature of the particles on the surface at the seam's middle.
class Pyrometer {
  public:
    Pyrometer(const MetalState& state, const ValidationCase& from)
        : state_(state),
          falls_{{{from.number("hot_k"), {}}, {from.number("cold_k"), {}}, {kEightHundred, {}}, {kFiveHundred, {}}}} {}

    void look(double time) {
        const double now = temperature();
        for (Fall& fall : falls_)
            if (before_ >= fall.level && now < fall.level)
                fall.at = time - (time - timeBefore_) * (fall.level - now) / (before_ - now);
        hottest_ = std::max(hottest_, now);
        before_ = now;
        timeBefore_ = time;
    }
    double now() const { return before_; }
    double hottest() const { return hottest_; }
    /// Returns the time between falling through the hot and the cold temperature of the case, or from 800 to 500 °C, s.
    std::optional<double> hotToCold() const { return between(falls_[0], falls_[1]); }
    std::optional<double> eightToFive() const { return between(falls_[2], falls_[3]); }

  private:
    static std::optional<double> between(const Fall& high, const Fall& low) {
        if (!high.at || !low.at || *low.at <= *high.at) return std::nullopt;
        return *low.at - *high.at;
    }
    double temperature() const;

    const MetalState& state_;
    std::array<Fall, 4> falls_;
    double before_ = 0, timeBefore_ = 0, hottest_ = 0;
};

double Pyrometer::temperature() const {
    const auto positions = state_.position.read<vec4>(state_.particles());
    const auto phases = state_.phase.read<uint>(state_.particles());
    const float spacing = state_.lattice().spacing;
    const auto seen = [&](size_t i) {
        return (phases[i] & PHASE_ALIVE) && std::abs(positions[i].x) < spacing && std::abs(positions[i].z) < spacing;
    };
    float top = -std::numeric_limits<float>::max();
    for (size_t i = 0; i < positions.size(); ++i)
        if (seen(i)) top = std::max(top, positions[i].y);
    double sum = 0, count = 0;
    for (size_t i = 0; i < positions.size(); ++i) {
        if (!seen(i) || positions[i].y < top - 0.75F * spacing) continue;
        sum += static_cast<double>(positions[i].w);
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

} // namespace

void runCooling(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const PlatePath plate(from);
    plate.require(from);
    CaseWeld weld(from, shaders, plate.process, plate.workpiece(from), plate.ambient, plate.seconds());
    Pyrometer pyrometer(weld.weld().metal().state(), from);
    const double until = from.number("until_k") > 0 ? from.number("until_k") : from.number("cold_k");
    const double begin = 0.5 * plate.seconds() + kBehind * from.spacing / static_cast<double>(plate.speed);
    const auto watch = [&](double time) {
        if (result.steps % kBetween != 0 || time < begin) return true;
        pyrometer.look(time);
        const bool passed = pyrometer.hottest() > from.number("hot_k") || time > plate.seconds();
        return !(passed && pyrometer.now() < until) && time < plate.seconds() + kLongest;
    };
    weld.run(plate.torch(), watch, result);
    weld.tellArc(from, result);
    if (const auto seconds = pyrometer.hotToCold())
        result.compareMeasured(from, "cooling_rate_k_s", (from.number("hot_k") - from.number("cold_k")) / *seconds);
    if (const auto seconds = pyrometer.eightToFive()) result.compareMeasured(from, "t85_s", *seconds);
    result.tell("hottest_k", pyrometer.hottest());
    weld.requireArc(from);
    if (pyrometer.hottest() < from.number("hot_k"))
        throw InputError(from.file, 0,
                         "[case] hot_k: the weld's surface reached only " +
                             formatNumber(std::round(pyrometer.hottest())) + " K; expected a lower temperature");
}

} // namespace meltpool
