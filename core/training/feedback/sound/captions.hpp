// Captions name the sounds in a few words, for a person who cannot hear them.
#pragma once

#include "core/training/feedback/sound/sound_state.hpp"

#include <string_view>

namespace meltpool {

/// Follows the steps as the synthesis does and names the most important sound. A caption stays long enough to be read.
class Captions {
  public:
    /// Seconds that a new sound must last before it is named, and that a caption stays after its sound.
    static constexpr double kPatience = 0.3;
    static constexpr double kStays = 0.8;

    void reset() { *this = {}; }
    void step(const SoundStep& step);

    /// "Short circuits, even"; empty in silence. Valid for the whole run.
    std::string_view text() const;

  private:
    /// The key of its sentence; empty in silence.
    std::string_view keyOf(const SoundStep& step) const;
    void followRate(const SoundStep& step);

    SoundState state_;
    std::string_view told_; ///< key of text()
    std::string_view next_;
    double since_ = 0; ///< s that `next_` has been unchanged
    double chips_ = 0; ///< s left for the caption of hammer strokes
    double ticks_ = 0; ///< s left for the caption of ticks
    // Recent rate of short circuits, 1/s: fading sums, and their weight.
    double mean_ = 0;
    double square_ = 0;
    double weight_ = 0;
};

} // namespace meltpool
