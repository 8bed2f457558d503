// The picture of a cut across the seam: the places of metal, its highest temperature so far and its present
// temperature.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace meltpool {

/// A grid of values over the whole height and width of the metal's lattice. Its axes are the workpiece's z (columns)
/// and y (rows).
struct SectionMap {
    glm::vec2 low{0};     ///< lower corner of the grid, m: z, y
    glm::vec2 size{0};    ///< m
    glm::ivec2 texels{0}; ///< columns and rows; 0: there was no cut
    float spacing = 0;    ///< spacing of the metal's lattice, m
    /// One value a texel, row by row from `low`: weight of the metal there (1 inside solid metal, below half of that
    /// there is none), weight times highest temperature so far, weight times present temperature (K), and 1 for texels
    /// that a picture shows as metal although the weight is low: in the square corners of plates, which weights round.
    std::vector<glm::vec4> sums;
};

/// A particle near the cut.
struct MapParticle {
    glm::vec2 place{0};     ///< m: z, y
    float peak = 0;         ///< K
    float temperature = 0;  ///< K
    bool onLattice = false; ///< true for a particle on its first place in the lattice
};

/// Spreads the particles of `slices` lattice layers over a map from `low` on: each weighs (1 - r²)² at r reaches of 1.5
/// spacings from it. Eight texels a spacing, fewer if the map would be wider than 1024.
SectionMap makeSectionMap(glm::vec2 low, glm::vec2 size, float spacing, int slices,
                          const std::vector<MapParticle>& particles);

} // namespace meltpool
