// GLSL text with its includes resolved, so that the same files serve C++, glslangValidator and the driver.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace meltpool::gl {

/// Replacements for macros that a shader leaves open: name -> value.
using Defines = std::map<std::string, std::string>;

struct ShaderSource {
    std::string text;
    /// Files in the order of the numbers that #line uses; [0] is the shader itself.
    std::vector<std::filesystem::path> files;
};

/// Reads `root/name`, puts `defines` behind its #version line and every `#include "path"` (relative to the including
/// file, else to `root`) in place, each file once. Throws InputError naming file and line where a file is missing.
ShaderSource loadShaderSource(const std::filesystem::path& root, const std::string& name, const Defines& defines);

/// The driver's log with "number(line)" and "number:line" turned into file names.
std::string readableShaderLog(const ShaderSource& source, const std::string& log);

} // namespace meltpool::gl
