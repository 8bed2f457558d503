// Layout of a linked program's blocks, compared with the C++ structs that fill them. Shaders of another version of the
// program compile and link, but read other bytes than C++ wrote.
#pragma once

#include "core/gl/gl.hpp"
#include "core/gl/shared_structs.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace meltpool::gl {

/// `uniform NAME { TYPE VARIABLE; };` or `buffer NAME { TYPE VARIABLE[]; };`
struct BlockDeclaration {
    std::string name;
    std::string type;
    std::string variable;
    bool storage = false; ///< a buffer block, else a uniform block
};

/// The blocks of these two forms in GLSL text: one member, no name of an instance. Uniform blocks first.
std::vector<BlockDeclaration> findBlocks(std::string_view glsl);

/// How `block` of the linked `program` differs from the struct that C++ fills it from, as words that follow the name of
/// a file: "block 'X' (struct Y) has 80 bytes, but 64 in this program". Empty where both agree, where the program does
/// not use the block, and where `known` has no struct of its type (plain numbers, or a struct that C++ never sees).
std::string blockDifference(GLuint program, const BlockDeclaration& block, std::span<const SharedStruct> known);

} // namespace meltpool::gl
