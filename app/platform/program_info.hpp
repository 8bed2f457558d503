// The version and the commit of this build.
#pragma once

#include <string>
#include <string_view>

namespace meltpool {

/// Version: "0.1.0".
std::string_view programVersion();

/// Short commit it was built from, with "-dirty" if the sources were changed; "unknown" outside a checkout.
std::string_view programCommit();

/// Version and commit, for people and records: "0.1.0 (1a2b3c4)".
std::string programBuild();

} // namespace meltpool
