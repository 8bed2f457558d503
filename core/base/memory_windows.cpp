#include "core/base/memory.hpp"

#include <windows.h>

namespace meltpool {

std::optional<std::size_t> availableMemory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    if (GlobalMemoryStatusEx(&status) == FALSE) return std::nullopt;
    return static_cast<std::size_t>(status.ullAvailPhys);
}

} // namespace meltpool
