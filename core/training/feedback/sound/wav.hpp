// Writes sound files: RIFF WAVE with 16-bit samples.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace meltpool {

/// A sample of -1..1 as 16 bits; values beyond are clipped.
std::int16_t pcm16(float sample);

/// The bytes of a WAV file ("Multimedia Programming Interface and Data Specifications 1.0", IBM and Microsoft 1991,
/// format 1). `samples`: one of each of `channels` in turn; `rate`: samples a second of each channel. Throws InputError
/// for more than the format's 4 GiB.
std::string wavBytes(std::span<const std::int16_t> samples, int channels, int rate);

} // namespace meltpool
