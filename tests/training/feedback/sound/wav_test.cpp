// The bytes of WAV files.
#include "core/training/feedback/sound/wav.hpp"
#include "tests/support/catch.hpp"

#include <vector>

using namespace meltpool;

namespace {

std::uint32_t number(const std::string& bytes, size_t from, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[from + static_cast<size_t>(i)]))
                 << (8 * i);
    return value;
}

} // namespace

TEST_CASE("a WAV file says its channels, rate, bits and length, and holds the samples", "[sound]") {
    const std::vector<std::int16_t> samples{0, 1, -1, 32767, -32768, 258};
    const std::string bytes = wavBytes(samples, 2, 48000);
    REQUIRE(bytes.size() == 44 + 12);
    CHECK(bytes.substr(0, 4) == "RIFF");
    CHECK(number(bytes, 4, 4) == bytes.size() - 8);
    CHECK(bytes.substr(8, 8) == "WAVEfmt ");
    CHECK(number(bytes, 16, 4) == 16);
    CHECK(number(bytes, 20, 2) == 1);
    CHECK(number(bytes, 22, 2) == 2);
    CHECK(number(bytes, 24, 4) == 48000);
    CHECK(number(bytes, 28, 4) == 192000);
    CHECK(number(bytes, 32, 2) == 4);
    CHECK(number(bytes, 34, 2) == 16);
    CHECK(bytes.substr(36, 4) == "data");
    CHECK(number(bytes, 40, 4) == 12);
    CHECK(number(bytes, 46, 2) == 1);
    CHECK(number(bytes, 48, 2) == 0xFFFF);
    CHECK(number(bytes, 54, 2) == 258);
}

TEST_CASE("a sample outside -1 to 1 is cut off", "[sound]") {
    CHECK(pcm16(0) == 0);
    CHECK(pcm16(1) == 32767);
    CHECK(pcm16(-1) == -32767);
    CHECK(pcm16(3) == 32767);
    CHECK(pcm16(-3) == -32767);
}
