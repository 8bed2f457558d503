// The clock of somebody's recording: in which unit it counts, and when it began.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <string>
#include <vector>

namespace meltpool {

/// How the times of a table became seconds from the path's beginning.
struct TorchClock {
    std::string unit = "s"; ///< s, ms, us or ns
    bool judged = false;    ///< by the size of the numbers; else the header tells it, or they are s
    bool shifted = false;   ///< the path begins at 0, the clock did not
    double begin = 0;       ///< s on the clock at the first row, where shifted
};

/// Later than this, or below 0, a clock's first moment is no pause before the path begins.
inline constexpr double kLongestPause = 10; ///< s

/// Turns the times of `samples`, which ascend in the clock's unit, into s. `factor` (s in a unit) comes from the
/// header; `judge`: it is not sure, and is made smaller by thousands where the numbers cannot be that unit: a
/// date beyond the year 5000, or rows a second and more apart in a path of more than an hour or of less than 0.05 mm/s.
/// A path that begins below 0 or behind kLongestPause is brought to 0. Times that are s already keep their bits.
TorchClock settleTimes(std::vector<TorchSample>& samples, double factor, bool judge);

} // namespace meltpool
