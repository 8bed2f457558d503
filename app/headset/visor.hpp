// An auto-darkening welder's visor: dark with the arc, clear again a moment after it.
#pragma once

#include "app/headset/headset_parameters.hpp"

namespace meltpool {

class Visor {
  public:
    /// How long the visor stays dark after the arc went out, and how long it takes to clear, s.
    static constexpr double kHold = 0.15;
    static constexpr double kClearing = 0.25;

    /// Goes on by `elapsed` seconds; real visors darken within 0.1 ms, so the first frame with heat is dark.
    void update(bool heat, double elapsed) { sinceHeat_ = heat ? 0.0 : sinceHeat_ + elapsed; }

    /// Share of the light that comes through now.
    float transmission(const HeadsetParameters& parameters) const;

  private:
    double sinceHeat_ = kHold + kClearing;
};

} // namespace meltpool
