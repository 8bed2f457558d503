// A kept attempt that is played again over its own metal, to the same bits: stepped, sought, and compared at its end.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/curve_track.hpp"
#include "app/activities/moments_of_attempt.hpp"
#include "app/activities/replay_end.hpp"
#include "app/activities/seek_pace.hpp"
#include "app/activities/timeline.hpp"
#include "app/activities/timeline_marks.hpp"
#include "core/gl/profiler.hpp"
#include "core/training/attempt/kept_moments.hpp"
#include "core/training/trainer/trainer.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// Works on the Trainer of a lesson that takeTorch() gave the attempt to; the same one from begin() to end().
class AttemptReplay final : public Activity {
  public:
    static constexpr double kSpacing = 0.5;            ///< s of the metal between two moments that are kept
    static constexpr size_t kRoom = size_t(384) << 20; ///< bytes, of the moments that are kept
    static constexpr double kSeekSlice = 0.45;         ///< s of a frame that a seek's steps may take

    /// At the start, playing. `now`: s of a clock that never goes back. Reads the recording's moments.
    void begin(const Trainer& trainer, ReplayMachine machine, double (*now)());
    void end();

    Allowed allowed() const override { return {.values = true}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::freshMetal; }
    bool hurries() const override { return line_.seeking(); }
    /// A seek is done here.
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame& frame, int step, int steps) override;
    void finish(ActivityFrame& frame) override;

    ReplayTimeline& line() { return line_; }
    const ReplayTimeline& line() const { return line_; }

    /// The next step of the attempt; none after its last. At the last one the metal is compared with the recording's,
    /// which waits for the GPU once.
    void step(Trainer& trainer, gl::Profiler* profiler);
    /// A frame's share of the way to the moment that was asked for; `seconds`: of the last frame. True when it is
    /// reached. Throws RuntimeFault.
    bool seek(Trainer& trainer, double seconds, gl::Profiler* profiler);
    /// At its first end: judges the attempt, so that its faults stand among marks(). True where it did, which waits for
    /// the GPU. Throws RuntimeFault.
    bool findFaults(const Trainer& trainer);
    /// Once a frame: takes what came from the GPU.
    void collect();

    /// What the comparison at the end found; nothing before it, and after going back.
    const std::optional<ReplayEnd>& comparison() const { return comparison_; }
    /// Changes, events, redos, and once it has been played to its end its faults.
    std::span<const TimelineMark> marks() const { return marks_; }
    /// Travel speed, mm/s, and distance of the torch, mm, while the arc burned.
    const CurveTrack& speed() const { return speed_; }
    const CurveTrack& distance() const { return distance_; }
    /// Moments that are kept, to go back to. May wait for one that is being packed.
    size_t moments() const { return moments_ ? moments_->count() : 0; }
    /// Those that the recording brought.
    size_t recordedMoments() const { return recorded_.moments ? recorded_.moments->count() : 0; }
    /// Why those of the recording are not used, as a sentence; empty where it has none or they are.
    const std::string& momentsRefused() const { return recorded_.refused; }

  private:
    bool isOver(const Trainer& trainer) const;
    void noteCurves(const Trainer& trainer);
    void keepMoment(const Trainer& trainer);
    void goBack(Trainer& trainer);
    void toStart(Trainer& trainer);
    void restoreRecorded(Trainer& trainer, double target);
    void compare(const Trainer& trainer);

    ReplayTimeline line_;
    std::optional<RecordedAttempt> attempt_; ///< nothing of a plain torch path
    ReplayMachine machine_;
    double (*now_)() = nullptr;
    std::vector<TimelineMark> marks_;
    bool faultsFound_ = false; ///< and among marks_
    CurveTrack speed_, distance_;
    std::optional<ReplayEnd> comparison_;
    SeekPace pace_{kSeekSlice};
    std::unique_ptr<KeptMoments> moments_; ///< between begin() and end()
    MomentsOfAttempt recorded_;            ///< the same from the file, however far they lie apart
};

} // namespace meltpool
