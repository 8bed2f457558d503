// Workpieces to weld on: plates, joints and test pieces, as solid particles on a lattice with their clamps.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/state/metal_state.hpp"

#include <glm/mat3x3.hpp>

#include <optional>
#include <span>

namespace meltpool {

enum class WorkpieceKind { Plate, Cube, Bridge, Tee, Lap, Butt, Corner, Pipe };

/// The workpiece's frame: x along the seam, y out of the plate, z towards the welder; its origin is on the seam. Plate:
/// middle of the upper face. Cube: its centre. Bridge: middle of the bar's upper face. Tee: corner between the upright
/// plate, at the rear, and the base plate. Lap: corner between the upper plate's edge and the lower plate's face. Butt:
/// middle of the gap, at the upper faces. Corner (an outside corner): the line of contact between the inner edges of
/// the base plate, at the rear, and of the upright one, below; the groove between their edge faces looks up and towards
/// the welder. Pipe: top of its outer face in the middle of the gap; its axis is z.
struct WorkpieceParameters {
    std::string metal = "s235"; ///< a shipped material, or a file that ends in .toml (of a lesson: next to its file)
    int kind = 0;               ///< WorkpieceKind
    int position = 0;           ///< WeldPosition
    float lengthMm = 100;       ///< length along the seam; of a cube its edge
    float widthMm = 50;         ///< width across the seam; of a pipe its length
    float thicknessMm = 6;      ///< thickness of each plate, and of a pipe's wall
    float heightMm = 25;        ///< height of the upright plate of a tee or an outside corner
    float gapMm = 1.5F;         ///< gap of a butt joint or of a pipe; a pipe without gap and bevel is one piece
    float rootFaceMm = 0;       ///< root face of a bevelled edge: height at its lower (inner) side that is not bevelled
    float bevelDeg = 0;         ///< bevel of each edge of a butt joint or a pipe, from the upright
    float diameterMm = 60;      ///< outer diameter of a pipe
    int tackCount = 0;          ///< number of tacks, spread evenly from end to end of the seam
    float tackLengthMm = 8;     ///< length of each tack
    float spacingMm = 1;        ///< spacing of the particles
    float roomAboveMm = 14;     ///< space over the workpiece for filler and drops
    float roomBelowMm = 6;      ///< height of the supports over the table
    float temperatureC = 20;
};

ParameterList describe(WorkpieceParameters& parameters);

/// A block of metal along the axes, m.
struct WorkpieceBlock {
    glm::vec3 low{0};
    glm::vec3 high{0};
};

/// A pipe along z, m.
struct WorkpiecePipe {
    glm::vec2 axis{0}; ///< x and y
    float low = 0, high = 0;
    float outer = 0, inner = 0; ///< radii
};

struct Workpiece {
    MetalLattice lattice;
    std::vector<MetalSeed> seeds; ///< seeds of the parts, then of the tacks
    size_t tackSeeds = 0;         ///< number of tack seeds
    glm::vec3 low{0};             ///< m, low corner of the space that metal may be in
    glm::vec3 high{0};            ///< m
    glm::vec3 bodyLow{0};         ///< m, box around the workpiece itself, whose faces are those of the cells
    glm::vec3 bodyHigh{0};        ///< m
    glm::mat3 turn{1};            ///< Fixture::turn
    glm::vec3 up{0, 1, 0};        ///< unit vector against gravity, in the workpiece's frame
    float floorHeight = 0;        ///< m along `up`, height of the table: the lowest place of the space
    /// Boxes full of its metal, which block an arc's light: all of it but bevels and pipes. Their faces are those of
    /// the particles' cells.
    std::vector<WorkpieceBlock> blocks;
    std::optional<WorkpiecePipe> pipe;

    /// Returns the seeds of the joined parts: the workpiece before anything was deposited on it.
    std::span<const MetalSeed> parts() const { return std::span(seeds).first(seeds.size() - tackSeeds); }
};

/// A combination of sizes that no workpiece can have.
struct WorkpieceFault {
    std::string_view key; ///< the parameter to change
    std::string sentence; ///< the fault and the expected size
};

/// Returns the material of a workpiece. Throws InputError for one that is missing or incomplete.
Material workpieceMaterial(const WorkpieceParameters& parameters);

/// Returns nothing for a workpiece that can exist.
std::optional<WorkpieceFault> workpieceFault(const WorkpieceParameters& parameters);

/// Makes the simulatedWorkpiece() of these sizes, see there. Throws InputError for a workpieceFault() and when the
/// workpiece has no particle, or more than kMostWorkpieceParticles.
Workpiece makeWorkpiece(const WorkpieceParameters& parameters);

inline constexpr size_t kMostWorkpieceParticles = 2'000'000;

} // namespace meltpool
