// The edge of the metal in a section, as a closed line.
#pragma once

#include "core/weld/gauge/section_map.hpp"

#include <span>

namespace meltpool {

/// A closed line, m (z, y), with the metal on its left: each place once, the last joined to the first.
using WeldOutline = std::vector<glm::dvec2>;

/// Returns the outer edge of the largest connected piece of metal in the map: the places with half the weight of solid
/// metal, linear between the texels' centres. Drops, spatter and pores have edges of their own and are left out. Empty
/// for a map without metal.
///
/// A straight edge is at the end of the particles' cells. A convex edge of radius R is 0.14 spacing² / R inside, and a
/// corner is rounded over one and a half spacings.
WeldOutline weldOutline(const SectionMap& map);

/// Returns the area inside a closed line, m²; negative if its inside is on its right.
double areaInside(std::span<const glm::dvec2> line);

} // namespace meltpool
