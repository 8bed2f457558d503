#include "core/base/environment.hpp"

#include <algorithm>
#include <cstdlib>

namespace meltpool {

namespace {

/// "de" for "de_DE.UTF-8"; empty for "C" and "POSIX".
std::string languageOf(const std::string& locale) {
    const auto end = std::find_if(locale.begin(), locale.end(), [](char c) { return c < 'a' || c > 'z'; });
    return end - locale.begin() >= 2 ? std::string(locale.begin(), end) : std::string();
}

} // namespace

std::string environmentVariable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

void setEnvironmentDefault(const char* name, const char* value) {
    setenv(name, value, 0);
}

// gettext's rule: LANGUAGE lists several languages, but is ignored for the locale "C".
std::vector<std::string> preferredLanguages() {
    std::string locale;
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (locale.empty()) locale = environmentVariable(name);
    const std::string first = languageOf(locale);
    if (first.empty()) return {};
    std::vector<std::string> languages;
    std::string list = environmentVariable("LANGUAGE") + ":";
    for (size_t colon = list.find(':'); colon != std::string::npos; colon = list.find(':')) {
        if (std::string each = languageOf(list.substr(0, colon)); !each.empty()) languages.push_back(std::move(each));
        list.erase(0, colon + 1);
    }
    languages.push_back(first);
    return languages;
}

} // namespace meltpool
