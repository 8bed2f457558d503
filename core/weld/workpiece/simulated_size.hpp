// Sizes of a workpiece in the simulation: whole layers of particles nearest to the sizes asked for.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Returns the workpiece that is simulated for `asked`. Each face that the seam is on, or that a measure counts from,
/// is a plane between two layers of particles, so that metal, gauge, limits and pictures share one face. For that these
/// sizes become whole numbers of spacings, the nearest, halves upwards, at least one:
/// - `thicknessMm` of all but a cube, `lengthMm` of a cube;
/// - `heightMm` of a bridge and an outside corner;
/// - half of `widthMm` of a tee, a lap joint and an outside corner;
/// - `gapMm` of a butt joint or a pipe, which may become 0, and the width of the parts beside it. If the gap is whole
///   and both parts are half a spacing off, all stay unchanged: the gap is then half a spacing beside the middle.
/// All other faces end with the last layer whose middle they hold. A size that is whole within a thousandth of a
/// spacing keeps its value. The simulated workpiece of a simulated one is itself.
///
/// The particles keep their spacing, as that decides the duration of a step and the resolution of a weld; layers of
/// another height would need particles of another mass and shape than their neighbours.
WorkpieceParameters simulatedWorkpiece(const WorkpieceParameters& asked);

/// Returns the distance (m) of the middle of a butt's or a pipe's gap from the seam's middle (z), see
/// simulatedWorkpiece().
float gapBesideMiddle(const WorkpieceParameters& simulated);

/// A size whose simulated value differs from the one asked for, mm.
struct SimulatedSize {
    std::string_view key; ///< key in files
    std::string_view label;
    float asked = 0, simulated = 0;
};

/// Returns the differing sizes of this workpiece, in the order of describe(); empty if there are none.
std::vector<SimulatedSize> simulatedSizes(const WorkpieceParameters& asked);

/// Returns the differing sizes in words for a person, with a spacing that would keep the thickness; empty if there are
/// none.
std::string simulatedSizesText(const WorkpieceParameters& asked);

} // namespace meltpool
