// The picture of a cut across the seam: where metal is, how hot it has been and how hot it is.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace meltpool {

/// A grid of values over the whole height and width of the metal's lattice. Its axes are the workpiece's z (columns)
/// and y (rows).
struct SectionMap {
    glm::vec2 low{0};     ///< its corner, m: z, y
    glm::vec2 size{0};    ///< m
    glm::ivec2 texels{0}; ///< columns and rows; 0: nothing was cut
    float spacing = 0;    ///< of the metal's lattice, m
    /// One value a texel, row by row from `low`: weight of the metal there (1 in the inside of solid metal, below half
    /// of that there is none), weight times highest temperature so far, weight times present temperature (K), and 1
    /// where a picture shows metal although the weight is low: in the square corners of plates, which weights round.
    std::vector<glm::vec4> sums;
};

/// A particle near the cut.
struct MapParticle {
    glm::vec2 place{0};     ///< m: z, y
    float peak = 0;         ///< K
    float temperature = 0;  ///< K
    bool onLattice = false; ///< it stands on the lattice that the metal began on
};

/// Spreads the particles of `slices` lattice layers over a map from `low` on: each weighs (1 - r²)² at r reaches of 1.5
/// spacings from it. Eight texels a spacing, fewer where the map would be wider than 1024.
SectionMap makeSectionMap(glm::vec2 low, glm::vec2 size, float spacing, int slices,
                          const std::vector<MapParticle>& particles);

} // namespace meltpool
