// An auto-darkening welder's visor: dark while the arc burns, clear again a moment later.
#pragma once

#include "app/headset/torch/headset_parameters.hpp"
#include "core/render/look/look.hpp"

namespace meltpool {

class Visor {
  public:
    /// How long the visor stays dark after the arc went out, and how long it takes to clear, s.
    static constexpr double kHold = 0.15;
    static constexpr double kClearing = 0.25;

    /// `elapsed`: real seconds since the last frame. Real visors darken within 0.1 ms, so the first frame with heat is
    /// dark.
    void update(bool heat, double elapsed) { sinceHeat_ = heat ? 0.0 : sinceHeat_ + elapsed; }

    /// Sets the visor in `look`. With temperatures in kelvin the metal radiates physically and the visor is a filter of
    /// its shade; in the classic lesson, whose source gives no light, the picture is only dimmed.
    void wear(const HeadsetParameters& parameters, bool kelvin, LookParameters& look) const;

    /// 1 dark .. 0 clear.
    float darkness(const HeadsetParameters& parameters) const;

  private:
    double sinceHeat_ = kHold + kClearing;
};

} // namespace meltpool
