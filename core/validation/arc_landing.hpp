// Landing of an arc's heat on a joint, and warmth of the plates before the liquid's edge. The landing is a twin on the
// CPU of the pass that divides a source's power among the cells.
#pragma once

#include "core/metal/heat/heat_source.hpp"
#include "core/metal/state/metal_state.hpp"
#include "core/weld/gauge/weld_particles.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// Shares of a Gaussian source's power, each 0 to 1.
struct ArcLanding {
    double caught = 0;   ///< of the power: the part that metal catches; the shares below are of this part
    double solid = 0;    ///< on metal below the solidus
    double ahead = 0;    ///< of that, before the foremost liquid along the seam
    double lying = 0;    ///< on solid metal of the base plate, ahead or not
    double standing = 0; ///< on solid metal of the upright plate, or of the upper plate of a lap
};

/// Finds the landing of `source`, a Gaussian that travels along x, on these particles. `butt`: the plates are parted at
/// z = 0, and the one at z > 0 counts as standing; else metal over y = 0 behind z = 0 does. `solidus` in K.
ArcLanding arcLanding(const MetalLattice& lattice, const ParticleValues& metal, const HeatSource& source,
                      double solidus, bool butt);

/// Temperatures of the plates' faces before the edge of the liquid on them.
struct LineWarmth {
    std::optional<double> lying, standing; ///< K; none without liquid on that face
};

/// Finds the temperature on the faces of a corner (y = 0 for z > 0 and z = 0 for y > 0) `before` (m) beyond the
/// outermost liquid that lies on them, as the mean over the lattice layers from `low` to `high` (m along the seam).
LineWarmth lineWarmth(const MetalLattice& lattice, const ParticleValues& metal, double low, double high, double before);

} // namespace meltpool
