// Visor and eye together, for window and headset alike: darkness of the picture, and the after-image of an arc.
#pragma once

#include "core/render/effects/eye_adaptation.hpp"
#include "core/render/effects/visor_filter.hpp"
#include "core/render/look/look.hpp"

#include <string>
#include <string_view>

namespace meltpool {

/// The arc in the eye's view in a frame.
struct SeenArc {
    double intensity = 0; ///< kPaperLuminance times m²; 0: none burns
    double height = 0;    ///< m over the metal
    bool inSight = true;
    glm::vec3 towards{0, 0, -1}; ///< unit, in the eye's own directions
};

class WornVisor {
  public:
    /// Shade number below which an arc dazzles. EN 169 has 8 for the weakest arcs.
    static constexpr float kProtects = 7;
    /// s: shortest look into the arc that is reported, and duration of the report.
    static constexpr double kLeastLook = 0.1, kTold = 6;

    /// Advances visor and eye. `look`: with its light and arc's share. `elapsed`: real s since the last call.
    void update(const SeenArc& arc, const VisorSettings& visor, const LookParameters& look, double elapsed);

    /// Puts the shade into the look, and with `look.adaptation` on the eye's exposure.
    void wear(const VisorSettings& visor, LookParameters& look) const;

    const VisorFilter& filter() const { return filter_; }
    const EyeAdaptation& eye() const { return eye_; }
    /// Returns a sentence about a look into the arc without enough of a filter; empty without a recent one. Valid until
    /// the next update().
    std::string_view sentence() const { return text_; }

  private:
    void tell();

    VisorFilter filter_;
    EyeAdaptation eye_;
    bool worn_ = false; ///< a visor was on at the last look
    std::string text_;
};

/// Returns the visor that a look asks for.
VisorSettings visorOf(const LookParameters& look);

} // namespace meltpool
