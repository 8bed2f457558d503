// Partial statistics of the physical metal's particles, shared with C++.
#ifndef MELTPOOL_SHARED_METAL_STATISTICS_H
#define MELTPOOL_SHARED_METAL_STATISTICS_H

#include "metal.h"

#define METAL_STATISTICS_PARTS 1024  // each over every 1024th slot; whole groups of GROUP_SIZE
#define METAL_STATISTICS 6           // storage buffer of MetalPart
#define METAL_STATISTICS_POSITIONS 0 // read as texels
#define METAL_STATISTICS_PHASES 1

#ifdef __cplusplus
namespace meltpool {
#endif

struct MetalPart {
    float sum;   // sum of the temperatures, K
    float least; // K
    float most;  // K
    uint alive;
    uint molten;
    uint outside;
    uint broken; // position or temperature is no number
    uint reserved;
};

#ifdef __cplusplus
static_assert(sizeof(MetalPart) == 32);
} // namespace meltpool
#endif

#endif
