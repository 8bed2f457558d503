// Selects the carrier of the lesson's torch: the controller in the hand, or a tracker on a real torch.
#pragma once

#include "xr/input.hpp"

#include <span>
#include <string_view>

namespace meltpool {

enum class TorchHolder { hand, tracker };

/// Gives the torch to a requested tracker once it is tracked. While it is not, the arc is out, and after kPatience the
/// hand holds the torch until the tracker is back.
class TorchSelector {
  public:
    static constexpr double kPatience = 2; ///< s

    /// Takes the frame's hand and trackers. `wanted`: a tracker is to carry the torch.
    void update(bool wanted, const xr::HandInput& hand, std::span<const xr::TrackerInput> trackers, double elapsed);

    TorchHolder holder() const { return holder_; }
    /// Returns true if the holder or its tracker changed in this update, so that the torch jumps to another place.
    bool changed() const { return changed_; }
    /// Pose and trigger of the holder. With a tracker the trigger is the larger value of its wired one and the hand's.
    const xr::HandInput& torch() const { return torch_; }
    /// The tracker's number in xr::Input::trackers(); of the last one used if the hand holds the torch.
    size_t tracker() const { return tracker_; }
    /// Sentence for the person if a requested tracker is not tracked; else empty.
    std::string_view warning() const;

  private:
    void choose(bool wanted, std::span<const xr::TrackerInput> trackers, double elapsed);

    TorchHolder holder_ = TorchHolder::hand;
    bool wanted_ = false;
    bool seen_ = false; ///< a tracker has been tracked since the request
    bool visible_ = false;
    double lost_ = 0; ///< s
    size_t tracker_ = 0;
    bool changed_ = false;
    xr::HandInput torch_;
};

} // namespace meltpool
