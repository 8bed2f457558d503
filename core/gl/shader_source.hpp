// GLSL text with resolved includes: C++, glslangValidator and the driver use the same files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace meltpool::gl {

/// Macros to define for a shader: name -> value.
using Defines = std::map<std::string, std::string>;

struct ShaderSource {
    std::string text;
    /// Files by their number in #line directives; [0] is the shader itself.
    std::vector<std::filesystem::path> files;
};

/// Reads `root/name`, inserts `defines` behind its #version line and replaces every `#include "path"` (relative to the
/// including file, else to `root`) by the file, each file once. Throws InputError with file and line of a missing file.
ShaderSource loadShaderSource(const std::filesystem::path& root, const std::string& name, const Defines& defines);

/// The driver's log with "number(line)" and "number:line" turned into file names.
std::string readableShaderLog(const ShaderSource& source, const std::string& log);

} // namespace meltpool::gl
