// What a lesson in progress gives to whoever listens: its steps for the thread that plays them, and the caption.
#pragma once

#include "core/training/feedback/sound/captions.hpp"
#include "core/training/feedback/sound/sound_step.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace meltpool {

/// Steps on their way from the thread that makes them to the one that plays them. Neither ever waits, and nothing is
/// allocated. One thread pushes and one pops.
class SoundFeed {
  public:
    static constexpr size_t kRoom = 64; ///< steps: 0.7 s of the longest

    /// False, and the step is not heard, where nobody has popped for long.
    bool push(const SoundStep& step);
    /// False where there is none.
    bool pop(SoundStep& step);
    /// Steps that wait; for the thread that pops.
    size_t waiting() const;

  private:
    std::array<SoundStep, kRoom> steps_;
    std::atomic<size_t> pushed_{0};
    std::atomic<size_t> popped_{0};
};

class Ear {
  public:
    void hear(const SoundStep& step);
    /// Another lesson or attempt.
    void reset() { captions_.reset(); }
    /// The slag is chipped off with the next step: `strokes` of the hammer.
    void chip(int strokes) { chips_ += strokes; }

    std::string_view caption() const { return captions_.text(); }
    SoundFeed& feed() { return feed_; }

  private:
    SoundFeed feed_;
    Captions captions_;
    int chips_ = 0;
};

} // namespace meltpool
