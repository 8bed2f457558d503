// Structs, bindings and group sizes of the surface extraction, shared by C++ and GLSL.
//
// The grid has one layer of empty corners around it: along each axis corners 0 and cells + 2 belong to that layer,
// corners 1 .. cells + 1 to the grid. The layer has no thickness: an edge from a grid corner into the layer has zero
// length, so that the cells of the layer form the caps on the box. A cell or an edge has the number of its lowest corner.
//
// Corners are stored in blocks of 8 x 8 x 8, x fastest within a block and among the blocks. A row is the 8 corners of a
// block that share y and z; the inside bits of 4 rows share a word.
#ifndef MELTPOOL_SHARED_SURFACE_H
#define MELTPOOL_SHARED_SURFACE_H

#include "glsl_types.h"

/// Corners along the side of a block, corners in a block, rows in a block, words of inside bits in a block.
#define SURFACE_BLOCK 8
#define SURFACE_BLOCK_CORNERS 512
#define SURFACE_BLOCK_ROWS 64
#define SURFACE_BLOCK_WORDS 16

/// The integer for a weight of 1 in the volumes' sums.
#define SURFACE_UNIT 10000

/// A corner of the freezing volume: x the sum of weights of metal that froze, and times SURFACE_LOOSE that of all metal
/// that ever melted; y the sum of weight x time of the frozen metal. Weights in units of 1 / SurfaceSetup.freezingUnit,
/// time in ticks. A corner holds weights of 4095 units up to the longest time.
#define SURFACE_LOOSE 65536u
#define SURFACE_FREEZING_TICKS 512.0    // ticks a second: much finer than the freezing of a cell's width
#define SURFACE_FREEZING_LONGEST 2048.0 // s: metal that froze later has no time

/// Bits of one coordinate in packed edges and cells.
#define SURFACE_COORDINATE_BITS 10

/// Invocations of a work group of the passes over particles, rows, vertices and triangles, and of the scans.
#define SURFACE_GROUP 64
#define SURFACE_SCAN_GROUP 256

#define SURFACE_BIND_SETUP 0 // uniform block
#define SURFACE_BIND_DENSITY 1
#define SURFACE_BIND_TEMPERATURE 2
#define SURFACE_BIND_BLOCK_FLAGS 3
#define SURFACE_BIND_BLOCK_LIST 4
#define SURFACE_BIND_BLOCK_SUMS 5
#define SURFACE_BIND_INSIDE 6
#define SURFACE_BIND_ROWS 7
#define SURFACE_BIND_ROW_SUMS 8
#define SURFACE_BIND_EDGE_LIST 10
#define SURFACE_BIND_TRIANGLE_LIST 11
#define SURFACE_BIND_VERTICES 12
#define SURFACE_BIND_INDICES 13
#define SURFACE_BIND_COMMANDS 14
// Bindings of the passes over particles, which use these numbers for buffers of their own.
#define SURFACE_BIND_SPLATTED 5
#define SURFACE_BIND_CHANGED_LIST 6
#define SURFACE_BIND_PHASES 7
#define SURFACE_BIND_PEAK 8
#define SURFACE_BIND_SPLATTED_PEAKS 9
#define SURFACE_BIND_FREEZING 10
#define SURFACE_BIND_SPLATTED_FREEZING 11
// Bindings of the pass that makes the vertices.
#define SURFACE_BIND_VERTEX_PEAKS 8
#define SURFACE_BIND_VERTEX_FREEZING 9
// Bindings of the passes that list and place the blocks.
#define SURFACE_BIND_BLOCK_STATES 1
#define SURFACE_BIND_BASE_TRIANGLES 2
#define SURFACE_BIND_OBSOLETE_TRIANGLES 10

// Buffer textures over the same buffers, for passes that read much. SYNCHRONOUS_DRIVER: it fetches texels faster than
// storage.
#define SURFACE_TEXELS_PARTICLES 0
#define SURFACE_TEXELS_SPLATTED 1
#define SURFACE_TEXELS_DENSITY 2
#define SURFACE_TEXELS_TEMPERATURE 3
#define SURFACE_TEXELS_INSIDE 4
#define SURFACE_TEXELS_ROWS 5
#define SURFACE_TEXELS_CASES 6
#define SURFACE_TEXELS_HEATS 7
#define SURFACE_TEXELS_PEAK 8
#define SURFACE_TEXELS_FROZEN_AT 9
#define SURFACE_TEXELS_FREEZING 10
#define SURFACE_TEXELS_LATTICE 11
#define SURFACE_TEXELS_NUMBERS 12

/// Data of particles besides position and temperature.
#define SURFACE_WITH_PHASES 1
#define SURFACE_WITH_PEAKS 2
#define SURFACE_WITH_FREEZING 4
#define SURFACE_WITH_NUMBERS 8

/// Most planes of flat faces along each axis.
#define SURFACE_FLAT_PLANES 6

/// Coordinates of a particle that adds nothing to the volumes: not splatted yet, or no longer metal.
#define SURFACE_NOWHERE 3.0e38f

/// State of a block between updates.
#define SURFACE_BLOCK_OCCUPIED 1u // a part of the surface may pass through it
#define SURFACE_BLOCK_CHANGED 2u  // its corners changed since the last rebuild: its vertices are made again
#define SURFACE_BLOCK_REMESHED 4u // it, or a block whose vertices it uses, changed: its triangles are made again
#define SURFACE_LISTED_WITH_VERTICES 0x80000000u // in the block list: vertices as well as triangles are made

#ifdef __cplusplus
namespace meltpool {
#endif

/// A vertex of the surface in model units.
struct SurfaceVertex {
    vec3 position;
    float temperature; ///< mean of the particles around, with the weights of the density volume
    vec3 normal;       ///< outward unit normal
    float frozen;      ///< share of the metal around that was molten and froze, 0..1; 0 if it was not requested
};

/// The time of freezing of the metal around a vertex.
struct SurfaceFreezing {
    vec3 slope; ///< gradient of the time, s per model unit
    float time; ///< s; mean of the particles around that froze, 0 for none
};

/// The arguments of glDrawElementsIndirect.
struct SurfaceDraw {
    uint count; ///< indices, three a triangle
    uint instances;
    uint firstIndex;
    uint baseVertex;
    uint baseInstance;
};

/// The arguments of glDispatchComputeIndirect.
struct SurfaceDispatch {
    uint x;
    uint y;
    uint z;
};

/// The sizes of later passes, all decided by the GPU; small enough to be read back whole.
///
/// The mesh consists of a base part, made at the last rebuild, and behind it the part that every incremental update
/// makes again.
struct SurfaceCommands {
    SurfaceDraw draw;
    SurfaceDispatch changed;   ///< groups over the particles that changed; only x is counted
    SurfaceDispatch words;     ///< groups over the words of the listed blocks
    SurfaceDispatch rows;      ///< groups over the rows of the listed blocks
    SurfaceDispatch blocks;    ///< groups over the listed blocks
    SurfaceDispatch vertices;  ///< groups over the vertices that fit
    SurfaceDispatch triangles; ///< groups over the triangles that fit
    uint changedCount;         ///< particles that changed
    uint splattedCount;        ///< particles splatted by this update, for the statistics: changedCount is reset
    uint blockCount;           ///< listed blocks: those whose mesh is made by this update
    uint rebuilt;              ///< 1: every occupied block is listed and the whole mesh becomes the base part
    uint firstVertex;          ///< first of the part that this update makes
    uint firstTriangle;        ///< first of the part that this update makes
    uint vertexCount;          ///< vertices of the whole surface
    uint triangleCount;        ///< triangles of the whole surface
    uint baseVertices;         ///< vertices of the base part
    uint baseTriangles;        ///< triangles of the base part
    uint overflow;             ///< 1 when the mesh does not fit its buffers
};

/// The grid and the parameters of an update.
struct SurfaceSetup {
    ivec3 cells;                ///< cells per axis
    int influence;              ///< a particle reaches (2 influence - 1)^3 corners
    ivec3 blocks;               ///< blocks per axis
    int blockCount;             ///< blocks in all
    vec3 origin;                ///< model position of the grid's first corner
    float coldest;              ///< temperature stored as 0
    vec3 extent;                ///< vector from the first corner to the last, signed, model units
    float temperatureRange;     ///< temperature stored as 1, less the coldest
    uint particleCount;         ///< particles of this update
    uint isoLevel;              ///< weight at the surface, in 1 / SURFACE_UNIT
    uint maxVertices;           ///< vertices that the buffers hold
    uint maxTriangles;          ///< triangles that the buffers hold
    int caps;                   ///< 1: the surface is closed where the metal touches the box
    int rebuild;                ///< 1: start from empty volumes and make the whole mesh
    int particleData;           ///< bits SURFACE_WITH_*
    int incremental;            ///< 1: store each particle as splatted, for the next update
    float positionTolerance;    ///< movement up to which a particle counts as unchanged, cells
    float temperatureTolerance; ///< this tolerance for its temperature, as a share of the temperature range
    float freezingUnit;         ///< integer for a weight of 1 in the freezing volume
    int flatPlaneCount;         ///< corners in flatPlanes
    vec3 latticeOrigin;         ///< low corner of the lattice that the metal began on, model units
    float perLatticeSpacing;    ///< lattice cells in a model unit
    ivec3 latticeTiles;         ///< 0: no lattice, or not requested
    float flatBelow;            ///< highest temperature so far up to which metal of the lattice counts as unmoved
    vec4 flatPlanes[SURFACE_FLAT_PLANES]; ///< xyz: planes of flat faces along each axis, cells from its low corner
    vec2 pipeAxis;                        ///< place of the axis of a pipe along z, model units
    float pipeLow;                        ///< ends of the pipe
    float pipeHigh;
    float pipeOuter; ///< radii of the pipe
    float pipeInner;
    int pipeCount; ///< 0 or 1
    float unused0;
};

#ifdef __cplusplus
static_assert(sizeof(SurfaceVertex) == 32);
static_assert(sizeof(SurfaceFreezing) == 16);
static_assert(sizeof(SurfaceDraw) == 20);
static_assert(sizeof(SurfaceCommands) == 136);
static_assert(sizeof(SurfaceSetup) == 176 + 16 * SURFACE_FLAT_PLANES);
} // namespace meltpool
#endif

#endif
