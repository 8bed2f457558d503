// Which build of the program this is.
#pragma once

#include <string>
#include <string_view>

namespace meltpool {

/// "0.1.0"
std::string_view programVersion();

/// The short commit it was built from, "-dirty" behind it where the sources were changed; "unknown" outside a checkout.
std::string_view programCommit();

/// Both, for people and records: "0.1.0 (1a2b3c4)".
std::string programBuild();

} // namespace meltpool
