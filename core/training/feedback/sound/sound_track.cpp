#include "core/training/feedback/sound/sound_track.hpp"

#include "core/base/output_file.hpp"
#include "core/training/feedback/sound/wav.hpp"

namespace meltpool {

void SoundTrack::add(const SoundStep& step) {
    sound_.begin(step);
    floats_.resize(sound_.left());
    sound_.read(floats_);
    for (const float sample : floats_)
        samples_.push_back(pcm16(sample));
}

void SoundTrack::write(const std::filesystem::path& file) const {
    writeFile(file, wavBytes(samples_, 1, Sound::kRate));
}

} // namespace meltpool
