// Stores the sound of a whole run, for a file.
#pragma once

#include "core/training/feedback/sound/sound.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace meltpool {

class SoundTrack {
  public:
    /// Adds the sound of a step: some 96 kB a second.
    void add(const SoundStep& step);
    /// Samples so far, one channel of Sound::kRate.
    const std::vector<std::int16_t>& samples() const { return samples_; }
    /// Writes the samples as a WAV file. Throws as writeFile() does.
    void write(const std::filesystem::path& file) const;

  private:
    Sound sound_;
    std::vector<float> floats_;
    std::vector<std::int16_t> samples_;
};

} // namespace meltpool
