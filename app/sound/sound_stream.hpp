// Turns the steps of a lesson into blocks of samples for a device, whether the metal keeps up with the clock or not.
#pragma once

#include "core/training/feedback/sound/ear.hpp"
#include "core/training/feedback/sound/sound.hpp"

#include <cstdint>
#include <span>

namespace meltpool {

/// Steps come in frames, so they wait a little before they are played. Where none has come the last one lasts on, its
/// short circuits left out; after kHeld the lesson stands still and is silent. Steps that have piled up are left out.
/// Allocates nothing.
class SoundStream {
  public:
    static constexpr double kHeld = 0.25;  ///< s that the last step lasts on
    static constexpr double kMost = 0.15;  ///< s of steps that may wait
    static constexpr double kLeft = 0.04;  ///< s of them that are kept where more have piled up
    static constexpr double kFill = 0.005; ///< s that are made at once where no step has come

    explicit SoundStream(SoundFeed& feed) : feed_(feed) {}
    /// Fills `out` with the next samples of one channel.
    void fill(std::span<std::int16_t> out);
    /// Samples that were made without a step of the lesson, since the start.
    std::uint64_t withoutStep() const { return withoutStep_; }
    const SoundState& state() const { return sound_.state(); }

  private:
    void beginNext();
    bool takeStep();

    SoundFeed& feed_;
    Sound sound_;
    SoundStep step_;
    double waited_ = 0; ///< s since the last step ended
    std::uint64_t withoutStep_ = 0;
};

} // namespace meltpool
