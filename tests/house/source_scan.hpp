// Scanner of source files for the house test: includes, lengths of functions, sizes of classes, and vector comments
// with several meanings.
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

/// Returns every file below `folders` of the tree at `root` that has one of these extensions (".cpp"), sorted by path.
std::vector<SourceFile> readSources(const std::filesystem::path& root, const std::vector<std::string_view>& folders,
                                    const std::vector<std::string_view>& extensions);

/// An #include "..." of a file.
struct Include {
    int line = 0; ///< counted from 1
    std::string path;
};
std::vector<Include> findIncludes(std::string_view text);

/// A function from the first line of its declaration to its closing brace.
struct FunctionLength {
    int line = 0; ///< first line, from 1
    int lines = 0;
    std::string head; ///< declaration on one line
};

/// Returns all functions of a C++ or GLSL text with their bodies. Functions and lambdas inside another function belong
/// to the outer one. Preprocessor lines are ignored, so that both branches of an #if must have balanced braces.
std::vector<FunctionLength> findFunctions(std::string_view text);

/// A class, struct or union with its body.
struct ClassSize {
    int line = 0;     ///< line of its opening brace, from 1
    std::string name; ///< name with the classes around it: "Surface::Work"
    int publicFunctions = 0;
    int members = 0;
};

/// Returns all classes of a C++ text in the order of their ends, nested ones included, those inside functions excluded.
/// Public functions include constructors, operators and overloads but no deleted function. Members are data of each
/// object, of any access: `int a, b;` is two, and a nested class counts for itself. Macros, functions and preprocessor
/// lines are treated as by findFunctions().
std::vector<ClassSize> findClasses(std::string_view text);

/// Returns the lines (from 1) of a shared header or shader that declare a vector member, uniform or varying whose
/// comment gives its components different meanings: "vec4 origin; // xyz position, w temperature".
std::vector<int> findMixedVectors(std::string_view text);

} // namespace meltpool::test
