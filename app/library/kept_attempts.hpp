// The recordings that the program has kept of people's attempts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// The user's folder of recordings. It need not exist.
std::filesystem::path recordingsFolder();

/// What a list shows of a recording.
struct KeptAttempt {
    std::filesystem::path file;
    std::string lesson;       ///< key
    std::string lessonFile;   ///< of a lesson outside of the catalogue; else empty
    std::string when;         ///< it began: "2026-11-23 08:10", by the clock on the wall there and then
    double seconds = 0;       ///< of the metal's time
    std::optional<int> score; ///< 0..100, where the finished weld was judged
    std::string verdict;      ///< "accepted" or "not accepted"; empty: none
    std::string ended;        ///< why; empty: it runs still, or its program ended without a word
    bool practice = false;    ///< it went back to an earlier moment: its score does not count
    std::uint64_t bytes = 0;  ///< of the file
};

/// Those of a folder, the newest first, by the moment when they began. Reads heads and ends only. Where `faults` is
/// given, it gets a sentence for each file that is called a recording and is none. A folder that is not there holds
/// none.
std::vector<KeptAttempt> keptRecordings(const std::filesystem::path& folder,
                                        std::vector<std::string>* faults = nullptr);

} // namespace meltpool
