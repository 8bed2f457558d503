// Keeps the folder of recordings within its limit, and tells what that has cost.
#pragma once

#include "core/base/parameter.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// What a person decides about recordings.
struct RecordingParameters {
    bool keep = true;   ///< every attempt has one
    int limitMb = 2000; ///< of the folder, MB of 1 000 000 bytes
};
ParameterList describe(RecordingParameters& parameters);

/// A new recording's place: `date` (local), lesson and number of the attempt, for people; the age is in the file.
std::filesystem::path recordingName(const std::filesystem::path& folder, const std::string& date,
                                    const std::string& lesson, int attempt);

/// Of files that recordingName() has named; what a person has given another name is neither counted nor removed.
std::uint64_t recordedBytes(const std::filesystem::path& folder);

/// Where the recordings take more than `limit` bytes, removes those whose attempts began first until they take no more,
/// and notes each in the folder's kRemovedList. Those in `spared`, of this run of the program, are never removed.
/// Answers a sentence for the person, which names them; empty where none was removed.
std::string keepWithinLimit(const std::filesystem::path& folder, std::uint64_t limit,
                            std::span<const std::filesystem::path> spared = {});

/// A sentence where the recordings come near their limit of `limit` bytes, or beyond it for the sake of those that are
/// `spared`; empty where they do not.
std::string nearLimit(const std::filesystem::path& folder, std::uint64_t limit,
                      std::span<const std::filesystem::path> spared = {});

/// File of a folder that names what was removed, a line each.
inline constexpr const char* kRemovedList = "removed.txt";

} // namespace meltpool
