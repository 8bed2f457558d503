// How a block of a state becomes bytes that compress well, and back.
#pragma once

#include "core/gl/state_archive.hpp"

#include <cstddef>
#include <span>

namespace meltpool {

/// Bytes of a block of this part; the last one may be shorter. Whole rows of a table.
inline size_t blockBytes(const gl::StatePart& part) {
    constexpr size_t kWords = 1024; // of each column
    return kWords * 4 * part.rowWords;
}

/// `reference`: of the same place in another state; shorter where there is less, what is missing counts as zeros.
/// `part`: what the block is of. Writes own.size() bytes to `coded`: what differs, the lowest bytes of all words first,
/// column by column.
void codeBlock(std::span<const std::byte> own, std::span<const std::byte> reference, const gl::StatePart& part,
               std::byte* coded);

/// The inverse: `coded` has as many bytes as `own`.
void decodeBlock(const std::byte* coded, std::span<const std::byte> reference, const gl::StatePart& part,
                 std::span<std::byte> own);

} // namespace meltpool
