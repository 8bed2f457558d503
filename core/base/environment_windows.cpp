#include "core/base/environment.hpp"

#include "core/base/wide_text.hpp"

#include <windows.h>

#include <array>
#include <cstdlib>

namespace meltpool {

std::string environmentVariable(const char* name) {
    const wchar_t* value = _wgetenv(toWide(name).c_str());
    return value == nullptr ? std::string() : fromWide(value);
}

void setEnvironmentDefault(const char* name, const char* value) {
    if (environmentVariable(name).empty()) _wputenv_s(toWide(name).c_str(), toWide(value).c_str());
}

std::vector<std::string> preferredLanguages() {
    std::array<wchar_t, LOCALE_NAME_MAX_LENGTH> locale{};
    if (GetUserDefaultLocaleName(locale.data(), static_cast<int>(locale.size())) == 0) return {};
    const std::string name = fromWide(locale.data());
    return {name.substr(0, name.find('-'))};
}

} // namespace meltpool
