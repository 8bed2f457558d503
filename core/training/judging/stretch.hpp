// Analyses one stretch of burning arc, from a strike to the next interruption, where a value needs the steps around a
// step.
#pragma once

#include "core/training/judging/technique.hpp"

#include <span>
#include <vector>

namespace meltpool {

/// Least movement to and fro, m; smaller ones are tremor.
inline constexpr double kLeastWeave = 1e-3;
inline constexpr double kLeastWhip = 1.5e-3;
inline constexpr double kLeastDip = 2e-3;

/// Steps of an attempt from `begin` to before `end`.
struct StepRange {
    size_t begin = 0;
    size_t end = 0;
};

/// The steps that weld, without gaps: each range ends when the arc goes out, tracking is lost, samples are missing or
/// the torch jumps.
std::vector<StepRange> weldedStretches(std::span<const TechniqueStep> steps);

struct StretchValues {
    TechniqueValues values;
    int direction = 0;
};

/// All quantities in every step of one stretch, see alongSeam(). `direction`: of the stretch before; it holds until
/// this stretch shows its own, or throughout if this one never moves kDirectionSense.
std::vector<StretchValues> analyseStretch(std::span<const TechniqueStep> stretch, const TechniqueSettings& settings,
                                          int direction);

} // namespace meltpool
