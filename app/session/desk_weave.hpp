// The swings across the seam that the desk's torch makes by itself, as the lesson's demonstration swings: no mouse is
// quick enough for them.
#pragma once

#include "core/weld/torch/torch_path.hpp"

#include <optional>

namespace meltpool {

class DeskWeave {
  public:
    /// Takes width, frequency and dwell of this path's first weave; off, at the middle of a swing.
    void begin(const TorchPath& demonstration);
    /// Weave of the demonstration; empty: the lesson asks for none.
    const std::optional<Weave>& weave() const { return weave_; }
    /// Switches the swings on or off; a no-op without a weave.
    void toggle() { on_ = weave_ && !on_; }
    bool on() const { return on_; }
    /// True if the torch has swung since begin().
    bool swung() const { return swung_; }

    /// Offset across the seam after the next `seconds` of the metal's time, m. It swings while it is on and the torch
    /// `welds`; a swing that has begun ends in the middle.
    double next(double seconds, bool welds);

  private:
    std::optional<Weave> weave_;
    bool on_ = false;
    bool swung_ = false;
    double phase_ = 0; ///< whole swings; 0 and 0.5 are in the middle
};

} // namespace meltpool
