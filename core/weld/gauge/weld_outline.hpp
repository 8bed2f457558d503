// The edge of the metal in a section, as a closed line.
#pragma once

#include "core/weld/gauge/section_map.hpp"

#include <span>

namespace meltpool {

/// A closed line, m (z, y), with the metal on its left: each place once, the last joined to the first.
using WeldOutline = std::vector<glm::dvec2>;

/// The outer edge of the largest connected piece of metal in the map: where the weight is half of that of solid metal,
/// linear between the texels' centres. Drops, spatter and pores have edges of their own and are left out. Empty where
/// there is no metal.
///
/// A straight edge lies where the particles' cells end. A convex edge of radius R lies 0.14 spacing² / R inside, and a
/// corner is rounded over one and a half spacings.
WeldOutline weldOutline(const SectionMap& map);

/// Area inside a closed line, m²; negative where its inside is on its right.
double areaInside(std::span<const glm::dvec2> line);

} // namespace meltpool
