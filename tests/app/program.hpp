// Runs the real program and keeps what it said.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool::test {

struct Outcome {
    int code = -1;
    std::string output; ///< standard output
    std::string errors; ///< standard error
};

/// Runs `meltpool ARGUMENTS` of the build through the shell (`program`: another binary) and waits for it. `before` is
/// put in front of the command: variables, a changed folder.
Outcome runMeltpool(const std::string& arguments, const std::string& before = "",
                    const std::filesystem::path& program = {});

/// Runs it until the record `telemetry` has more than 50 rows, then asks it to stop with SIGTERM.
Outcome runUntilRecorded(const std::string& arguments, const std::filesystem::path& telemetry,
                         const std::string& before = "");

/// Runs `first` until the record `telemetry`, written anew by it, has more than 50 rows, then `second` beside it, then
/// sends `first` the signal ("KILL", "TERM") and waits for its end. Answers what `second` gave.
Outcome runBeside(const std::string& first, const std::string& signal, const std::filesystem::path& telemetry,
                  const std::string& second);

} // namespace meltpool::test
