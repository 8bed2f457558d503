// Captions: what is heard, in a few words, for those who cannot hear it.
#pragma once

#include "core/training/feedback/sound/sound_state.hpp"

#include <string_view>

namespace meltpool {

/// Follows the steps as the synthesis does and names the most telling sound. A caption stays long enough to be read.
class Captions {
  public:
    /// s that another sound must last before it is named, and that a caption stays after its sound.
    static constexpr double kPatience = 0.3;
    static constexpr double kStays = 0.8;

    void reset() { *this = {}; }
    void step(const SoundStep& step);

    /// "Short circuits, even"; empty while nothing sounds. Stays valid for the whole run.
    std::string_view text() const;

  private:
    /// The key of its sentence; empty while nothing sounds.
    std::string_view keyOf(const SoundStep& step) const;
    void followRate(const SoundStep& step);

    SoundState state_;
    std::string_view told_; ///< key of text()
    std::string_view next_;
    double since_ = 0; ///< s that `next_` has been the one
    double chips_ = 0; ///< s since strokes of the hammer that are still told
    double ticks_ = 0; ///< the same of ticks
    // Of the short circuits' rate of late, 1/s: sums that fade, and the weight that they have.
    double mean_ = 0;
    double square_ = 0;
    double weight_ = 0;
};

} // namespace meltpool
