// The command line: chooses the command and its arguments, and sets the exit code.
#pragma once

#include <span>
#include <string>

namespace meltpool {

/// Runs the program. Returns its exit code: 0 done, 2 bad input, 1 anything else; a failure prints one sentence.
int runProgram(int argc, char** argv);

/// Reads the words after the program's name as runProgram() does, and checks what `run` would run, but runs nothing.
/// Throws InputError for everything that is refused before a command begins.
void checkCommandLine(std::span<const std::string> words);

} // namespace meltpool
