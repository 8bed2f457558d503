// The way back into the running attempt: an earlier moment of its metal, from which it is welded again as practice.
// The person stays at that Attempt, which begins from a checkpoint: see Attempt::beginFromCheckpoint().
#pragma once

#include "core/training/attempt/kept_moments.hpp"
#include "core/training/trainer/trainer.hpp"

#include <memory>
#include <optional>
#include <string>

namespace meltpool {

class Redo {
  public:
    /// s of the metal's time that one goes back where no fault was chosen.
    static constexpr double kBack = 3;
    /// s that one comes to stand before a fault, to get going again.
    static constexpr double kRunUp = 1;

    /// Another attempt begins, or none: nothing is kept. Some of its moments go into `recording`, see CheckpointPace;
    /// null: there is none. `goes`: false where the attempt cannot go back.
    void begin(std::shared_ptr<RecordingWriter> recording = {}, bool goes = true);
    /// After the steps of a frame: begins to keep this moment where it is time to, and goes on with what is under way.
    /// `speed`: of making steps alone, over the clock. Never waits, and allocates nothing.
    void update(const Trainer& trainer, double speed);

    /// Chooses the fault at this place (m along the seam) to go back before.
    void choose(double place) { place_ = place; }
    /// There is an earlier moment to go back to.
    bool can() { return goes_ && first_ && moments_.count() > 0; }
    /// The attempt may go back at all.
    bool goes() const { return goes_; }
    /// Takes the metal back to before the chosen fault, or by kBack, and notes it in the record; false where nothing so
    /// early is kept. Waits for the GPU.
    bool back(Trainer& trainer);

    /// How often this attempt went back: it is practice from the first time on, and its score does not count.
    size_t redone() const { return redone_; }
    /// Why there is no way back, as a sentence; empty while there is.
    std::string fault() { return moments_.fault(); }
    /// Memory that it takes, bytes.
    size_t bytes() { return moments_.bytes(); }

  private:
    KeptMoments moments_;
    bool goes_ = true;
    std::optional<double> place_;
    std::optional<double> first_; ///< s, of the first moment
    size_t redone_ = 0;
};

/// s of the metal's time at which the arc first came to within half a millimetre of this place (m along the seam), or
/// nothing where it never burned there.
std::optional<double> firstTimeAt(const Technique& technique, double place);

} // namespace meltpool
