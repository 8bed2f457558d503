// Which sizes a workpiece has in the simulation: those that whole layers of particles make of what was asked for.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// The workpiece that is simulated where `asked` is asked for. Each face that the seam lies on, or that a measure
/// counts from, lies on a plane between two layers of particles, so that metal, gauge, limits and pictures have one and
/// the same face. For that these sizes become whole numbers of spacings, the nearest, halves upwards, at least one:
/// - `thicknessMm` of all but a cube, `lengthMm` of a cube;
/// - `heightMm` of a bridge and an outside corner;
/// - half of `widthMm` of a tee, a lap joint and an outside corner;
/// - `gapMm` of a butt joint or a pipe, which may become 0, and the width of the parts beside it. Where the gap is
/// whole
///   and both parts are half a spacing off, all stay as they are: the gap then lies half a spacing beside the middle.
/// All other faces end with the last layer whose middle they hold. A size that is whole within a thousandth of a
/// spacing keeps its value. The simulated workpiece of a simulated one is itself.
///
/// The particles keep their spacing, as that decides how long a step takes and how fine a weld is resolved; layers of
/// another height would need particles of another mass and shape than their neighbours.
WorkpieceParameters simulatedWorkpiece(const WorkpieceParameters& asked);

/// m beside the seam's middle (z) where the middle of a butt's or a pipe's gap lies, see simulatedWorkpiece().
float gapBesideMiddle(const WorkpieceParameters& simulated);

/// A size that is simulated otherwise than it was asked for, mm.
struct SimulatedSize {
    std::string_view key; ///< as files call it
    std::string_view label;
    float asked = 0, simulated = 0;
};

/// Those of this workpiece, in the order of describe(); empty where it is simulated as it was asked for.
std::vector<SimulatedSize> simulatedSizes(const WorkpieceParameters& asked);

/// The same in words for a person, with a spacing that would keep the thickness; empty where nothing differs.
std::string simulatedSizesText(const WorkpieceParameters& asked);

} // namespace meltpool
