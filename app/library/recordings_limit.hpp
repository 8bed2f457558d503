// The limit of the recordings' folder: removes the oldest, and reports them.
#pragma once

#include "core/base/parameter.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// A person's settings of recordings.
struct RecordingParameters {
    bool keep = true;   ///< true: every attempt has one
    int limitMb = 2000; ///< limit of the folder, MB of 1 000 000 bytes
};
ParameterList describe(RecordingParameters& parameters);

/// Path for a new recording: `date` (local), lesson and number of the attempt, for people; its age is in the file.
std::filesystem::path recordingName(const std::filesystem::path& folder, const std::string& date,
                                    const std::string& lesson, int attempt);

/// Bytes of files that recordingName() has named, deleted ones too; renamed ones are neither counted nor removed.
std::uint64_t recordedBytes(const std::filesystem::path& folder);

/// Removes recordings beyond `limit` bytes, deleted ones first, then those that began first, and notes each in the
/// folder's kRemovedList. Those in `spared`, of this run of the program, are never removed. Returns a sentence for the
/// person, which names them; empty if none was removed.
std::string keepWithinLimit(const std::filesystem::path& folder, std::uint64_t limit,
                            std::span<const std::filesystem::path> spared = {});

/// Sentence if the recordings come near their limit of `limit` bytes, or exceed it because of those in `spared`; else
/// empty.
std::string nearLimit(const std::filesystem::path& folder, std::uint64_t limit,
                      std::span<const std::filesystem::path> spared = {});

/// File of a folder that lists the removed recordings, one per line.
inline constexpr const char* kRemovedList = "removed.txt";

} // namespace meltpool
