// Passes the steps of a running lesson to the thread that plays them, and to the caption.
#pragma once

#include "core/training/feedback/sound/captions.hpp"
#include "core/training/feedback/sound/sound_step.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace meltpool {

/// A queue of steps from the thread that makes them to the thread that plays them. Neither thread waits, and
/// nothing is allocated. One thread pushes and one pops.
class SoundFeed {
  public:
    static constexpr size_t kRoom = 64; ///< steps: 0.7 s of sound at the longest step

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

/// The queue and the captions of a lesson, for the thread that makes the steps.
class SoundSteps {
  public:
    /// Passes a step of the metal to the caption and the queue. A full queue drops it: the sound misses a moment.
    void hear(const SoundStep& step);
    /// Clears the caption for another lesson or attempt.
    void reset() { captions_.reset(); }
    /// Adds the sound of `strokes` of the chipping hammer to the next step.
    void chip(int strokes) { chips_ += strokes; }

    std::string_view caption() const { return captions_.text(); }
    SoundFeed& feed() { return feed_; }

  private:
    SoundFeed feed_;
    Captions captions_;
    int chips_ = 0;
};

} // namespace meltpool
