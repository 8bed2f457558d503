#include "core/training/attempt/packing.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/training/attempt/block_code.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace meltpool {

namespace {

constexpr std::uint64_t kMagic = 0x314B43454843504DU; // "MPCHECK1"
constexpr int kFastest = 1;
constexpr unsigned kPartBits = 8; ///< bits below a part's bytes: the words of its rows, and a flag for a list
constexpr std::uint64_t kMostRowWords = 127;
constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 34;

/// Numbers before the compressed bytes.
enum Head : size_t {
    magic,
    packedHash, ///< hash of everything behind it
    referenceHash,
    step,
    time,
    identity,
    historyFrom,
    historyTo,
    historyTime,
    historyBytes,
    stateBytes,
    stateParts,
    stateHash,
    rawBytes, ///< bytes before compression
    headNumbers
};
constexpr size_t kHeadBytes = headNumbers * sizeof(std::uint64_t);
constexpr size_t kHashedFrom = referenceHash * sizeof(std::uint64_t);

[[noreturn]] void refuse(const std::string& found) {
    throw InputError("the packed checkpoint " + found + "; expected its bytes unchanged");
}

/// `length` bytes from `from` on, or as many as there are.
std::span<const std::byte> cut(std::span<const std::byte> bytes, size_t from, size_t length) {
    from = std::min(from, bytes.size());
    return bytes.subspan(from, std::min(length, bytes.size() - from));
}

bool same(std::span<const std::byte> a, std::span<const std::byte> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size()) == 0);
}

/// Walks over the parts together with the reference's parts of the same number.
class PartWalk {
  public:
    PartWalk(const Checkpoint& reference, const std::vector<gl::StatePart>& parts)
        : reference_(reference), parts_(parts) {}

    bool more() const { return number_ < parts_.size(); }
    const gl::StatePart& part() const { return parts_[number_]; }
    size_t begin() const { return begin_; }
    std::span<const std::byte> reference() const {
        if (number_ >= reference_.parts.size()) return {};
        return cut(reference_.bytes, referenceBegin_, reference_.parts[number_].bytes);
    }
    void next() {
        begin_ += parts_[number_].bytes;
        if (number_ < reference_.parts.size()) referenceBegin_ += reference_.parts[number_].bytes;
        ++number_;
    }

  private:
    const Checkpoint& reference_;
    const std::vector<gl::StatePart>& parts_;
    size_t number_ = 0, begin_ = 0, referenceBegin_ = 0;
};

/// Appends one bit a block, set if it differs from the reference's, then the blocks that differ.
void appendPart(std::vector<std::byte>& raw, std::span<const std::byte> own, std::span<const std::byte> reference,
                const gl::StatePart& part) {
    const size_t block = blockBytes(part), blocks = (own.size() + block - 1) / block;
    const size_t bits = raw.size();
    raw.resize(bits + (blocks + 7) / 8);
    for (size_t i = 0; i < blocks; ++i) {
        const auto mine = cut(own, i * block, block);
        const auto other = cut(reference, i * block, block);
        if (same(mine, other)) continue;
        raw[bits + i / 8] |= std::byte{1} << (i % 8);
        const size_t at = raw.size();
        raw.resize(at + mine.size());
        codeBlock(mine, other, part, raw.data() + at);
    }
}

/// Takes bytes from the front.
std::span<const std::byte> take(std::span<const std::byte>& raw, size_t bytes) {
    if (bytes > raw.size()) refuse("ends in the middle of a part");
    const auto taken = raw.first(bytes);
    raw = raw.subspan(bytes);
    return taken;
}

void takePart(std::span<const std::byte>& raw, std::span<std::byte> own, std::span<const std::byte> reference,
              const gl::StatePart& part) {
    const size_t block = blockBytes(part), blocks = (own.size() + block - 1) / block;
    const auto bits = take(raw, (blocks + 7) / 8);
    for (size_t i = 0; i < blocks; ++i) {
        const size_t from = i * block;
        const auto mine = own.subspan(from, std::min(block, own.size() - from));
        const auto other = cut(reference, from, block);
        if ((bits[i / 8] >> (i % 8) & std::byte{1}) != std::byte{0}) {
            decodeBlock(take(raw, mine.size()).data(), other, part, mine);
        } else {
            if (other.size() != mine.size()) refuse("leaves out a block that its reference does not have");
            std::copy(other.begin(), other.end(), mine.begin());
        }
    }
}

std::vector<std::byte> rawOf(const Checkpoint& checkpoint, const Checkpoint& reference) {
    std::vector<std::byte> raw;
    raw.reserve(checkpoint.bytes.size() / 4 + checkpoint.history.size());
    appendPart(raw, checkpoint.history, {}, {});
    for (PartWalk walk(reference, checkpoint.parts); walk.more(); walk.next())
        appendPart(raw, cut(checkpoint.bytes, walk.begin(), walk.part().bytes), walk.reference(), walk.part());
    return raw;
}

std::vector<std::uint64_t> numbersOf(const Checkpoint& checkpoint, const Checkpoint& reference, size_t raw) {
    std::vector<std::uint64_t> numbers(headNumbers);
    numbers[magic] = kMagic;
    numbers[referenceHash] = reference.hash;
    numbers[step] = checkpoint.step;
    numbers[time] = std::bit_cast<std::uint64_t>(checkpoint.time);
    numbers[identity] = checkpoint.identity;
    numbers[historyFrom] = checkpoint.historyFrom;
    numbers[historyTo] = checkpoint.historyTo;
    numbers[historyTime] = std::bit_cast<std::uint64_t>(checkpoint.historyTime);
    numbers[historyBytes] = checkpoint.history.size();
    numbers[stateBytes] = checkpoint.bytes.size();
    numbers[stateParts] = checkpoint.parts.size();
    numbers[stateHash] = checkpoint.hash;
    numbers[rawBytes] = raw;
    for (const gl::StatePart& part : checkpoint.parts) {
        if (part.rowWords == 0 || part.rowWords > kMostRowWords)
            throw RuntimeFault("a checkpoint cannot pack rows of " + std::to_string(part.rowWords) + " words");
        numbers.push_back(std::uint64_t{part.bytes} << kPartBits | part.rowWords << 1U | (part.list ? 1U : 0U));
    }
    return numbers;
}

std::uint64_t numberAt(std::span<const std::byte> packed, size_t place) {
    std::uint64_t number = 0;
    std::memcpy(&number, packed.data() + place * sizeof number, sizeof number);
    return number;
}

/// Throws InputError unless `packed` has its stored hash and was packed with `reference`.
void check(std::span<const std::byte> packed, const Checkpoint& reference) {
    if (packed.size() < kHeadBytes || numberAt(packed, magic) != kMagic) refuse("does not begin like one");
    if (numberAt(packed, packedHash) != hashOfBytes(packed.subspan(kHashedFrom))) refuse("is damaged");
    if (numberAt(packed, referenceHash) != reference.hash)
        throw InputError("the packed checkpoint of step " + std::to_string(numberAt(packed, step)) +
                         " needs another reference; expected the one used to pack it");
    const std::uint64_t parts = numberAt(packed, stateParts);
    if (parts > (packed.size() - kHeadBytes) / sizeof(std::uint64_t)) refuse("ends within the sizes of its parts");
    for (const Head size : {historyBytes, stateBytes, rawBytes})
        if (numberAt(packed, size) > kMostBytes) refuse("has an impossible size");
}

Checkpoint headOf(std::span<const std::byte> packed) {
    Checkpoint made;
    made.step = numberAt(packed, step);
    made.time = std::bit_cast<double>(numberAt(packed, time));
    made.identity = numberAt(packed, identity);
    made.historyFrom = numberAt(packed, historyFrom);
    made.historyTo = numberAt(packed, historyTo);
    made.historyTime = std::bit_cast<double>(numberAt(packed, historyTime));
    made.hash = numberAt(packed, stateHash);
    std::uint64_t all = 0;
    for (std::uint64_t i = 0; i < numberAt(packed, stateParts); ++i) {
        const std::uint64_t part = numberAt(packed, headNumbers + i);
        const std::uint64_t bytes = part >> kPartBits, rowWords = part >> 1U & kMostRowWords;
        if (bytes > kMostBytes || rowWords == 0) refuse("has an impossible size");
        made.parts.push_back({bytes, (part & 1U) != 0, false, rowWords});
        all += bytes;
    }
    if (all != numberAt(packed, stateBytes)) refuse("has sizes of parts that do not add up");
    made.history.resize(numberAt(packed, historyBytes));
    made.bytes.resize(all);
    return made;
}

std::vector<std::byte> inflated(std::span<const std::byte> from, size_t bytes) {
    std::vector<std::byte> raw(bytes + 1); // never empty
    auto length = static_cast<uLongf>(raw.size());
    const int answer = uncompress(reinterpret_cast<Bytef*>(raw.data()), &length,
                                  reinterpret_cast<const Bytef*>(from.data()), static_cast<uLong>(from.size()));
    if (answer != Z_OK || length != bytes) refuse("cannot be decompressed");
    raw.resize(bytes);
    return raw;
}

} // namespace

std::vector<std::byte> pack(const Checkpoint& checkpoint, const Checkpoint& reference) {
    const std::vector<std::byte> raw = rawOf(checkpoint, reference);
    const std::vector<std::uint64_t> numbers = numbersOf(checkpoint, reference, raw.size());
    const auto head = std::as_bytes(std::span(numbers));
    std::vector<std::byte> packed(head.size() + compressBound(static_cast<uLong>(raw.size())));
    std::copy(head.begin(), head.end(), packed.begin());
    auto length = static_cast<uLongf>(packed.size() - head.size());
    const int answer = compress2(reinterpret_cast<Bytef*>(packed.data() + head.size()), &length,
                                 reinterpret_cast<const Bytef*>(raw.data()), static_cast<uLong>(raw.size()), kFastest);
    if (answer != Z_OK) throw RuntimeFault("there is no memory to pack a checkpoint; expected free memory");
    packed.resize(head.size() + length);
    packed.shrink_to_fit();
    const std::uint64_t hash = hashOfBytes(std::span<const std::byte>(packed).subspan(kHashedFrom));
    std::memcpy(packed.data() + packedHash * sizeof hash, &hash, sizeof hash);
    return packed;
}

std::vector<std::byte> pack(const Checkpoint& checkpoint) {
    return pack(checkpoint, Checkpoint{});
}

Checkpoint unpack(std::span<const std::byte> packed, const Checkpoint& reference) {
    check(packed, reference);
    Checkpoint made = headOf(packed);
    const size_t head = kHeadBytes + made.parts.size() * sizeof(std::uint64_t);
    const std::vector<std::byte> raw = inflated(packed.subspan(head), numberAt(packed, rawBytes));
    std::span<const std::byte> rest = raw;
    takePart(rest, made.history, {}, {});
    for (PartWalk walk(reference, made.parts); walk.more(); walk.next())
        takePart(rest, std::span(made.bytes).subspan(walk.begin(), walk.part().bytes), walk.reference(), walk.part());
    requireWhole(made);
    return made;
}

Checkpoint unpack(std::span<const std::byte> packed) {
    return unpack(packed, Checkpoint{});
}

} // namespace meltpool
