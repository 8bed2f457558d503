#include "core/base/environment.hpp"

#include <cstdlib>

namespace meltpool {

std::string environmentVariable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

void setEnvironmentDefault(const char* name, const char* value) {
    setenv(name, value, 0);
}

} // namespace meltpool
