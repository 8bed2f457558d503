// A person's best attempt among the stored recordings.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool {

/// Recording in a folder with the highest score of a person at the lesson of this key, the newest of equal ones; an
/// empty path if none has a score that counts. `personId`: see AttemptHead; empty: attempts without a name. Reads heads
/// and ends only.
std::filesystem::path bestKept(const std::filesystem::path& folder, const std::string& lesson,
                               const std::string& personId = {});

} // namespace meltpool
