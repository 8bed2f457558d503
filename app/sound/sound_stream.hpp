// The conversion of a lesson's steps into blocks of samples for a device, at any speed of the metal.
#pragma once

#include "core/training/feedback/sound/sound.hpp"
#include "core/training/feedback/sound/sound_steps.hpp"

#include <cstdint>
#include <span>

namespace meltpool {

/// Stream of samples. Steps come in frames, so they wait a little before they are played. On underrun the last step is
/// held without its short circuits; after kHeld the lesson counts as stopped and is silent. Steps beyond kMost are
/// dropped. Allocates nothing.
class SoundStream {
  public:
    static constexpr double kHeld = 0.25;  ///< s for which the last step is held
    static constexpr double kMost = 0.15;  ///< s of steps that may wait
    static constexpr double kLeft = 0.04;  ///< s of steps left after dropping
    static constexpr double kFill = 0.005; ///< s made at once on underrun

    explicit SoundStream(SoundFeed& feed) : feed_(feed) {}
    /// Fills `out` with the next samples of one channel.
    void fill(std::span<std::int16_t> out);
    /// Count of samples made on underrun since the start.
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
