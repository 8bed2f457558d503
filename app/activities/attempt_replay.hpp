// The replay of a stored attempt over its own metal, to the identical bits: played, sought, and compared at its end.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/curve_track.hpp"
#include "app/activities/file_checkpoints.hpp"
#include "app/activities/replay_end.hpp"
#include "app/activities/seek_pace.hpp"
#include "app/activities/timeline.hpp"
#include "app/activities/timeline_marks.hpp"
#include "core/gl/profiler.hpp"
#include "core/training/attempt/checkpoint_ring.hpp"
#include "core/training/trainer/trainer.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// Replay of an attempt. Works on the Trainer of a lesson whose torch takeTorch() set; one and the same Trainer from
/// begin() to end().
class AttemptReplay final : public Activity {
  public:
    static constexpr double kSpacing = 0.5;            ///< s of the metal between two checkpoints
    static constexpr size_t kRoom = size_t(384) << 20; ///< bytes of memory for checkpoints
    static constexpr double kSeekSlice = 0.45;         ///< s of a frame that a seek's steps may take
    static constexpr double kBeforeArc = 1;            ///< s before the first arc at which it starts
    static constexpr double kLeastSkipped = 0.5;       ///< s; less is not skipped

    /// Starts playing, kBeforeArc before the first arc. `now`: s of a clock that never goes back. Reads the recording's
    /// checkpoints.
    void begin(const Trainer& trainer, ReplayMachine machine, double (*now)());
    void end();

    Allowed allowed() const override { return {.values = true}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::freshMetal; }
    bool hurries() const override { return line_.seeking(); }
    /// Does a seek's steps here; see Activity::due().
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame& frame, int step, int steps) override;
    void finish(ActivityFrame& frame) override;

    ReplayTimeline& line() { return line_; }
    const ReplayTimeline& line() const { return line_; }

    /// Makes the next step of the attempt; no-op after its last. At the last one the metal is compared with the
    /// recording's, which waits for the GPU once.
    void step(Trainer& trainer, gl::Profiler* profiler);
    /// Makes a frame's share of the steps to the requested time; `seconds`: of the last frame. True once it is reached.
    /// Throws RuntimeFault.
    bool seek(Trainer& trainer, double seconds, gl::Profiler* profiler);
    /// Judges the attempt at its first end, so that its faults are among marks(). Returns true if it did, which waits
    /// for the GPU. Throws RuntimeFault.
    bool findFaults(const Trainer& trainer);
    /// Takes data that arrived from the GPU; call it once a frame.
    void collect();

    /// Result of the comparison at the end; nothing before it, and after going back.
    const std::optional<ReplayEnd>& comparison() const { return comparison_; }
    /// Marks of changes, events and redos, and of faults once it has been played to its end.
    std::span<const TimelineMark> marks() const { return marks_; }
    /// Travel speed, mm/s, and distance of the torch, mm, while the arc burned.
    const CurveTrack& speed() const { return speed_; }
    const CurveTrack& distance() const { return distance_; }
    /// Count of checkpoints to go back to. May wait for one that is being packed.
    size_t moments() const { return moments_ ? moments_->count() : 0; }
    /// Count of the recording's checkpoints.
    size_t recordedMoments() const { return recorded_.moments ? recorded_.moments->count() : 0; }
    /// Sentence that says why the recording's checkpoints are not used; empty if it has none or they are.
    const std::string& momentsRefused() const { return recorded_.refused; }

  private:
    bool isOver(const Trainer& trainer) const;
    void noteCurves(const Trainer& trainer);
    void keepCheckpoint(const Trainer& trainer);
    void goBack(Trainer& trainer);
    void toStart(Trainer& trainer);
    void restoreRecorded(Trainer& trainer, double target);
    void compare(const Trainer& trainer);

    ReplayTimeline line_;
    std::optional<RecordedAttempt> attempt_; ///< nothing for a plain torch path
    ReplayMachine machine_;
    double (*now_)() = nullptr;
    std::vector<TimelineMark> marks_;
    bool faultsFound_ = false; ///< true: marks_ contains the faults
    CurveTrack speed_, distance_;
    std::optional<ReplayEnd> comparison_;
    SeekPace pace_{kSeekSlice};
    std::unique_ptr<CheckpointRing> moments_; ///< checkpoints taken between begin() and end()
    FileCheckpoints recorded_;                ///< checkpoints from the file, at any spacing
};

} // namespace meltpool
