// Names the source tree and its build in one object file, so that a compiler cache serves every checkout's tests.
#pragma once

#include <filesystem>

namespace meltpool::test {

/// Returns the root of the source tree.
std::filesystem::path sourceFolder();

/// Returns the folder that the tests were built in.
std::filesystem::path buildFolder();

} // namespace meltpool::test
