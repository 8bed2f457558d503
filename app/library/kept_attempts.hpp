// The stored recordings of people's attempts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// Folder of the user's recordings. It need not exist.
std::filesystem::path recordingsFolder();

/// Recording in a list.
struct KeptAttempt {
    std::filesystem::path file;
    std::string lesson;       ///< key
    std::string lessonFile;   ///< file of a lesson outside the catalogue; else empty
    std::string when;         ///< start: "2026-11-23 08:10", in the local time of that place
    double seconds = 0;       ///< s of the metal's time
    std::optional<int> score; ///< 0..100, if the finished weld was judged
    std::string verdict;      ///< "accepted" or "not accepted"; empty: none
    std::string ended;        ///< reason of the end; empty: it still runs, or its program crashed
    bool practice = false;    ///< true: it went back to an earlier checkpoint, and its score does not count
    std::uint64_t bytes = 0;  ///< size of the file
    std::string person = {};  ///< name of the person who welded; empty: not named
    std::string personId = {}; ///< see AttemptHead
    bool test = false;         ///< true: welded for score
    std::string title;         ///< name that a person gave it; empty: none
};

/// A recording's entry. Reads its head and end. Throws InputError if it is none.
KeptAttempt readKeptAttempt(const std::filesystem::path& file);

/// Recordings of a folder, newest first, by the moment of their start. Reads heads and ends only. `faults`, if given,
/// gets a sentence for each file that has a recording's name and is none. A missing folder has none.
std::vector<KeptAttempt> keptRecordings(const std::filesystem::path& folder,
                                        std::vector<std::string>* faults = nullptr);

} // namespace meltpool
