// The command line: which command, with what, and how the program ends.
#pragma once

namespace meltpool {

/// Runs the program. Returns its exit code: 0 done, 2 bad input, 1 anything else; a failure prints one sentence.
int runProgram(int argc, char** argv);

} // namespace meltpool
