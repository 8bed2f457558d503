// The cues of the running attempt, for window and headset: which are switched on and shown, how they have faded, and
// which were shown while the arc burned.
#pragma once

#include "core/base/parameter.hpp"
#include "core/render/view.hpp"
#include "core/training/feedback/cue_shapes.hpp"
#include "core/training/trainer/trainer.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meltpool {

/// A person's switches, the same in every lesson.
struct CueParameters {
    bool speed = true;
    bool angles = true;
    bool distance = true;
    bool aim = true;
    bool seam = true;
    bool arc = true;
};
ParameterList describe(CueParameters& parameters);

/// Where one's own torch welds in the last step, drawn a little late behind `before` (null: none), so that a trembling
/// hand does not blur what stands beside it. `elapsed`: real seconds since then. Expects a step of a weld lesson.
CuePose followedPose(const CuePose* before, const Trainer& trainer, double elapsed);

/// Who looks at a scene, in the workpiece's frame.
CueEye cueEye(const SceneView& scene, const View& eye);

class AttemptCues {
  public:
    CueParameters parameters;

    /// Keys of the switches that do nothing in the lesson at hand; valid until the next open().
    std::span<const std::string_view> idle() const { return idle_; }

    /// Another lesson: nothing is known of the trainee's skill in it.
    void open(const Lesson& lesson);
    /// How far the trainee has come with this lesson before the next attempt.
    void setSkill(const CueSkill& skill) { skill_ = before_ = skill; }
    const CueSkill& skill() const { return skill_; }
    /// 0..1 of other help in this attempt that fades as the cues do; see CueSkill::strength().
    double strength(const TechniqueBands* bands) const { return before_.strength(bands); }

    /// An attempt begins.
    void begin();
    /// The attempt so far has this score. It counts once, as it was judged last; cues fade from the next attempt on.
    void practised(const TechniqueScore& score) { skill_ = before_.after(score); }

    /// Takes the last step of a frame. `test`: an attempt for score, which has no cues. `elapsed`: real seconds since
    /// the last call. Notes in the record which cues are on, where others are than before: `cues speed aim`. Allocates
    /// nothing while nothing changes.
    void update(Trainer& trainer, bool test, double elapsed);

    /// A cue of this kind is never shown in this attempt: switched off, not allowed by the lesson, or it is a test.
    bool withheld(CueKind kind) const { return !wanted_.has(kind); }
    /// Those that were on while the arc burned in this attempt.
    CueSet used() const { return used_; }

    /// The cues of the last step for this eye, in the scene's world; valid until the next call.
    std::span<const Marker> markers(const Trainer& trainer, const SceneView& scene, const View& eye);

  private:
    CueSet switchedOn() const;

    std::vector<std::string_view> idle_;
    CueSet allowed_ = CueSet::all(); ///< by the lesson
    CueSet wanted_ = CueSet::all();  ///< allowed and switched on; none in a test
    CueSet on_;                      ///< of them those that have not faded away
    CueSet used_;
    CueSkill skill_;
    CueSkill before_;             ///< before this attempt
    std::optional<CuePose> pose_; ///< follows the torch a little late, so that a trembling hand does not blur the cues
    CueShapes shapes_;
};

} // namespace meltpool
