// One's own torch path with the hand changed: faster or slower, farther off, at other angles, without tremor.
#pragma once

#include "core/training/judging/seam.hpp"
#include "core/training/lesson/what_if.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <vector>

namespace meltpool {

/// A step of the attempt as it was welded.
struct AttemptStep {
    TorchSample torch;   ///< its time is that of the step's end
    double burntOff = 0; ///< m, Process::burntOff() before the step
    bool burned = false; ///< the arc, before the step
};

/// Seconds over which a longer arc is taken up from the strike on, and given back after the arc went out: who strikes
/// does so from where it can be struck.
inline constexpr double kTakeUpSeconds = 0.5;
/// Hz: what the hand does faster is its tremor (7 to 12 Hz, see HandTremor); weave, whip and dips are slower.
inline constexpr double kTremorFrom = 5;

class ChangedPath {
  public:
    /// `steps` follow each other evenly. Expects a change without a wanted travel speed, see PathChange::resolved().
    ChangedPath(std::vector<AttemptStep> steps, const Seam& seam, const PathChange& change);

    /// s of the whole path.
    double duration() const;

    /// The torch at `time` s, of an electrode that has burned off by `burntOff` m: the hand goes on following it, so
    /// that it keeps the distance which it kept in the attempt. Nothing changed and as much burned off as then: the
    /// attempt's own bits at its steps.
    TorchSample sample(double time, double burntOff) const;

  private:
    struct Moment {
        size_t step = 0;  ///< the last one that is over
        double share = 0; ///< of the way to the next
    };
    Moment momentAt(double time) const;
    void turn(TorchSample& torch) const;

    std::vector<AttemptStep> steps_;
    std::vector<double> takenUp_; ///< 0..1, share of the longer arc after each step
    TorchPath path_;              ///< of the steps, as still as is asked for
    Seam seam_;
    PathChange change_;
    double direction_ = 1; ///< of travel along the seam, +1 or -1
};

} // namespace meltpool
