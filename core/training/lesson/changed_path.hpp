// Changes the hand in one's own torch path: faster or slower, farther off, at other angles, without tremor.
#pragma once

#include "core/training/judging/seam.hpp"
#include "core/training/lesson/what_if.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <vector>

namespace meltpool {

/// A step of the attempt as welded.
struct AttemptStep {
    TorchSample torch;   ///< its time is the end of the step
    double burntOff = 0; ///< m, Process::burntOff() before the step
    bool burned = false; ///< the arc, before the step
};

/// Seconds over which a longer arc builds up after the strike and shrinks back after the arc went out: a strike is only
/// possible from its own distance.
inline constexpr double kTakeUpSeconds = 0.5;
/// Hz: faster movements of the hand are its tremor (7 to 12 Hz, see HandTremor); weave, whip and dips are slower.
inline constexpr double kTremorFrom = 5;

class ChangedPath {
  public:
    /// `steps` must be evenly spaced in time. Expects a change without a wanted travel speed, see
    /// PathChange::resolved().
    ChangedPath(std::vector<AttemptStep> steps, const Seam& seam, const PathChange& change);

    /// Duration of the whole path, s.
    double duration() const;

    /// The torch at `time` s, for an electrode that has burned off by `burntOff` m: the hand goes on following it, so
    /// that it keeps the distance of the attempt. An empty change with equal burn-off gives the attempt's own bits at
    /// its steps.
    TorchSample sample(double time, double burntOff) const;

  private:
    struct Moment {
        size_t step = 0;  ///< last step before the time
        double share = 0; ///< share of the way to the next step
    };
    Moment momentAt(double time) const;
    void turn(TorchSample& torch) const;

    std::vector<AttemptStep> steps_;
    std::vector<double> takenUp_; ///< 0..1, share of the longer arc after each step
    TorchPath path_;              ///< path of the steps, stilled as requested
    Seam seam_;
    PathChange change_;
    double direction_ = 1; ///< direction of travel along the seam, +1 or -1
};

} // namespace meltpool
