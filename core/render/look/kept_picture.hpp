// A picture that takes long to paint, kept in a file for the next start of the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// The `bytes` that keepPicture() wrote into `file` under the same `key`. None where there is no such file, where it
/// was written under another key, and where it is damaged: the picture is to be painted again.
std::optional<std::vector<std::byte>> keptPicture(const std::filesystem::path& file, std::uint64_t key, size_t bytes);

/// Writes `picture` as the whole of `file`, and makes its folder. Where that is not possible nothing is kept: the next
/// start paints again, as this one did.
void keepPicture(const std::filesystem::path& file, std::uint64_t key, std::span<const std::byte> picture);

} // namespace meltpool
