// Models the welder's visor in the headset, with the eye behind it: dark while the arc burns, clear again a moment
// later.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "core/render/effects/worn_visor.hpp"
#include "core/render/look/look.hpp"

#include <algorithm>

namespace meltpool {

class Visor {
  public:
    static constexpr double kHold = VisorFilter::kHold, kClearing = VisorFilter::kClearing;
    static constexpr double kLifting = 0.3; ///< s

    /// Takes the heat of a source that gives no light of its own, in the classic lesson. `elapsed`: real seconds since
    /// the last frame.
    void update(bool heat, double elapsed) { heat_.update(heat, elapsed, {}); }
    /// Takes the arc of a weld. `look`: the lesson's.
    void update(const HeadsetParameters& parameters, const SeenArc& arc, const LookParameters& look, double elapsed) {
        worn_.update(arc, settingsOf(parameters), look, elapsed);
    }

    /// Lifts the visor while the person `reads` and no arc burns, and lowers it again. `elapsed`: as above.
    void read(bool reads, double elapsed) {
        const auto step = static_cast<float>(elapsed / kLifting);
        lifted_ += std::clamp((reads ? 1.0f : 0.0f) - lifted_, -step, step);
    }

    /// Sets the visor in `look`. With temperatures in kelvin the metal radiates physically and the visor is a filter of
    /// its shade; in the classic lesson, whose source gives no light, the picture is only dimmed.
    void wear(const HeadsetParameters& parameters, bool kelvin, LookParameters& look) const;

    /// 1 dark .. 0 clear.
    float darkness(const HeadsetParameters& parameters) const { return parameters.visor ? heat_.darkness() : 0; }
    /// Returns true if the visor of a weld is nearly dark.
    bool hides(const HeadsetParameters& parameters) const {
        return parameters.visor && worn_.filter().darkness() > 0.5f;
    }
    /// After-image of an arc in the eye; empty if the eye does not adapt.
    AfterImage afterImage(const HeadsetParameters& parameters) const {
        return parameters.adaptation ? worn_.eye().afterImage() : AfterImage{};
    }
    /// See WornVisor::sentence().
    std::string_view sentence(const HeadsetParameters& parameters) const {
        return parameters.adaptation ? worn_.sentence() : std::string_view();
    }

  private:
    VisorSettings settingsOf(const HeadsetParameters& parameters) const {
        // A light shade of 0 is a clear pane, which is no filter; the lowest filter passes almost all light.
        const float light = std::max(parameters.visorLightShade, 1.0f);
        return {parameters.visor ? parameters.visorShade : 0, light + (1 - light) * lifted_, parameters.visorSwitching};
    }

    VisorFilter heat_;
    float lifted_ = 0; ///< 0 down .. 1 up
    WornVisor worn_;
};

} // namespace meltpool
