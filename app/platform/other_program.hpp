// Other programs of the machine, found in PATH and run without a shell.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// Path of the program of this name, in the folders of PATH; empty if there is none.
std::filesystem::path findProgram(const std::string& name);

/// Runs it with these words after its name, passed unchanged, waits for its end and returns its exit code; -1 if it
/// could not be started or was killed. Its standard input is empty; its output goes to this program's.
int runToItsEnd(const std::filesystem::path& program, std::span<const std::string> words);

} // namespace meltpool
