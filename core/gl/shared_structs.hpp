// The structs of shaders/shared/ as this program was compiled with them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace meltpool::gl {

struct SharedMember {
    std::string_view name;
    std::string_view type; ///< as GLSL writes it; of an array its element's
    size_t offset = 0;     ///< bytes from the start of the struct
    size_t bytes = 0;      ///< of the member; of an array of one element
};

struct SharedStruct {
    std::string_view name;
    size_t bytes = 0;
    std::span<const SharedMember> members;
};

/// All structs of shaders/shared/*.h. The build makes this table of the headers themselves
/// (app/list_shared_structs.cmake), so that a struct is written once.
std::span<const SharedStruct> sharedStructs();

} // namespace meltpool::gl
