// Visor and eye together, for window and headset alike: how dark the picture is, and what an arc leaves in the eye.
#pragma once

#include "core/render/effects/eye.hpp"
#include "core/render/effects/visor_filter.hpp"
#include "core/render/look/look.hpp"

#include <string>
#include <string_view>

namespace meltpool {

/// What the eye sees of the arc in a frame.
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
    /// s of a look into the arc that are told, and how long they are.
    static constexpr double kLeastLook = 0.1, kTold = 6;

    /// `look`: with its light and arc's share. `elapsed`: real s since the last call.
    void update(const SeenArc& arc, const VisorSettings& visor, const LookParameters& look, double elapsed);

    /// Puts the shade into the look, and where `look.adaptation` is on the eye's exposure.
    void wear(const VisorSettings& visor, LookParameters& look) const;

    const VisorFilter& filter() const { return filter_; }
    const Eye& eye() const { return eye_; }
    /// A look into the arc without enough of a filter, as a sentence; empty where there was none lately. Valid until
    /// the next update().
    std::string_view sentence() const { return text_; }

  private:
    void tell();

    VisorFilter filter_;
    Eye eye_;
    bool worn_ = false; ///< a visor was on at the last look
    std::string text_;
};

/// The visor that a look asks for.
VisorSettings visorOf(const LookParameters& look);

} // namespace meltpool
