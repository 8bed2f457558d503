#include "core/training/feedback/sound/wav.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr int kBytesPerSample = 2;
constexpr std::uint64_t kHead = 44;

/// Appends the lowest `count` bytes of `value`, lowest first.
void append(std::string& bytes, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>((value >> (8 * i)) & 0xFF);
}

} // namespace

std::int16_t pcm16(float sample) {
    return static_cast<std::int16_t>(std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767));
}

std::string wavBytes(std::span<const std::int16_t> samples, int channels, int rate) {
    const std::uint64_t data = samples.size() * kBytesPerSample;
    if (data + kHead > 0xFFFFFFFFULL)
        throw InputError("the sound is longer than a WAV file can hold; expected less than six hours");
    const auto frame = static_cast<std::uint64_t>(channels * kBytesPerSample);
    std::string bytes;
    bytes.reserve(data + kHead);
    bytes += "RIFF";
    append(bytes, data + kHead - 8, 4);
    bytes += "WAVEfmt ";
    append(bytes, 16, 4); // bytes from here up to "data"
    append(bytes, 1, 2);  // PCM
    append(bytes, static_cast<std::uint64_t>(channels), 2);
    append(bytes, static_cast<std::uint64_t>(rate), 4);
    append(bytes, static_cast<std::uint64_t>(rate) * frame, 4);
    append(bytes, frame, 2);
    append(bytes, 8 * kBytesPerSample, 2);
    bytes += "data";
    append(bytes, data, 4);
    for (const std::int16_t sample : samples)
        append(bytes, static_cast<std::uint16_t>(sample), kBytesPerSample);
    return bytes;
}

} // namespace meltpool
