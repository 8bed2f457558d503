// How a block of a state becomes bytes that compress well, and back.
#pragma once

#include <cstddef>
#include <span>

namespace meltpool {

/// Bytes of a block; the last one of a part may be shorter.
inline constexpr size_t kStateBlock = 4096;

/// `reference`: of the same place in another state; shorter where there is less, what is missing counts as zeros.
/// `list`: see gl::StatePart. Writes own.size() bytes to `coded`.
void codeBlock(std::span<const std::byte> own, std::span<const std::byte> reference, bool list, std::byte* coded);

/// The inverse: `coded` has as many bytes as `own`.
void decodeBlock(const std::byte* coded, std::span<const std::byte> reference, bool list, std::span<std::byte> own);

} // namespace meltpool
