// Compares the layout of a linked program's blocks with the C++ structs that fill them. Shaders of another version of
// the program compile and link, but read other bytes than C++ wrote.
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

/// The blocks of these two forms in GLSL text: one member, no instance name. Uniform blocks first.
std::vector<BlockDeclaration> findBlocks(std::string_view glsl);

/// The difference between `block` of the linked `program` and the struct that C++ fills it from, as words that follow
/// the name of a file: "block 'X' (struct Y) has 80 bytes, but 64 in this program". Empty if both agree, if the program
/// does not use the block, or if `known` has no struct of its type (plain numbers, or a struct that C++ never sees).
std::string blockDifference(GLuint program, const BlockDeclaration& block, std::span<const SharedStruct> known);

} // namespace meltpool::gl
