// Checkpoints made small: what differs from another checkpoint of the same lesson, compressed.
#pragma once

#include "core/training/attempt/checkpoint.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace meltpool {

/// Packs a checkpoint as its difference from `reference`, of the same lesson: that of the start, or the one before.
/// Metal that did not change since costs nothing: blocks of 4 KiB that are the same are left out. Of the others each
/// word is taken as what its bits differ from the reference's, in lists of slots after the difference from the word
/// before; then the first bytes of all words of a block come before all second ones and so on. Numbers that differ
/// little are alike in their high bytes, which so lie together as long runs of zeros for the compressor (zlib's
/// deflate at its fastest level). Throws RuntimeFault without memory.
std::vector<std::byte> pack(const Checkpoint& checkpoint, const Checkpoint& reference);

/// The same against nothing.
std::vector<std::byte> pack(const Checkpoint& checkpoint);

/// The checkpoint that was packed, to the last bit. Throws InputError where the bytes are not those of pack() or were
/// damaged, or where the reference is another one.
Checkpoint unpack(std::span<const std::byte> packed, const Checkpoint& reference);
Checkpoint unpack(std::span<const std::byte> packed);

} // namespace meltpool
