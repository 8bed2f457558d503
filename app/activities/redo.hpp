// The way back into the running attempt: an earlier checkpoint of its metal, from which it is welded again as practice.
// The person stays at that Attempt, which begins from a checkpoint: see Attempt::beginFromCheckpoint().
#pragma once

#include "core/training/attempt/checkpoint_ring.hpp"
#include "core/training/trainer/trainer.hpp"

#include <memory>
#include <optional>
#include <string>

namespace meltpool {

class Redo {
  public:
    /// s of the metal's time to go back if no fault was chosen.
    static constexpr double kBack = 3;
    /// s before a fault at which the attempt resumes, to get going again.
    static constexpr double kRunUp = 1;

    /// Starts another attempt, or none: drops all checkpoints. Some of the new ones go into `recording`, see
    /// CheckpointSchedule; null: there is none. `goes`: false if the attempt cannot go back.
    void begin(std::shared_ptr<RecordingWriter> recording = {}, bool goes = true);
    /// Begins a checkpoint when one is due and continues one in progress; call it after the steps of a frame. `speed`:
    /// of making steps alone, over the clock. Never waits, and allocates nothing.
    void update(const Trainer& trainer, double speed);

    /// Chooses the fault at this place (m along the seam) to go back before.
    void choose(double place) { place_ = place; }
    /// True if there is a checkpoint to go back to.
    bool can() { return goes_ && first_ && checkpoints_.count() > 0; }
    /// True if the attempt may go back at all.
    bool goes() const { return goes_; }
    /// Checkpoint before the chosen fault, or kBack ago; nothing if none is so early. Forgets the choice.
    std::optional<Checkpoint> target(const Trainer& trainer);
    /// Writes the checkpoints from the next one on into another recording.
    void recordInto(std::shared_ptr<RecordingWriter> recording);
    /// Takes the metal back to this checkpoint and notes it in the record. Waits for the GPU.
    void back(Trainer& trainer, const Checkpoint& moment);

    /// Count of times this attempt went back: it is practice from the first time on, and its score does not count.
    size_t redone() const { return redone_; }
    /// Sentence that says why there is no way back; empty while there is one.
    std::string fault() { return checkpoints_.fault(); }
    /// Memory of the checkpoints, bytes.
    size_t bytes() { return checkpoints_.bytes(); }

  private:
    CheckpointRing checkpoints_;
    bool goes_ = true;
    std::optional<double> place_;
    std::optional<double> first_; ///< s, time of the first checkpoint
    size_t redone_ = 0;
};

/// s of the metal's time at which the arc first came within half a millimetre of this place (m along the seam), or
/// nothing if it never burned there.
std::optional<double> firstTimeAt(const Technique& technique, double place);

} // namespace meltpool
