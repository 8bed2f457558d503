// Runs the program a second time and keeps what it complains of, for people who started it without a terminal.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

struct WatchedEnd {
    int code = 0;          ///< exit code; 128 and the signal's number where a signal ended it
    std::string complaint; ///< the end of what it wrote to standard error, at most 2000 bytes; it went there too
};

/// Runs this program with these words and waits for its end. Where this process is ended the other one is asked to end
/// too. Throws RuntimeFault where it cannot be started.
WatchedEnd runWatched(std::span<const std::string> words);

/// A sentence or several for the person; empty where the run ended well.
std::string endSentence(const WatchedEnd& end);

/// The words of a command line without `option`; nothing where it is not among them.
std::optional<std::vector<std::string>> withoutOption(int argc, const char* const* argv, const std::string& option);

} // namespace meltpool
