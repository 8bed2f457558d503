// Where the source tree and its build lie, in one object file: so that a compiler cache serves every checkout's tests.
#pragma once

#include <filesystem>

namespace meltpool::test {

/// The root of the source tree.
std::filesystem::path sourceFolder();

/// The folder that the tests were built in.
std::filesystem::path buildFolder();

} // namespace meltpool::test
