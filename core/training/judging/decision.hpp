// The one rule by which a figure of a weld passes a limit, fails it, or is too uncertain for either.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meltpool {

enum class VerdictState { pass, fail, notResolved, estimated };

/// Names of the states in files, in the order of VerdictState.
inline constexpr std::array<std::string_view, 4> kVerdictStates{"pass", "fail", "not_resolved", "estimated"};
constexpr std::string_view nameOf(VerdictState state) {
    return kVerdictStates[static_cast<size_t>(state)];
}

/// Decides by the excess over a limit (negative: on the safe side) and its uncertainty, in one unit:
/// - fail if the excess is greater than the uncertainty,
/// - pass if the excess is at least the uncertainty below 0,
/// - not resolved otherwise, and for an unknown excess (NaN).
VerdictState decide(double excess, double uncertainty);

/// Uncertainty of readings of one kind, in their unit.
struct ReadingUncertainty {
    double single = 0; ///< of one station alone: a particle for a length
    double least = 0;  ///< of a mean over any number of stations: the gauge's own error
    double cut = 0;    ///< m along the seam that one station is measured over; stations nearer than this share metal
    double pitch = 0;  ///< m from station to station

    /// Number of independent readings among `count` neighbouring stations.
    double independent(size_t count) const;
    /// Of the mean over `count` neighbouring stations: the single one's over the root of the independent ones.
    double ofMean(size_t count) const;
    /// Of the mean over the whole weld, which shows its own scatter: twice the standard error of its mean, if there are
    /// at least kLeastForScatter independent readings and that is finer than ofMean().
    double ofWhole(std::span<const double> values) const;
};

/// Independent readings from which their scatter counts.
inline constexpr double kLeastForScatter = 3;

/// One station against its limits.
struct Reading {
    double place = 0;      ///< m along the seam
    double value = 0;      ///< in the imperfection's unit
    double limit = 0;      ///< the main limit; NaN: unknown
    double shortLimit = 0; ///< limit of short ones; without an allowance the main limit
    double excess = 0;     ///< over the main limit; negative on the safe side
    double shortExcess = 0;
};

/// Neighbouring stations, judged by their mean.
struct ReadingRun {
    size_t first = 0, count = 0;
    double value = 0, limit = 0; ///< means; `limit` is the mean that the allowance for short ones leaves a run so long
    double excess = 0;
    double uncertainty = 0;
    double place = 0; ///< m along the seam, its middle

    double margin() const { return excess - uncertainty; }
};

/// Returns the mean of a run. `allowed`: m of the run on which the limit of short ones holds, the main limit elsewhere.
ReadingRun meanOf(std::span<const Reading> readings, size_t first, size_t count, double allowed,
                  const ReadingUncertainty& uncertainty);

} // namespace meltpool
