#include "core/training/attempt/block_code.hpp"

#include <cstdint>
#include <cstring>

namespace meltpool {

namespace {

/// Word number `i`; bytes behind the end count as zeros.
std::uint32_t wordAt(std::span<const std::byte> bytes, size_t i) {
    std::uint32_t word = 0;
    if (4 * i + 4 <= bytes.size()) std::memcpy(&word, bytes.data() + 4 * i, 4);
    return word;
}

/// Yields the words of a block as differences from the reference's.
class Differences {
  public:
    Differences(std::span<const std::byte> reference, bool list) : reference_(reference), list_(list) {}

    std::uint32_t code(size_t i, std::uint32_t own) {
        const std::uint32_t expected = next(i);
        const std::uint32_t value = list_ ? own - before_ : own;
        before_ = own;
        return value ^ expected;
    }

    std::uint32_t decode(size_t i, std::uint32_t coded) {
        const std::uint32_t value = coded ^ next(i);
        before_ = list_ ? value + before_ : value;
        return before_;
    }

  private:
    /// The reference's word in this place, in the same form.
    std::uint32_t next(size_t i) {
        const std::uint32_t word = wordAt(reference_, i);
        const std::uint32_t value = list_ ? word - referenceBefore_ : word;
        referenceBefore_ = word;
        return value;
    }

    std::span<const std::byte> reference_;
    bool list_;
    std::uint32_t before_ = 0, referenceBefore_ = 0;
};

/// Index of word number `i` of `words` in the coded block: columns one after the other, then the words that fill no
/// whole row.
size_t placeOf(size_t i, size_t words, size_t rowWords) {
    const size_t rows = words / rowWords;
    return i < rows * rowWords ? i % rowWords * rows + i / rowWords : i;
}

} // namespace

void codeBlock(std::span<const std::byte> own, std::span<const std::byte> reference, const gl::StatePart& part,
               std::byte* coded) {
    const size_t words = own.size() / 4;
    Differences differences(reference, part.list);
    for (size_t i = 0; i < words; ++i) {
        const std::uint32_t word = differences.code(i, wordAt(own, i));
        const size_t place = placeOf(i, words, part.rowWords);
        for (size_t plane = 0; plane < 4; ++plane)
            coded[plane * words + place] = static_cast<std::byte>(word >> (8 * plane) & 0xFFU);
    }
    const size_t rest = own.size() - 4 * words;
    if (rest > 0) std::memcpy(coded + 4 * words, own.data() + 4 * words, rest);
}

void decodeBlock(const std::byte* coded, std::span<const std::byte> reference, const gl::StatePart& part,
                 std::span<std::byte> own) {
    const size_t words = own.size() / 4;
    Differences differences(reference, part.list);
    for (size_t i = 0; i < words; ++i) {
        const size_t place = placeOf(i, words, part.rowWords);
        std::uint32_t word = 0;
        for (size_t plane = 0; plane < 4; ++plane)
            word |= std::to_integer<std::uint32_t>(coded[plane * words + place]) << (8 * plane);
        const std::uint32_t value = differences.decode(i, word);
        std::memcpy(own.data() + 4 * i, &value, 4);
    }
    const size_t rest = own.size() - 4 * words;
    if (rest > 0) std::memcpy(own.data() + 4 * words, coded + 4 * words, rest);
}

} // namespace meltpool
