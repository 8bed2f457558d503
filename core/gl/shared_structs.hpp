// The structs of shaders/shared/ with the layout of this program's compiler.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace meltpool::gl {

struct SharedMember {
    std::string_view name;
    std::string_view type; ///< spelling in GLSL; for an array its element's
    size_t offset = 0;     ///< bytes from the start of the struct
    size_t bytes = 0;      ///< size of the member; for an array of one element
};

struct SharedStruct {
    std::string_view name;
    size_t bytes = 0;
    std::span<const SharedMember> members;
};

/// All structs of shaders/shared/*.h. The build generates this table from the headers (app/list_shared_structs.cmake),
/// so that a struct is written once.
std::span<const SharedStruct> sharedStructs();

} // namespace meltpool::gl
