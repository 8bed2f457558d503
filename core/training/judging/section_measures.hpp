// A station's figures as measures that are drawn into its section. The lengths and angles are the station's own; the
// section's map only says where in the picture they stand.
#pragma once

#include "core/scene/section_marks.hpp"
#include "core/weld/gauge/weld_stations.hpp"

#include <vector>

namespace meltpool {

/// The plates in the section, m.
struct SectionFaces {
    double upper = 0;     ///< height (y) of a level workpiece's upper face; a corner is the origin
    double thickness = 0; ///< of a butt's plates

    static SectionFaces of(const WorkpieceParameters& asked);
};

/// The measures of a station. `map` and `fusion` (K): of a section at the same place. Lengths below half a spacing are
/// told as such and not drawn; faults (what is not fused, overlap, undercut, holes) are drawn only where they are
/// longer than the particles resolve. Figures are mm and degrees. Nothing where the station has no weld and no fault.
std::vector<SectionMark> sectionMarks(const WeldStation& station, WeldKind kind, const SectionMap& map, double fusion,
                                      const SectionFaces& faces);

} // namespace meltpool
