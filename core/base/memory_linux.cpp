#include "core/base/memory.hpp"

#include <fstream>
#include <limits>
#include <string>

namespace meltpool {

std::optional<std::size_t> availableMemory() {
    std::ifstream file("/proc/meminfo");
    std::string name;
    std::size_t kibibytes = 0;
    while (file >> name >> kibibytes) {
        if (name == "MemAvailable:") return kibibytes * 1024;
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::nullopt;
}

} // namespace meltpool
