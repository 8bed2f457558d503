// Constants and structs that the passes which search metal along an axis share with C++.
#ifndef MELTPOOL_SHARED_AXIS_PROBE_H
#define MELTPOOL_SHARED_AXIS_PROBE_H

#include "glsl_types.h"

#define AXIS_PROBE_GROUP 64
#define AXIS_PROBE_BINS 256       // lengths of the ray in which metal is counted
#define AXIS_PROBE_UNIT 65536.0   // unit of the integer sums, whose order does not matter
#define AXIS_PROBE_RADIUS 2.0     // spacings from the axis within which metal counts
#define AXIS_PROBE_EDGE_DEPTH 3.0 // spacings of depth that make metal beside the axis an edge for the arc
#define AXIS_PROBE_EDGE_SHARE 0.12    // share of the count inside metal; 0.17 in the middle of a gap two spacings wide
#define AXIS_PROBE_DROP_SPEED 0.2     // m/s along the axis from which liquid is a drop in flight and no surface
#define AXIS_PROBE_LATTICE_GROUPS 128 // most groups that search the lattice; the others take the list of slots

#define AXIS_PROBE_BLOCK 1 // uniform buffer

// Storage buffers behind those of the metal itself.
#define AXIS_PROBE_SUMS 6    // AxisProbeBin a bin
#define AXIS_PROBE_ANSWER 7  // AxisProbeAnswer
#define AXIS_PROBE_SLOTS 8   // list of slots off the lattice
#define AXIS_PROBE_CONTROL 9 // uint: any buffer with their number, see AxisProbeBlock.countWord

#ifdef __cplusplus
namespace meltpool {
#endif

struct AxisProbeBlock {
    vec3 origin;     // m
    float binLength; // m
    vec3 axis;       // unit vector
    float full;      // sum of a bin that is wholly inside metal at rest density
    ivec3 low;       // first lattice cell of the box around the ray
    uint firstSlot;  // index of the first slot in the list
    ivec3 cells;     // size of that box
    uint countWord;  // index of the list's length in its control buffer
    int edgeBins;    // bins in AXIS_PROBE_EDGE_DEPTH spacings
    int latticeGroups; // groups that search the box
    int reserved2;     // no array: std140 would give each element 16 bytes
    int reserved3;
};

struct AxisProbeBin {
    int weight; // weight of metal, in 1/AXIS_PROBE_UNIT
    int liquid; // weight times fraction of liquid
};

struct AxisProbeAnswer {
    float distance; // m, from the origin to the surface; negative: none
    float liquid;   // 0..1, share of liquid there
    float reserved[2];
};

#ifdef __cplusplus
static_assert(sizeof(AxisProbeBlock) == 80);
static_assert(sizeof(AxisProbeAnswer) == 16);
} // namespace meltpool
#endif

#endif
