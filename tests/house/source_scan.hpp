// What the house test reads from source files: includes, lengths of functions, comments that give the components of a
// vector different meanings.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::test {

/// A file of the source tree with its text.
struct SourceFile {
    std::filesystem::path path; ///< relative to the root of the tree, with forward slashes
    std::string text;
};

/// Every file below `folders` of the tree at `root` that has one of these extensions (".cpp"), sorted by path.
std::vector<SourceFile> readSources(const std::filesystem::path& root, const std::vector<std::string_view>& folders,
                                    const std::vector<std::string_view>& extensions);

/// An #include "..." of a file.
struct Include {
    int line = 0; ///< from 1
    std::string path;
};
std::vector<Include> findIncludes(std::string_view text);

/// A function from the first line of its declaration to its closing brace.
struct FunctionLength {
    int line = 0; ///< first line, from 1
    int lines = 0;
    std::string head; ///< the declaration, on one line
};

/// All functions of a C++ or GLSL text with their bodies. Functions and lambdas inside another function belong to the
/// outer one. Preprocessor lines are ignored, so that both branches of an #if must have balanced braces.
std::vector<FunctionLength> findFunctions(std::string_view text);

/// Lines (from 1) of a shared header or shader that declare a vector member, uniform or varying whose comment gives its
/// components different meanings: "vec4 origin; // xyz position, w temperature".
std::vector<int> findMixedVectors(std::string_view text);

} // namespace meltpool::test
