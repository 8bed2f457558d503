// Passes the steps of a running lesson to the thread that plays them, and to the caption.
#pragma once

#include "core/training/feedback/sound/captions.hpp"
#include "core/training/feedback/sound/sound_step.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace meltpool {

/// A queue of steps from the thread that makes them to the thread that plays them. Neither ever waits, and it allocates
/// nothing. One thread pushes and one pops.
class SoundFeed {
  public:
    static constexpr size_t kRoom = 64; ///< steps: 0.7 s of the longest ones

    /// Returns false and drops the step when the queue is full.
    bool push(const SoundStep& step);
    /// False if the queue is empty.
    bool pop(SoundStep& step);
    /// Steps in the queue; for the thread that pops.
    size_t waiting() const;

  private:
    std::array<SoundStep, kRoom> steps_;
    std::atomic<size_t> pushed_{0};
    std::atomic<size_t> popped_{0};
};

class SoundSteps {
  public:
    void hear(const SoundStep& step);
    /// Starts another lesson or attempt.
    void reset() { captions_.reset(); }
    /// Chips off the slag with the next step: `strokes` of the hammer.
    void chip(int strokes) { chips_ += strokes; }

    std::string_view caption() const { return captions_.text(); }
    SoundFeed& feed() { return feed_; }

  private:
    SoundFeed feed_;
    Captions captions_;
    int chips_ = 0;
};

} // namespace meltpool
