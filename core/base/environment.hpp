// Variables of the environment and the person's language, as UTF-8.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

/// The variable's value; empty where it is not set or empty.
std::string environmentVariable(const char* name);

/// Sets the variable, for libraries too, unless somebody has set it already.
void setEnvironmentDefault(const char* name, const char* value);

/// The person's languages as the system is set, the most wanted first: "de", "pt". Letters before the country only.
std::vector<std::string> preferredLanguages();

} // namespace meltpool
