#include "core/training/attempt/checkpoint.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"

#include <array>
#include <bit>

namespace meltpool {

std::uint64_t hashOf(const Checkpoint& checkpoint) {
    const std::array<std::uint64_t, 8> head{
        checkpoint.step,         std::bit_cast<std::uint64_t>(checkpoint.time),
        checkpoint.identity,     checkpoint.historyFrom,
        checkpoint.historyTo,    std::bit_cast<std::uint64_t>(checkpoint.historyTime),
        checkpoint.parts.size(), checkpoint.bytes.size()};
    std::uint64_t hash = hashOfBytes(std::as_bytes(std::span(head)));
    for (const gl::StatePart& part : checkpoint.parts) {
        const std::array<std::uint64_t, 3> numbers{part.bytes, part.list, part.rowWords};
        hash = hashOfBytes(std::as_bytes(std::span(numbers)), hash);
    }
    return hashOfBytes(checkpoint.bytes, hashOfBytes(checkpoint.history, hash));
}

void seal(Checkpoint& checkpoint) {
    checkpoint.hash = hashOf(checkpoint);
}

void requireWhole(const Checkpoint& checkpoint) {
    if (checkpoint.hash != hashOf(checkpoint))
        throw InputError("the checkpoint of step " + std::to_string(checkpoint.step) +
                         " is damaged; expected the bytes that were saved");
}

size_t sizeOf(const Checkpoint& checkpoint) {
    return checkpoint.bytes.capacity() + checkpoint.history.capacity() +
           checkpoint.parts.capacity() * sizeof(gl::StatePart);
}

} // namespace meltpool
