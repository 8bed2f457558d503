// An auto-darkening welder's visor: dark with the arc, clear again a moment after it.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "core/render/look/look.hpp"

namespace meltpool {

class Visor {
  public:
    /// How long the visor stays dark after the arc went out, and how long it takes to clear, s.
    static constexpr double kHold = 0.15;
    static constexpr double kClearing = 0.25;

    /// Goes on by `elapsed` seconds; real visors darken within 0.1 ms, so the first frame with heat is dark.
    void update(bool heat, double elapsed) { sinceHeat_ = heat ? 0.0 : sinceHeat_ + elapsed; }

    /// Puts the visor before the eye. Metal in kelvin shines as it does, so the visor is the real filter; the classic
    /// lesson's source gives no light, and the view is only dimmed.
    void wear(const HeadsetParameters& parameters, bool kelvin, LookParameters& look) const;

    /// 1 dark .. 0 clear.
    float darkness(const HeadsetParameters& parameters) const;

  private:
    double sinceHeat_ = kHold + kClearing;
};

} // namespace meltpool
