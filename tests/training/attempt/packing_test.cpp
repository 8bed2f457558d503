// Packed checkpoints: every bit is restored, unchanged data cost almost nothing, and damage is found.
#include "core/training/attempt/packing.hpp"

#include "core/base/error.hpp"
#include "core/training/attempt/block_code.hpp"
#include "tests/support/catch.hpp"

#include <random>

using namespace meltpool;

namespace {

std::vector<std::byte> noise(size_t bytes, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> made(bytes);
    for (std::byte& each : made)
        each = static_cast<std::byte>(random() & 0xFFU);
    return made;
}

/// Returns a checkpoint of random parts with these sizes, every second one a list.
Checkpoint madeOf(const std::vector<size_t>& sizes, unsigned seed) {
    Checkpoint made;
    made.step = 4711;
    made.time = 52.25;
    made.identity = 99;
    made.historyFrom = 10;
    made.historyTo = 12;
    made.historyTime = 0.125;
    made.history = noise(180, seed + 1);
    size_t all = 0;
    for (const size_t size : sizes) {
        const size_t number = made.parts.size();
        made.parts.push_back({size, number % 2 == 1, false, number % 2 == 1 ? size_t(1) : 1 + number});
        all += size;
    }
    made.bytes = noise(all, seed);
    seal(made);
    return made;
}

bool same(const Checkpoint& a, const Checkpoint& b) {
    return a.step == b.step && a.time == b.time && a.identity == b.identity && a.historyFrom == b.historyFrom &&
           a.historyTo == b.historyTo && a.historyTime == b.historyTime && a.history == b.history &&
           a.parts == b.parts && a.bytes == b.bytes && a.hash == b.hash;
}

const std::vector<size_t> kSizes{0, 1, 3, 4, 4095, 4096, 4097, 20000, 7, 0, 65536};

} // namespace

TEST_CASE("a block comes back from its code, whatever its length and its reference", "[training]") {
    for (const size_t size : {0, 1, 3, 4, 5, 8, 4095, 4096})
        for (const size_t known : {0, 1, 6, 4096})
            for (const gl::StatePart part : {gl::StatePart{}, {0, true}, {0, false, false, 4}, {0, false, false, 16}}) {
                INFO(size << " bytes, " << known << " of the reference, list " << part.list << ", rows of "
                          << part.rowWords);
                const auto own = noise(size, 1);
                const auto reference = noise(std::min(known, size), 2);
                std::vector<std::byte> coded(size), back(size);
                codeBlock(own, reference, part, coded.data());
                decodeBlock(coded.data(), reference, part, back);
                CHECK(back == own);
            }
}

TEST_CASE("a checkpoint that was packed comes back to the last bit", "[training]") {
    const Checkpoint checkpoint = madeOf(kSizes, 1);
    CHECK(same(unpack(pack(checkpoint)), checkpoint));
    const Checkpoint alike = madeOf(kSizes, 2);
    CHECK(same(unpack(pack(checkpoint, alike), alike), checkpoint));
    const Checkpoint other = madeOf({4096, 12, 90000}, 3);
    CHECK(same(unpack(pack(checkpoint, other), other), checkpoint));
    const Checkpoint empty = madeOf({}, 4);
    CHECK(same(unpack(pack(empty, other), other), empty));
    CHECK(same(unpack(pack(checkpoint, empty), empty), checkpoint));
}

TEST_CASE("metal that did not change since the reference costs next to nothing", "[training]") {
    const Checkpoint reference = madeOf({size_t(1) << 20, size_t(1) << 20}, 1);
    Checkpoint checkpoint = reference;
    CHECK(pack(checkpoint, reference).size() < 1000);
    for (size_t i = 0; i < checkpoint.bytes.size(); i += 16) // low byte of every fourth number
        checkpoint.bytes[i] ^= std::byte{1};
    seal(checkpoint);
    CHECK(pack(checkpoint, reference).size() < checkpoint.bytes.size() / 20);
    CHECK(same(unpack(pack(checkpoint, reference), reference), checkpoint));
}

TEST_CASE("packed bytes that are cut, flipped or of another reference are refused", "[training]") {
    const Checkpoint reference = madeOf(kSizes, 1), checkpoint = madeOf(kSizes, 2);
    const std::vector<std::byte> packed = pack(checkpoint, reference);
    CHECK_THROWS_WITH(unpack(packed, checkpoint), test::containsText("another reference"));
    CHECK_THROWS_AS(unpack(packed), InputError);
    CHECK_THROWS_AS(unpack({}, reference), InputError);
    for (size_t bytes = 0; bytes < packed.size(); bytes += 1 + packed.size() / 200)
        CHECK_THROWS_AS(unpack(std::span(packed).first(bytes), reference), InputError);
    for (size_t place = 0; place < packed.size(); place += 1 + packed.size() / 500) {
        std::vector<std::byte> damaged = packed;
        damaged[place] ^= std::byte{0x10};
        CHECK_THROWS_AS(unpack(damaged, reference), InputError);
    }
    std::vector<std::byte> longer = packed;
    longer.push_back(std::byte{0});
    CHECK_THROWS_AS(unpack(longer, reference), InputError);
}
