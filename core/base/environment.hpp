// Variables of the environment and the user's language, as UTF-8.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

/// The variable's value; empty if it is not set or empty.
std::string environmentVariable(const char* name);

/// Sets the variable, also for libraries; no-op if it is already set.
void setEnvironmentDefault(const char* name, const char* value);

/// The languages of the system's settings, the preferred one first: "de", "pt". Only the letters before the country.
std::vector<std::string> preferredLanguages();

} // namespace meltpool
