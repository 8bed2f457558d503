// The macro-section of a weld: what a cut, ground and etched across the seam would show, measured from the particles.
#pragma once

#include "core/metal/state/metal_state.hpp"

namespace meltpool {

/// Where to cut: slices across the x axis from `from` to `to` (m), plate with its top at y = `surface` before welding.
struct SectionCut {
    double from = 0, to = 0;
    double surface = 0;
    double thickness = 0;         ///< of the plate, m
    double fusion = 0;            ///< K: what was hotter has been molten
    double heatAffected = 996.15; ///< K: what was hotter has changed (steel: Ac1, 723 degrees C)
};

/// Mean over the slices of the cut; lengths in m, areas in m².
struct Section {
    double width = 0;       ///< of the fusion zone at the plate's surface
    double penetration = 0; ///< of the fusion zone below it
    double height = 0;      ///< of the bead above it
    double deposited = 0;   ///< area of metal in the section beyond what the plate had
    double fused = 0;       ///< area of plate that was molten
    double heatAffectedWidth = 0;
    double heatAffectedDepth = 0;
};

/// Measures a section. `plate`: the plate as it was, for its cells; it must lie on the state's lattice. Waits for the
/// GPU. Fronts are found where the highest temperature crosses a level, linear between cells; where the far cell has
/// left the lattice, from the slope before it.
Section measureSection(const MetalState& state, const SectionCut& cut);

} // namespace meltpool
