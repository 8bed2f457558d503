#include "app/program/program_info.hpp"

namespace meltpool {

std::string_view programVersion() {
    return MELTPOOL_VERSION;
}

std::string_view programCommit() {
    return
#include "commit.inc"
        ;
}

} // namespace meltpool
