// The clock of a recording: its unit and its start.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <string>
#include <vector>

namespace meltpool {

/// Conversion of a table's times to seconds from the path's beginning.
struct TorchClock {
    std::string unit = "s"; ///< s, ms, us or ns
    bool judged = false;    ///< true if the size of the numbers decides; else the header has the unit, or it is s
    bool shifted = false;   ///< the path begins at 0, the clock did not
    double begin = 0;       ///< s on the clock at the first row, if shifted
};

/// Longest pause, s, before a path begins: a clock's first moment later than this, or below 0, is no pause.
inline constexpr double kLongestPause = 10; ///< s

/// Turns the times of `samples`, which ascend in the clock's unit, into s. `factor` (s in a unit) comes from the
/// header; `judge`: it is not sure, and is made smaller by thousands if the numbers cannot be that unit: a date beyond
/// the year 5000, or rows a second and more apart in a path of more than an hour or of less than 0.05 mm/s. A path that
/// begins below 0 or behind kLongestPause is moved to 0. Times that are s already stay identical to the bit.
TorchClock settleTimes(std::vector<TorchSample>& samples, double factor, bool judge);

} // namespace meltpool
