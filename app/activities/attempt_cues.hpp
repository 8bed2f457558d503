// The cues of the running attempt, for window and headset: which are on and shown, how they have faded, and which were
// shown while the arc burned.
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

/// Switches of a person, one set for all lessons.
struct CueParameters {
    bool speed = true;
    bool angles = true;
    bool distance = true;
    bool aim = true;
    bool seam = true;
    bool arc = true;
};
ParameterList describe(CueParameters& parameters);

/// Pose of one's own torch at the last step, drawn a little late behind `before` (null: none), so that a trembling hand
/// does not blur the cues. `elapsed`: s of real time since then. Expects a step of a weld lesson.
CuePose followedPose(const CuePose* before, const Trainer& trainer, double elapsed);

/// Eye that looks at a scene, in the workpiece's frame.
CueEye cueEye(const SceneView& scene, const View& eye);

/// Words at a field of the cues' board in the person's language.
CueWords cueWords(CueKind kind);

/// Names at the fields of the cues' board: none, or all while one of them is new to the person.
enum class CueNaming { none, whileNew };

class AttemptCues {
  public:
    CueParameters parameters;

    /// Keys of the switches without effect in this lesson; valid until the next open().
    std::span<const std::string_view> idle() const { return idle_; }

    /// Takes another lesson and clears the trainee's skill.
    void open(const Lesson& lesson);
    /// Sets the trainee's skill at this lesson before the next attempt.
    void setSkill(const CueSkill& skill) { skill_ = before_ = skill; }
    const CueSkill& skill() const { return skill_; }
    /// Strength 0..1 of other help in this attempt that fades as the cues do; see CueSkill::strength().
    double strength(const TechniqueBands* bands) const { return before_.strength(bands); }

    /// Begins an attempt.
    void begin();
    /// Sets the quantities that the desk has held by itself in this attempt, which are no skill of the trainee.
    void setHeldByDesk(const QuantitySet& held) { heldByDesk_ = held; }
    const QuantitySet& heldByDesk() const { return heldByDesk_; }
    /// Those of them that the lesson judges, as of the last burning arc.
    const QuantitySet& notedHeld() const { return notedHeld_; }
    /// The desk swings the torch: an aim cue would follow its swings.
    void setSwings(bool swings) { swings_ = swings; }
    /// Takes the score of the attempt so far. The last judgement counts, once; cues fade from the next attempt on.
    void practised(const TechniqueScore& score) { skill_ = before_.after(score, heldByDesk_); }
    /// Cues that are on but have faded away.
    CueSet faded() const { return faded_; }
    /// Shows faded cues at full strength in this attempt, or lets them fade again.
    void toggleFaded() { showsFaded_ = !showsFaded_; }
    bool showsFaded() const { return showsFaded_; }

    /// Takes the last step of a frame. `test`: an attempt for score, which has no cues. `elapsed`: s of real time since
    /// the last call. Notes in the record which cues are on, and which judged quantities the desk holds while the arc
    /// burns, when they change: `cues speed aim`, `desk_holds work_angle`. Allocates nothing while nothing changes.
    void update(Trainer& trainer, bool test, double elapsed);

    /// True if a cue of this kind never shows in this attempt: switched off, not allowed by the lesson, or withheld in
    /// a test.
    bool withheld(CueKind kind) const { return !wanted_.has(kind); }
    /// Cues that were on while the arc burned in this attempt.
    CueSet used() const { return used_; }

    /// Cues of the last step for this eye, in the scene's world; valid until the next call.
    std::span<const Marker> markers(const Trainer& trainer, const SceneView& scene, const View& eye, CueNaming naming);

    /// Number of the last of those markers that are the board beside the torch.
    size_t boardMarkers() const { return shapes_.boardMarkers(); }
    /// Fields of that board.
    std::span<const CueLabel> labels() const { return shapes_.labels(); }
    /// Side of that board; see CueShapes::boardSide().
    float boardSide() const { return pose_ && !on_.empty() ? shapes_.boardSide() : 0; }
    /// True if the person has made no progress with a kind yet: its field needs a name.
    bool isNew(CueKind kind) const { return before_.strength(kind) >= 1; }

  private:
    void noteHeld(Trainer& trainer);
    CueSet switchedOn() const;
    CueNames names() const;
    CueSkill shownSkill() const { return showsFaded_ ? CueSkill() : before_; }

    std::vector<std::string_view> idle_;
    CueSet allowed_ = CueSet::all(); ///< cues that the lesson allows
    CueSet wanted_ = CueSet::all();  ///< allowed and switched on; none in a test
    CueSet on_;                      ///< cues of wanted_ that have not faded away
    CueSet used_;
    CueSkill skill_;
    CueSkill before_;        ///< skill before this attempt
    bool swings_ = false;    ///< the desk swings the torch
    QuantitySet heldByDesk_; ///< in this attempt
    QuantitySet notedHeld_;  ///< of them, those in the record
    CueSet faded_;           ///< cues of wanted_ that the skill has taken away
    bool showsFaded_ = false;
    std::optional<CuePose> pose_; ///< pose that follows the torch a little late, see followedPose()
    std::optional<WeldedPlaces> welded_;
    CueShapes shapes_;
};

} // namespace meltpool
