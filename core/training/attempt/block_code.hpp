// Codes a block of a state into bytes that compress well, and back.
#pragma once

#include "core/gl/state_archive.hpp"

#include <cstddef>
#include <span>

namespace meltpool {

/// Bytes of a block of this part, in whole rows of a table; the last block may be shorter.
inline size_t blockBytes(const gl::StatePart& part) {
    constexpr size_t kWords = 1024; // words of each column
    return kWords * 4 * part.rowWords;
}

/// `reference`: bytes of the same place in another state; missing ones count as zeros. `part`: description of the
/// block's part. Writes own.size() bytes to `coded`: the differences, the lowest bytes of all words first, column by
/// column.
void codeBlock(std::span<const std::byte> own, std::span<const std::byte> reference, const gl::StatePart& part,
               std::byte* coded);

/// The inverse: `coded` has as many bytes as `own`.
void decodeBlock(const std::byte* coded, std::span<const std::byte> reference, const gl::StatePart& part,
                 std::span<std::byte> own);

} // namespace meltpool
