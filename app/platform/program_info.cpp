#include "app/platform/program_info.hpp"

namespace meltpool {

std::string_view programVersion() {
    return MELTPOOL_VERSION;
}

std::string_view programCommit() {
    return
#include "commit.inc"
        ;
}

std::string programBuild() {
    return std::string(programVersion()) + " (" + std::string(programCommit()) + ")";
}

} // namespace meltpool
