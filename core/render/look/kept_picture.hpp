// A picture that takes long to paint, stored in a file for the next start of the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// Returns the `bytes` that keepPicture() wrote into `file` under this `key`. None if there is no such file, if it was
/// written under another key, and if it is damaged: the picture is to be painted again.
std::optional<std::vector<std::byte>> keptPicture(const std::filesystem::path& file, std::uint64_t key, size_t bytes);

/// Writes `picture` as the whole of `file`, and makes its folder. If that is not possible nothing is stored: the next
/// start paints again.
void keepPicture(const std::filesystem::path& file, std::uint64_t key, std::span<const std::byte> picture);

} // namespace meltpool
