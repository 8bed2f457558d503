#include "app/platform/memory.hpp"

#include <cstdlib> // defines the macros that name the C library

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace meltpool {

void giveLargeBlocksBack() {
#ifdef __GLIBC__
    constexpr int kLarge = 256 << 10, kKeptAtTop = 1 << 20; // bytes; setting either ends the library's own adaptation
    mallopt(M_MMAP_THRESHOLD, kLarge);
    mallopt(M_TRIM_THRESHOLD, kKeptAtTop);
#endif
}

} // namespace meltpool
