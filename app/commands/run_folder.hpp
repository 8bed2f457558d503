// The folder that a run writes into: locked, never over a file that the run reads, never mixed with an earlier run.
#pragma once

#include "core/base/file_lock.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

class RunFolder {
  public:
    /// Makes the folder if it is missing and locks it. Throws InputError when that cannot be done, when another run
    /// writes there, or when the run would write over one of its `sources`. Changes nothing in the folder yet.
    RunFolder(std::filesystem::path folder, std::span<const std::filesystem::path> sources);

    const std::filesystem::path& path() const { return folder_; }
    std::filesystem::path result() const { return folder_ / "result.json"; }
    std::filesystem::path telemetry() const { return folder_ / "telemetry.csv"; }

    /// Removes the files that an earlier run left; links, devices and folders stay. Returns their count. Throws
    /// InputError for one that cannot be removed.
    size_t clear();

  private:
    std::filesystem::path folder_;
    std::optional<FileLock> lock_;
};

/// Path in `parent` that does not exist yet, for a run of this lesson without a folder of its own: "meltpool-KEY", then
/// "meltpool-KEY-2" and so on.
std::filesystem::path newRunFolder(const std::filesystem::path& parent, const std::string& lessonKey);

/// Sentence that clear() removed so many files of an earlier run.
std::string removedText(const std::filesystem::path& folder, size_t files);

/// True if a run writes files of this name: result, telemetry, pictures, and leftovers of a killed run.
bool isRunFile(std::string_view name);

} // namespace meltpool
