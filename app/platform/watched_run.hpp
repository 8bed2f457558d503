// A second run of the program that captures its error messages, for people who started it without a terminal.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

struct WatchedEnd {
    int code = 0;          ///< exit code; 128 and the signal's number if a signal ended it
    std::string complaint; ///< end of its standard error output, at most 2000 bytes; it was written there too
};

/// Runs this program with these words and waits for its end. If this process is asked to end, so is the other one.
/// Throws RuntimeFault if it cannot be started.
WatchedEnd runWatched(std::span<const std::string> words);

/// One or more sentences for the person; empty if the run ended well.
std::string endSentence(const WatchedEnd& end);

/// Words of a command line without `option`; nothing if it is not among them.
std::optional<std::vector<std::string>> withoutOption(int argc, const char* const* argv, const std::string& option);

} // namespace meltpool
