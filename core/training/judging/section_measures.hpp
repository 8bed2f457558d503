// Draws a station's figures as measures into its section. The lengths and angles are the station's own; the section's
// map only gives their places in the picture.
#pragma once

#include "core/scene/section_marks.hpp"
#include "core/weld/gauge/weld_stations.hpp"

#include <vector>

namespace meltpool {

/// The plates in the section, m.
struct SectionFaces {
    double upper = 0;     ///< height (y) of a level workpiece's upper face; a corner is the origin
    double thickness = 0; ///< thickness of a butt's plates

    static SectionFaces of(const WorkpieceParameters& asked);
};

/// The measures of a station. `map` and `fusion` (K): of a section at the station's place. Lengths below half a spacing
/// get a label and are not drawn; faults (lack of fusion, overlap, undercut, holes) are drawn only if they are longer
/// than the particles resolve. Figures are mm and degrees. Empty if the station has no weld and no fault.
std::vector<SectionMark> sectionMarks(const WeldStation& station, WeldKind kind, const SectionMap& map, double fusion,
                                      const SectionFaces& faces);

} // namespace meltpool
