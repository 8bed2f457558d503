// Asks for the next attempt over a result: the trigger of the hand without the torch, held.
#pragma once

namespace meltpool {

class AgainHold {
  public:
    static constexpr double kHold = 1; ///< s

    /// `pulled`: the trigger is pulled. `free`: a result is shown and the hand does not point at the panel. A pull that
    /// began before that asks for nothing. `elapsed`: s; a slow frame makes no hold of a short pull.
    void update(bool pulled, bool free, double elapsed);
    /// True in the one frame in which the hold is complete.
    bool asked() const { return asked_; }
    /// True while the trigger is held for it.
    bool holds() const { return held_ > 0; }

  private:
    double held_ = 0; ///< s
    bool pulled_ = false;
    bool asked_ = false;
};

} // namespace meltpool
