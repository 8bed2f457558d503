// What the machine has left.
#pragma once

#include <cstddef>
#include <optional>

namespace meltpool {

/// Memory in bytes that programs may take without swapping (Linux: MemAvailable); nothing where that is not known.
std::optional<std::size_t> availableMemory();

} // namespace meltpool
