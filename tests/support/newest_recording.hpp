// Finds the recordings that a test's program has left.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace meltpool::test {

/// Returns the recordings of a folder sorted by name: the oldest first.
inline std::vector<std::filesystem::path> recordingsIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".meltrec") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Returns an empty name if there is none.
inline std::filesystem::path newestRecording(const std::filesystem::path& folder) {
    const auto files = recordingsIn(folder);
    return files.empty() ? std::filesystem::path() : files.back();
}

} // namespace meltpool::test
