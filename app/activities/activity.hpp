// The interface of all that a person can be doing: weld, watch, compare, have the machine measured, or nothing yet.
#pragma once

#include "app/activities/step_clock.hpp"
#include "core/gl/profiler.hpp"
#include "core/training/trainer/trainer.hpp"

#include <functional>
#include <optional>

namespace meltpool {

/// A torch that the mouse does not lead: answers the sample for step `step` (from 0) of the `steps` of a frame.
using TorchSource = std::function<TorchSample(int step, int steps)>;

/// Seconds of a clock that never goes back; its zero means nothing.
using Stopwatch = double (*)();

/// Rights of a person during an activity.
struct Allowed {
    bool ownTorch = false; ///< the torch in the picture is the person's, not that of an expert or a kept attempt
    bool values = false;   ///< menus and hands act on the metal
    bool help = false;     ///< cues, ghost and notices about the hand are shown
    bool judging = false;  ///< the weld is judged, cut open, and gone back in
    bool notes = false;    ///< events go into the attempt's record
};

/// Consequence of the wish for another attempt.
enum class NextAttempt {
    none,       ///< it has to wait
    sameMetal,  ///< the metal is put back to its start
    freshMetal, ///< the metal is made from the start values
};

/// A frame as an activity sees it, from its begin to the end of its steps.
struct ActivityFrame {
    gl::ShaderLibrary& shaders; ///< of metal that the activity makes itself
    Trainer* trainer;           ///< the lesson's metal; null outside a lesson, see Activity::inLesson()
    StepClock& clock;
    Ear& ear;
    Stopwatch now;
    gl::Profiler* profiler;
    double seconds;       ///< real time since the last frame
    double beside;        ///< see StepClock::due()
    bool waits;           ///< the person looks around, has cut the weld open, or is asked something
    bool forScore;        ///< the lesson is set to attempts for score
    bool stopped;         ///< by a fault; an activity clears it to go on
    bool changed = false; ///< the metal was changed besides steps: its surface is out of date
    TorchSource torch;    ///< of the person's torch
};

/// Each frame calls due(), and where that answers a number, step() so many times and then finish(). All of them may
/// throw RuntimeFault.
class Activity {
  public:
    virtual ~Activity() = default;

    /// It goes on over the lesson's metal, not on a page before the lesson.
    virtual bool inLesson() const { return true; }
    virtual Allowed allowed() const = 0;
    /// `forScore`: the next attempt is one for score.
    virtual NextAttempt nextAttempt(bool forScore) const = 0;
    /// Steps take all the time that they can get.
    virtual bool hurries() const { return false; }

    /// Number of steps to be made in this frame; nothing where there are none to be finished either.
    virtual std::optional<int> due(ActivityFrame& frame) = 0;
    /// Makes step `step` (from 0) of `steps`. May run on the thread of the metal's context.
    virtual void step(ActivityFrame& frame, int step, int steps) = 0;
    virtual void finish(ActivityFrame& frame) = 0;

  protected:
    Activity() = default;
    Activity(const Activity&) = default;
    Activity& operator=(const Activity&) = default;
};

/// There is no metal: the person is on a page before the lesson.
class NoActivity final : public Activity {
  public:
    bool inLesson() const override { return false; }
    Allowed allowed() const override { return {}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::none; }
    std::optional<int> due(ActivityFrame&) override { return std::nullopt; }
    void step(ActivityFrame&, int, int) override {}
    void finish(ActivityFrame&) override {}
};

} // namespace meltpool
