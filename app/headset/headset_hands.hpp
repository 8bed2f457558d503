// Both hands of the welder: one holds the torch (or a tracker does), the other the filler rod.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "app/headset/tip_measuring.hpp"
#include "app/headset/torch_selector.hpp"
#include "app/headset/tracked_torch.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

class HeadsetHands {
  public:
    /// Reads the calibrations of controller and tracker from `torch-tip.txt` and `torch-tip-tracker.txt` in `folder`
    /// where they exist; measured ones are written there. Throws InputError for a broken file.
    HeadsetHands(const HeadsetParameters& parameters, const std::filesystem::path& folder);

    /// Takes the frame's controllers and trackers. `elapsed`: real seconds since the last frame.
    void update(const xr::Input& input, const Workshop& workshop, double elapsed);
    /// The arc is out until the trigger has been let go.
    void putOut(ArcOut reason) { torch_.putOut(reason); }
    /// No controller is known any more: the arc is out.
    void lose(ArcOut reason) { torch_.lose(reason); }
    /// No step has been made yet: a lesson begins.
    void forgetSteps() { torch_.forgetSample(); }

    const TrackedTorch& torch() const { return torch_; }
    /// Grip of the hand that holds the filler rod, in the workshop; nothing while it is not tracked.
    const std::optional<xr::Pose>& rod() const { return rod_; }
    /// The hand that holds the torch, by the person's choice.
    xr::Hand torchHand() const;
    /// What carries the torch's pose now.
    const TorchSelector& selector() const { return selector_; }
    /// Torch and rod in the workpiece's frame as they are now.
    TorchSample sample(const WorkpiecePlace& place) const;
    /// The same for step `step` (from 0) of the `steps` of this frame; to be called in the order of the steps.
    TorchSample next(const WorkpiecePlace& place, int step, int steps);

    void measureTip() { measuring_.begin(TipMeasuring::Task::pivot); }
    void measureAxis() { measuring_.begin(TipMeasuring::Task::axis); }
    /// What the measuring wants or has found; empty where none was asked for.
    std::string tipReport() const { return measuring_.report(); }
    /// Why the arc cannot burn; empty while the torch is tracked.
    std::string_view warning() const;

  private:
    void updateTorch(const xr::Input& input, const Workshop& workshop, double elapsed);
    TorchSample withRod(TorchSample sample, const WorkpiecePlace& place) const;

    const HeadsetParameters& parameters_;
    std::array<CalibrationFile, 2> calibrations_; ///< by TorchHolder
    TipMeasuring measuring_;
    TorchSelector selector_;
    TrackedTorch torch_;
    std::optional<xr::Pose> rod_; ///< grip of the other hand in the workshop, nothing while it is not tracked
};

} // namespace meltpool
