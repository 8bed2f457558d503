// Variables of the environment, as UTF-8.
#pragma once

#include <string>

namespace meltpool {

/// The variable's value; empty where it is not set or empty.
std::string environmentVariable(const char* name);

/// Sets the variable, for libraries too, unless somebody has set it already.
void setEnvironmentDefault(const char* name, const char* value);

} // namespace meltpool
