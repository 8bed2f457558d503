// What a test program holds of the machine's memory.
#pragma once

#include <cstddef>
#include <fstream>

#include <unistd.h>

namespace meltpool::test {

/// Bytes of memory that this program has in use; 0 where the system does not tell.
inline std::size_t residentBytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    return statm >> all >> resident ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

} // namespace meltpool::test
