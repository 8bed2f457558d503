// The hand of a weld at a chart's values: it strikes as the process asks, waits for a pool, and welds along the seam.
#pragma once

#include "core/validation/torch_run.hpp"

#include <optional>

namespace meltpool {

/// Path of the hand along x, with lengths in m.
struct ChartHand {
    double from = 0, to = 0;    ///< ends of the weld
    double travel = 0;          ///< s from one to the other
    double aim = 0;             ///< off the seam, on the base plate
    TorchPose held;             ///< of an electrode's end, or of a wire's at its stick-out
    Weave weave;                ///< width 0: none; without dwell
    double follow = 0;          ///< m/s along the electrode, after its end that burns off
    std::optional<RodHold> rod; ///< held still until the torch travels; its directions are not used
};

/// Returns the time (s) from the start to the departure along the seam.
double strikingSeconds(const ProcessSettings& process);

/// Returns the path of this hand; the arc ends with it. A covered electrode touches at the weld's beginning, is lifted,
/// and follows its end that burns off.
TorchPath chartPath(const ChartHand& hand, const ProcessSettings& process);

} // namespace meltpool
