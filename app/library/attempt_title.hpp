// The name that a person gives a stored attempt. It is a file next to the recording, whose bytes stay as they are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

inline constexpr size_t kLongestTitle = 80; ///< bytes

/// File of a recording's name: "ATTEMPT.meltrec" has "ATTEMPT.title.txt".
std::filesystem::path titleFile(const std::filesystem::path& recording);

/// The recording's name; empty if it has none, or none that can be read. Never throws.
std::string readTitle(const std::filesystem::path& recording);

/// Gives the recording a name of one line, shortened to kLongestTitle bytes; an empty one removes it. Returns the
/// stored name. Throws as writeFile(), and InputError if the name cannot be removed.
std::string writeTitle(const std::filesystem::path& recording, std::string_view title);

} // namespace meltpool
