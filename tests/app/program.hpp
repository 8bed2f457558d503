// A runner of the real program that captures its output and exit code.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool::test {

struct Outcome {
    int code = -1;
    std::string output; ///< standard output
    std::string errors; ///< standard error
};

/// Runs the built `meltpool ARGUMENTS` through the shell (`program` names another binary) and waits for it. `before`
/// precedes the command: variables, a changed folder.
Outcome runMeltpool(const std::string& arguments, const std::string& before = "",
                    const std::filesystem::path& program = {});

/// Runs the program until the record `telemetry` has more than 50 rows, then asks it to stop with SIGTERM.
Outcome runUntilRecorded(const std::string& arguments, const std::filesystem::path& telemetry,
                         const std::string& before = "");

/// Runs `first` until its new record `telemetry` has more than 50 rows and runs `second` in parallel. Then sends
/// `first` the signal ("KILL", "TERM") and waits for its end. Returns the outcome of `second`.
Outcome runBeside(const std::string& first, const std::string& signal, const std::filesystem::path& telemetry,
                  const std::string& second);

} // namespace meltpool::test
