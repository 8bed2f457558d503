// What is welded on: plates, joints and test pieces, as solid particles on a lattice with their clamps.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/state/metal_state.hpp"

namespace meltpool {

enum class WorkpieceKind { Plate, Cube, Bridge, Tee, Lap, Butt };

/// The workpiece's frame: x along the seam, y out of the plate, z towards the welder; its origin lies on the seam.
/// Plate: middle of the upper face. Cube: its centre. Bridge: middle of the bar's upper face. Tee: corner between the
/// standing plate, which lies behind, and the lying one. Lap: corner between the upper plate's edge and the lower
/// plate's face. Butt: middle of the gap, at the upper faces.
struct WorkpieceParameters {
    std::string metal = "s235"; ///< a shipped material, or a file that ends in .toml (of a lesson: beside its file)
    int kind = 0;               ///< WorkpieceKind
    float lengthMm = 100;       ///< along the seam; of a cube its edge
    float widthMm = 50;         ///< across
    float thicknessMm = 6;      ///< of each plate
    float heightMm = 25;        ///< of a tee's standing plate
    float gapMm = 1.5F;         ///< of a butt joint
    float spacingMm = 1;        ///< of the particles
    float roomAboveMm = 14;     ///< space over the workpiece that filler and drops may be in
    float roomBelowMm = 6;      ///< height of the supports over the table
    float temperatureC = 20;
};

ParameterList describe(WorkpieceParameters& parameters);

/// A block of metal along the axes, m.
struct WorkpieceBlock {
    glm::vec3 low{0};
    glm::vec3 high{0};
};

struct Workpiece {
    MetalLattice lattice;
    std::vector<MetalSeed> seeds;
    glm::vec3 low{0};                   ///< m, the space that metal may be in
    glm::vec3 high{0};                  ///< m
    glm::vec3 bodyLow{0};               ///< m, box around the workpiece itself
    glm::vec3 bodyHigh{0};              ///< m
    float floorHeight = 0;              ///< m, of the table
    std::vector<WorkpieceBlock> blocks; ///< that it is made of
};

/// The material a workpiece is made of. Throws InputError for one that is not there or not whole.
Material workpieceMaterial(const WorkpieceParameters& parameters);

/// Throws InputError when the workpiece has no particle, or more than kMostWorkpieceParticles.
Workpiece makeWorkpiece(const WorkpieceParameters& parameters);

inline constexpr size_t kMostWorkpieceParticles = 2'000'000;

} // namespace meltpool
