// Definitions of the classic model that C++ and GLSL share: uniform block of a step, bindings, group sizes, partial
// statistics.
#ifndef MELTPOOL_SHARED_CLASSIC_H
#define MELTPOOL_SHARED_CLASSIC_H

#include "glsl_types.h"

/// Invocations of a group of the prefix sum, and the number of cells whose counts it sums.
#define CLASSIC_SCAN_GROUP 64
#define CLASSIC_SCAN_CELLS 4096
/// Particles whose statistics one group sums.
#define CLASSIC_STATISTICS_CHUNK 2048

// Uniform block.
#define CLASSIC_STEP 0
// Storage blocks. "Moved": the state after a step; "sorted": that state in the order of the grid cells, which the next
// step reads. A position is a vec4 with the temperature behind it, a sorted velocity one with 1 / density.
#define CLASSIC_MOVED_POSITIONS 0
#define CLASSIC_MOVED_VELOCITIES 1
#define CLASSIC_MOVED_NUMBERS 2
#define CLASSIC_SORTED_POSITIONS 3
#define CLASSIC_SORTED_VELOCITIES 4
#define CLASSIC_SORTED_NUMBERS 5
#define CLASSIC_CELL_SLOTS 6
#define CLASSIC_CELL_COUNTS 7
#define CLASSIC_CELL_STARTS 8
#define CLASSIC_CHUNK_SUMS 9
#define CLASSIC_CELL_NUMBERS 10
#define CLASSIC_REFUSED 11
#define CLASSIC_STATISTICS 12
// Texture units of the buffer textures: the sorted state, starts and counts of the cells.
#define CLASSIC_POSITION_TEXELS 0
#define CLASSIC_VELOCITY_TEXELS 1
#define CLASSIC_START_TEXELS 2
#define CLASSIC_COUNT_TEXELS 3

#ifdef __cplusplus
namespace meltpool {
#endif

/// Uniform block of one step; box units, seconds, temperature 0 .. 1.
struct ClassicStep {
    vec3 gravity;
    float heat;              // temperature a step at the source's centre; negative for a cold source, 0 when off
    vec3 source;             // centre of the heat or cold source
    float heatRadiusSquared; // square of the source's reach
    float solidifyRate;      // temperature lost a step
    float restDensity;
    float gasStiffness;
    float supportRadius;     // h
    float poly6;             // mass 315 / (64 pi h^9)
    float spiky;             // mass 45 / (pi h^6)
    float viscosity;         // mu mass 45 / (pi h^6)
    float timeStep;
    float wallRestitution;
    float accelerationLimit;
    float cellsPerUnit;      // 1 / edge of a cell
    uint particles;
    uint cellsPerAxis;
    uint wallSlip; // 1: a wall reverses only the velocity component across it
    uint reserved;
    uint reserved2;
};

/// Statistics of one chunk of particles.
struct ClassicChunk {
    float temperatureSum;
    float minTemperature;
    float maxTemperature;
    uint molten;
    uint outside;
};

#ifdef __cplusplus
} // namespace meltpool
static_assert(sizeof(meltpool::ClassicStep) == 96, "std140 layout");
static_assert(sizeof(meltpool::ClassicChunk) == 20, "std430 layout");
#endif

#endif
