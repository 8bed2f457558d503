// Other programs of the machine, found in PATH and run without a shell.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// Where the program of this name is, in the folders of PATH; empty where there is none.
std::filesystem::path findProgram(const std::string& name);

/// Runs it with these words after its name, each as it is, waits for its end and answers its exit code; -1 where it
/// could not be started or was killed. It reads nothing; what it says goes where this program's goes.
int runToItsEnd(const std::filesystem::path& program, std::span<const std::string> words);

} // namespace meltpool
