// What the lesson's torch is fixed to: the controller in the hand, or a tracker on a real torch.
#pragma once

#include "xr/input/input.hpp"

#include <span>
#include <string_view>

namespace meltpool {

enum class TorchHolder { hand, tracker };

/// A tracker that is wanted holds the torch from when it is first seen. Out of sight its arc is out; after kPatience
/// the hand has the torch until the tracker is back. Whenever the holder changes, the arc stays out until the trigger
/// was let go once: no arc strikes where nobody meant it to.
class TorchSelector {
  public:
    static constexpr double kPatience = 2; ///< s

    /// Takes the frame's hand and trackers. `wanted`: the torch shall be on a tracker.
    void update(bool wanted, const xr::HandInput& hand, std::span<const xr::TrackerInput> trackers, double elapsed);

    TorchHolder holder() const { return holder_; }
    /// The holder changed in this update: no way leads from the old place to the new.
    bool changed() const { return changed_; }
    /// Pose and trigger of the holder. A tracker's trigger is the one wired to it or the hand's, whichever is pulled
    /// more.
    const xr::HandInput& torch() const { return torch_; }
    /// Number of the tracker among those of the runtime; that of the last one where the hand holds the torch.
    size_t tracker() const { return tracker_; }
    /// A tracker is wanted and not there: what to tell; else empty.
    std::string_view warning() const;

  private:
    void choose(bool wanted, std::span<const xr::TrackerInput> trackers, double elapsed);

    TorchHolder holder_ = TorchHolder::hand;
    bool wanted_ = false;
    bool seen_ = false; ///< a tracker was there since it is wanted
    bool inSight_ = false;
    double lost_ = 0; ///< s
    size_t tracker_ = 0;
    bool changed_ = false;
    bool blocked_ = false; ///< until the trigger is let go
    xr::HandInput torch_;
};

} // namespace meltpool
