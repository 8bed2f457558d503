// Reads both hands of the welder: one holds the torch (or a tracker does), the other the filler rod.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "app/headset/tip_measuring.hpp"
#include "app/headset/torch_selector.hpp"
#include "app/headset/tracked_torch.hpp"
#include "core/scene/torch_geometry.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

class HeadsetHands {
  public:
    /// Reads the calibrations of controller and tracker from `torch-tip.txt` and `torch-tip-tracker.txt` in `folder` if
    /// they exist; new measurements are written there. Throws InputError for a broken file.
    HeadsetHands(const HeadsetParameters& parameters, const std::filesystem::path& folder);

    /// Takes the frame's controllers and trackers. `geometry`: of the lesson's torch, whose tip counts until another is
    /// measured. `elapsed`: real seconds since the last frame.
    void update(const xr::Input& input, const Workshop& workshop, const TorchGeometry& geometry, double elapsed) {
        update({&input.hand(xr::Hand::left), &input.hand(xr::Hand::right)}, input.trackers(), workshop, geometry,
               elapsed);
    }
    /// Takes these controllers, left and right, and trackers.
    void update(const std::array<const xr::HandInput*, 2>& controllers, std::span<const xr::TrackerInput> trackers,
                const Workshop& workshop, const TorchGeometry& geometry, double elapsed);
    /// Puts the arc out until the trigger is released.
    void putOut(ArcOut reason) { torch_.putOut(reason); }
    /// Forgets the controllers, which puts the arc out.
    void lose(ArcOut reason) { torch_.lose(reason); }
    /// Forgets the last sample when a lesson begins: no step exists yet.
    void forgetSteps() { torch_.forgetSample(); }

    const TrackedTorch& torch() const { return torch_; }
    /// Hand that holds the torch, where it was last tracked.
    const HandPose& holder() const { return holder_; }
    /// Hand that holds the filler rod; empty while it is not tracked.
    const std::optional<HandPose>& rod() const { return rod_; }
    /// Hand that holds the torch, by the person's choice.
    xr::Hand torchHand() const;
    /// Selector of the device that carries the torch's pose.
    const TorchSelector& selector() const { return selector_; }
    /// Current torch and rod in the workpiece's frame.
    TorchSample sample(const WorkpiecePlace& place) const;
    /// Torch and rod for step `step` (from 0) of the `steps` of this frame; call in the order of the steps.
    TorchSample next(const WorkpiecePlace& place, int step, int steps);

    void measureTip() { measuring_.begin(TipMeasuring::Task::pivot); }
    void measureAxis() { measuring_.begin(TipMeasuring::Task::axis); }
    /// Returns true if the tip in use was measured: it is then the same for all torches.
    bool tipMeasured() const { return calibrations_[size_t(selector_.holder())].measured(); }
    /// Forgets the measured tip and its file: the lesson's torch has its own again.
    void useOwnTip();
    /// Instruction or result of the measuring; empty if no measuring was requested.
    std::string tipReport() const { return measuring_.report(); }
    /// Reason why the arc cannot burn; empty while the torch is tracked.
    std::string_view warning() const;

  private:
    void updateTorch(const xr::HandInput& hand, std::span<const xr::TrackerInput> trackers, const Workshop& workshop,
                     const TorchGeometry& geometry, double elapsed);
    TorchSample withRod(TorchSample sample, const WorkpiecePlace& place) const;

    const HeadsetParameters& parameters_;
    std::array<CalibrationFile, 2> calibrations_; ///< indexed by TorchHolder
    TipMeasuring measuring_;
    TorchSelector selector_;
    TrackedTorch torch_;
    HandPose holder_;
    std::optional<HandPose> rod_; ///< the other hand, empty while it is not tracked
    bool otherAlone_ = false;     ///< only the other hand has a controller
};

} // namespace meltpool
