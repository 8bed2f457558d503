// Makes checkpoints small: the difference from another checkpoint of the same lesson, compressed.
#pragma once

#include "core/training/attempt/checkpoint.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace meltpool {

/// Packs a checkpoint as its difference from `reference`, a checkpoint of the same lesson: the first one or the one
/// before. Unchanged metal costs nothing: equal blocks of 4 KiB are left out. In the other blocks each word is replaced
/// by its XOR with the reference's; in lists of slots, after the difference from the word before. Then the first bytes
/// of all words of a block come before all second ones and so on. Numbers that differ little have equal high bytes,
/// which so form long runs of zeros for the compressor (zlib's deflate at its fastest level). Throws RuntimeFault if
/// memory runs out.
std::vector<std::byte> pack(const Checkpoint& checkpoint, const Checkpoint& reference);

/// Packs a checkpoint against nothing.
std::vector<std::byte> pack(const Checkpoint& checkpoint);

/// The packed checkpoint, to the last bit. Throws InputError if the bytes are not from pack() or are damaged, or if the
/// reference is another one.
Checkpoint unpack(std::span<const std::byte> packed, const Checkpoint& reference);
Checkpoint unpack(std::span<const std::byte> packed);

} // namespace meltpool
