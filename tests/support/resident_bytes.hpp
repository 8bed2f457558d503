// Measures a test program's share of the machine's memory.
#pragma once

#include <cstddef>
#include <fstream>

#ifdef __linux__
#include <unistd.h>
#endif

namespace meltpool::test {

/// Returns the bytes of memory that this program has in use. Returns 0 if the system does not report them, and under
/// the address sanitizer, which retains freed memory.
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
