// The folder of deleted attempts, from which each can be brought back.
#pragma once

#include <filesystem>

namespace meltpool {

/// Folder, inside a folder of recordings, that holds the deleted ones until the limit of the recordings removes them.
inline constexpr const char* kDeletedFolder = "deleted";

/// Moves a recording, with its name, into its folder's kDeletedFolder. Returns its new place; no other file is
/// replaced. Throws InputError if it cannot be moved; then it stays.
std::filesystem::path deleteAttempt(const std::filesystem::path& recording);

/// Moves a recording that deleteAttempt() has moved back to `place`. Throws InputError if it cannot, or if there is a
/// file.
void bringBackAttempt(const std::filesystem::path& deleted, const std::filesystem::path& place);

} // namespace meltpool
