// The interface of everything a person can be doing: weld, watch, compare, have the machine measured, or nothing yet.
#pragma once

#include "app/activities/step_clock.hpp"
#include "core/gl/profiler.hpp"
#include "core/training/trainer/trainer.hpp"

#include <functional>
#include <optional>

namespace meltpool {

/// Torch that the mouse does not lead: returns the sample for step `step` (from 0) of the `steps` of a frame.
using TorchSource = std::function<TorchSample(int step, int steps)>;

/// Seconds of a clock that never goes back; its zero has no meaning.
using Stopwatch = double (*)();

/// Rights of a person during an activity.
struct Allowed {
    bool ownTorch = false; ///< the torch in the picture is the person's, not that of an expert or a stored attempt
    bool values = false;   ///< menus and hands change the metal
    bool help = false;     ///< cues, ghost and notices about the hand are shown
    bool judging = false;  ///< the weld can be judged, cut open, and gone back in
    bool notes = false;    ///< events are written to the attempt's record
};

/// Consequence of the request for another attempt.
enum class NextAttempt {
    none,       ///< the attempt has to wait
    sameMetal,  ///< the metal is reset to its start
    freshMetal, ///< the metal is made from the start values
};

/// Frame as an activity sees it, from its begin to the end of its steps.
struct ActivityFrame {
    gl::ShaderLibrary& shaders; ///< for metal that the activity makes itself
    Trainer* trainer;           ///< the lesson's metal; null outside a lesson, see Activity::inLesson()
    StepClock& clock;
    SoundSteps& soundSteps;
    Stopwatch now;
    gl::Profiler* profiler;
    double seconds;       ///< s of real time since the last frame
    double beside;        ///< see StepClock::due()
    bool waits;           ///< true: the person looks around, has cut the weld open, or has a question to answer
    bool forScore;        ///< true: the lesson is set to attempts for score
    bool stopped;         ///< true: a fault stopped the simulation; an activity clears it to go on
    bool changed = false; ///< true: the metal changed other than by steps, and its surface is out of date
    TorchSource torch;    ///< torch of the person
};

/// Activity of a person. Each frame calls due(), and if that returns a number, step() so many times and then finish().
/// All of them may throw RuntimeFault.
class Activity {
  public:
    virtual ~Activity() = default;

    /// True if it runs over the lesson's metal, not on a page before the lesson.
    virtual bool inLesson() const { return true; }
    virtual Allowed allowed() const = 0;
    /// Consequence of a request for the next attempt. `forScore`: it is one for score.
    virtual NextAttempt nextAttempt(bool forScore) const = 0;
    /// True if steps take all the time they can get.
    virtual bool hurries() const { return false; }

    /// Number of steps to make in this frame; nothing if there are none to finish either.
    virtual std::optional<int> due(ActivityFrame& frame) = 0;
    /// Makes step `step` (from 0) of `steps`. May run on the thread of the metal's context.
    virtual void step(ActivityFrame& frame, int step, int steps) = 0;
    virtual void finish(ActivityFrame& frame) = 0;

  protected:
    Activity() = default;
    Activity(const Activity&) = default;
    Activity& operator=(const Activity&) = default;
};

/// Absence of metal: the person is on a page before the lesson.
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
