#include "app/sound/sound_stream.hpp"

#include "core/training/feedback/sound/wav.hpp"

#include <algorithm>
#include <array>

namespace meltpool {

bool SoundStream::takeStep() {
    if (!feed_.pop(step_)) return false;
    if (static_cast<double>(feed_.waiting()) * step_.seconds > kMost) {
        int chips = step_.chips;
        while (static_cast<double>(feed_.waiting()) * step_.seconds > kLeft && feed_.pop(step_))
            chips += step_.chips;
        step_.chips = chips;
    }
    return true;
}

void SoundStream::beginNext() {
    if (takeStep()) {
        waited_ = 0;
        sound_.begin(step_);
        return;
    }
    waited_ += kFill;
    SoundStep held = waited_ < kHeld ? step_ : SoundStep{};
    held.seconds = kFill;
    held.shortCount = 0;
    held.chips = 0;
    sound_.begin(held);
    withoutStep_ += sound_.left();
}

void SoundStream::fill(std::span<std::int16_t> out) {
    std::array<float, 256> samples{};
    for (size_t done = 0; done < out.size();) {
        if (sound_.left() == 0) beginNext();
        const size_t wanted = std::min(samples.size(), out.size() - done);
        const size_t made = sound_.read(std::span(samples).first(wanted));
        for (size_t i = 0; i < made; ++i)
            out[done + i] = pcm16(samples[i]);
        done += made;
    }
}

} // namespace meltpool
