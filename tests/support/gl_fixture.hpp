// Provides the GL context, shaders and goldens that tests share.
#pragma once

#include "core/base/image.hpp"
#include "core/gl/context.hpp"
#include "core/gl/program.hpp"

#include <filesystem>
#include <string>

namespace meltpool::test {

/// Returns the headless context of the whole test program, made at first use.
gl::HeadlessContext& context();

/// Returns all shaders of the source tree; makes the context.
gl::ShaderLibrary& shaders();

/// Returns the folder `tests/` of the source tree.
std::filesystem::path testFolder();

/// Makes an empty folder that is removed at the end of the test program.
std::filesystem::path scratchFolder(const std::string& name);

/// Compares with tests/goldens/NAME.png: true if at most `farShare` of the pixels are off by more than 24 of 255 in a
/// channel and the mean difference is below 2. With MELTPOOL_APPROVE=1 in the environment writes the golden instead. On
/// failure saves the picture as NAME.actual.png in the build folder.
bool matchesGolden(const std::string& name, const Image& picture, double farShare = 0.01);

} // namespace meltpool::test
