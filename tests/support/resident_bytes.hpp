// What a test program holds of the machine's memory.
#pragma once

#include <cstddef>
#include <fstream>

#ifdef __linux__
#include <unistd.h>
#endif

namespace meltpool::test {

/// Bytes of memory that this program has in use; 0 where the system does not tell, and under the address sanitizer,
/// which keeps what was given back.
inline std::size_t residentBytes() {
#if defined(__SANITIZE_ADDRESS__) || !defined(__linux__)
    return 0;
#else
    std::ifstream statm("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    return statm >> all >> resident ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
#endif
}

} // namespace meltpool::test
