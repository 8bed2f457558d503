// The surface's GPU layout: the vertices that the renderer reads, and what the extraction passes hand on to each other.
//
// Corners are numbered with one layer of empty ones around the grid: corner 0 and corner cells + 2 of an axis lie in
// that layer, 1 .. cells + 1 are the grid's own. The layer has no thickness: an edge into it stands for the corner it
// starts from, so that the cells of the layer make the caps on the box. A cell and an edge are named by their lowest
// corner.
//
// Corners are stored in blocks of 8 x 8 x 8, x fastest within a block and among the blocks. A row is the 8 corners of a
// block that share y and z; the bits of 4 rows share a word.
#ifndef MELTPOOL_SHARED_SURFACE_H
#define MELTPOOL_SHARED_SURFACE_H

#include "glsl_types.h"

/// Corners along the side of a block, in a block, rows of a block, words of a block's inside bits.
#define SURFACE_BLOCK 8
#define SURFACE_BLOCK_CORNERS 512
#define SURFACE_BLOCK_ROWS 64
#define SURFACE_BLOCK_WORDS 16

/// A weight of 1 in the volumes' integer sums.
#define SURFACE_UNIT 10000

/// Bits a coordinate takes in packed edges and cells.
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
// The passes over particles need fewer of the buffers above and more of their own.
#define SURFACE_BIND_SPLATTED 5
#define SURFACE_BIND_CHANGED_LIST 6
#define SURFACE_BIND_PHASES 7
#define SURFACE_BIND_PEAK 8
#define SURFACE_BIND_SPLATTED_PEAKS 9
// The pass that makes the vertices, likewise.
#define SURFACE_BIND_VERTEX_PEAKS 8
// The pass that lists the blocks, likewise.
#define SURFACE_BIND_BLOCK_STATES 1
#define SURFACE_BIND_SETTLED 2
#define SURFACE_BIND_RETIRED 10

// The same buffers as texels, for the passes that read much: drivers fetch them faster.
#define SURFACE_TEXELS_PARTICLES 0
#define SURFACE_TEXELS_SPLATTED 1
#define SURFACE_TEXELS_DENSITY 2
#define SURFACE_TEXELS_TEMPERATURE 3
#define SURFACE_TEXELS_INSIDE 4
#define SURFACE_TEXELS_ROWS 5
#define SURFACE_TEXELS_CASES 6
#define SURFACE_TEXELS_HEATS 7
#define SURFACE_TEXELS_PEAK 8

/// What the particles come with besides place and temperature.
#define SURFACE_WITH_PHASES 1
#define SURFACE_WITH_PEAKS 2

/// Coordinates of a particle that is nowhere: not yet entered into the volumes, or no metal any more.
#define SURFACE_NOWHERE 3.0e38f

/// What is known of a block between updates.
#define SURFACE_BLOCK_HELD 1u     // may hold a piece of the surface
#define SURFACE_BLOCK_ALTERED 2u  // its corners changed since the whole mesh was made: has new vertices
#define SURFACE_BLOCK_REMADE 4u   // it or a block that it takes vertices from was altered: has new triangles
#define SURFACE_LISTED_ALTERED 0x80000000u // in the block list: vertices as well as triangles are made

#ifdef __cplusplus
namespace meltpool {
#endif

/// A vertex of the surface in model units.
struct SurfaceVertex {
    vec4 position; ///< xyz place, w temperature: the mean of the particles around, weighted as in the density volume
    vec4 normal;   ///< xyz outward unit normal, w 0
};

/// What glDrawElementsIndirect reads.
struct SurfaceDraw {
    uint count; ///< indices, three a triangle
    uint instances;
    uint firstIndex;
    uint baseVertex;
    uint baseInstance;
};

/// What glDispatchComputeIndirect reads.
struct SurfaceDispatch {
    uint x;
    uint y;
    uint z;
};

/// Everything the GPU decides about the sizes of later passes; small enough to be read back whole.
struct SurfaceCommands {
    SurfaceDraw draw;
    SurfaceDispatch changed;   ///< over the particles that changed; only x is counted
    SurfaceDispatch words;     ///< over the words of the listed blocks
    SurfaceDispatch rows;      ///< over the rows of the listed blocks
    SurfaceDispatch blocks;    ///< over the listed blocks
    SurfaceDispatch vertices;  ///< over the vertices that fit
    SurfaceDispatch triangles; ///< over the triangles that fit
    uint changedCount;     ///< particles that changed
    uint splattedCount;    ///< the same, kept for the statistics when the next update counts anew
    uint blockCount;       ///< listed blocks: those made anew
    uint whole;            ///< 1: every block that holds surface is listed
    uint firstVertex;      ///< of the part that is made anew
    uint firstTriangle;    ///< likewise
    uint vertexCount;      ///< vertices of the whole surface
    uint triangleCount;    ///< triangles of the whole surface
    uint settledVertices;  ///< vertices at the last whole mesh
    uint settledTriangles; ///< likewise
    uint overflow;         ///< 1 when the mesh does not fit its buffers
};

/// The grid and the parameters of an update.
struct SurfaceSetup {
    ivec4 cells;   ///< xyz cells per axis, w influence
    ivec4 blocks;  ///< xyz blocks per axis, w their number
    vec4 origin;   ///< xyz model position of the grid's first corner, w temperature that counts as 0
    vec4 extent;   ///< xyz from the first corner to the last, signed; w temperature that counts as 1, less origin.w
    uvec4 limits;  ///< x particles, y iso level in units of 1 / SURFACE_UNIT, z most vertices, w most triangles
    ivec4 options; ///< x 1: with caps; y 1: make the whole mesh anew; z bits SURFACE_WITH_*; w 1: remember the particles
    vec4 still;   ///< a change not larger than this is none: x cells, y share of the temperature range
};

#ifdef __cplusplus
static_assert(sizeof(SurfaceVertex) == 32);
static_assert(sizeof(SurfaceDraw) == 20);
static_assert(sizeof(SurfaceCommands) == 136);
static_assert(sizeof(SurfaceSetup) == 112);
} // namespace meltpool
#endif

#endif
