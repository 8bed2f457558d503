#include "core/base/environment.hpp"

#include "core/base/wide_text.hpp"

#include <cstdlib>

namespace meltpool {

std::string environmentVariable(const char* name) {
    const wchar_t* value = _wgetenv(toWide(name).c_str());
    return value == nullptr ? std::string() : fromWide(value);
}

void setEnvironmentDefault(const char* name, const char* value) {
    if (environmentVariable(name).empty()) _wputenv_s(toWide(name).c_str(), toWide(value).c_str());
}

} // namespace meltpool
