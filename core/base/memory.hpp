// Free memory of the machine.
#pragma once

#include <cstddef>
#include <optional>

namespace meltpool {

/// Bytes of memory available without swapping (Linux: MemAvailable; Windows: free physical memory); nothing if the
/// system does not report it.
std::optional<std::size_t> availableMemory();

} // namespace meltpool
