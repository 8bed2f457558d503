// Which build of the program this is.
#pragma once

#include <string_view>

namespace meltpool {

/// "0.1.0"
std::string_view programVersion();

/// The short commit it was built from, "-dirty" behind it where the sources were changed; "unknown" outside a checkout.
std::string_view programCommit();

} // namespace meltpool
