// What the welder's hand does along the seam, measured in every step of the metal.
#pragma once

#include "core/base/short_text.hpp"
#include "core/training/judging/quantity.hpp"
#include "core/training/judging/seam.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace meltpool::gl {
class StateArchive;
}

namespace meltpool {

struct TechniqueSettings {
    DistanceKind distance = DistanceKind::ctwd;
    double speedWindow = 0.5; ///< s of metal time, over which the travel speed is the slope of place against time
};

/// m along the seam after each strike until the direction of travel is known.
inline constexpr double kDirectionSense = 3e-3;
/// m that the torch must come back from its farthest place until the direction counts as turned; a whip is shorter.
inline constexpr double kDirectionTurn = 8e-3;
/// s; the speed of a shorter stretch is unknown.
inline constexpr double kLeastSpeedSpan = 0.1;
/// s between two steps; in a longer gap samples were dropped.
inline constexpr double kLongestTechniqueStep = 0.1;

/// s of the metal's time that a frame may make good by guessing the way of the hand between two places.
inline constexpr double kLongestGuess = 0.25;

/// The value of an event `samples` whose frame makes good `seconds`: "dropped 0.2", and the seconds of such a value.
/// One without a time, as of older programs, stands for kLongestGuess.
ShortText droppedText(double seconds);
double droppedSeconds(std::string_view value);

/// m and m/s: a step along the seam that is longer than both allow is a jump, which ends a stretch as a gap does.
inline constexpr double kJump = 2e-3;
inline constexpr double kJumpSpeed = 0.2;

/// One step, SI units; what is unknown is NaN.
struct TechniqueStep {
    double time = 0;      ///< s of metal time
    double place = 0;     ///< m along the seam where the torch's axis meets it; goes on growing around a circle
    double aim = 0;       ///< m, of this step alone: with the weave
    double height = 0;    ///< m
    double distance = 0;  ///< m
    double workAngle = 0; ///< rad
    double lean = 0;      ///< rad, travel angle for a travel towards growing places
    double rodAngle = 0;  ///< rad
    double rodGap = 0;    ///< m along the rod from its tip to where the torch's axis meets the seam; negative beyond
    double current = 0;   ///< A, of the arc
    double voltage = 0;   ///< V, of the arc
    bool welds = false;   ///< the arc burns and the torch is tracked
    bool joined = false;  ///< welds, as did the step before, with no gap and no jump between
    bool known = true;    ///< false: what the hand did since the step before, under an arc, is a guess
};

/// Of a step in a saved state: eleven numbers, and two bytes for three times yes or no.
inline constexpr size_t kTechniqueStepBytes = 11 * sizeof(double) + 2;

/// Finds the direction of travel while places come in: +1 towards growing places, -1, or 0 while it is not known.
class DirectionSense {
  public:
    void reset() { *this = {}; }
    int add(double place);
    int direction() const { return direction_; }
    void transfer(gl::StateArchive& archive); ///< saves or restores it

  private:
    bool begun_ = false;
    int direction_ = 0;
    double low_ = 0, high_ = 0;
};

/// Slope of a line through points that come and go at its ends (least squares), in constant time for each.
class SlidingSlope {
  public:
    void add(double time, double value);
    void remove(double time, double value);
    /// Of the points in it; NaN with fewer than two moments.
    double slope() const;
    void transfer(gl::StateArchive& archive); ///< saves or restores it

  private:
    double count_ = 0, sumT_ = 0, sumV_ = 0, sumTT_ = 0, sumTV_ = 0;
};

/// While the arc burned: where the hand is not known.
struct TechniqueFaults {
    double arcSeconds = 0;  ///< that the arc burned
    double lostSeconds = 0; ///< that tracking was lost, from a moment when the arc burned
    size_t dropped = 0;     ///< samples of the torch, while the arc burned
};

class Technique {
  public:
    explicit Technique(const Seam& seam, const TechniqueSettings& settings = {});

    /// The next step, with torch and arc of that step; torch.time is the metal's time. Allocates nothing but the room
    /// for more steps. `tracked`: the torch's pose is measured, not kept from before.
    void add(const TorchSample& torch, const ArcState& arc, bool tracked = true);
    /// A sample of the torch went missing: the steps of the next `seconds` of the metal's time lie on a guessed way.
    void noteDropped(double seconds = kLongestGuess);
    /// Everything is forgotten but seam and settings.
    void reset();

    /// Saves or restores all but seam, settings and steps(), which come before it.
    void transfer(gl::StateArchive& archive);
    /// Saves the steps from number `from` to before `to`, each as kTechniqueStepBytes. Where they are restored those
    /// before `from` are kept, and must be there, and those from `to` on forgotten.
    void transferSteps(gl::StateArchive& archive, size_t from, size_t to);

    /// Of the last step, for cues: what the hand does at this moment. The speed is that of the last speedWindow
    /// seconds; the travel angle waits until the direction is known, and so the speed's sign; weave and whip are
    /// unknown here, and the aim is that of the step alone.
    const TechniqueValues& now() const { return now_; }
    /// m along the seam, of the last step.
    double place() const { return steps_.empty() ? 0 : steps_.back().place; }
    /// Of the stretch that is welded now: +1 towards growing places, -1, or 0 while it is not known.
    int direction() const { return sense_.direction(); }

    const std::vector<TechniqueStep>& steps() const { return steps_; }
    const TechniqueFaults& faults() const { return faults_; }
    const Seam& seam() const { return seam_; }
    const TechniqueSettings& settings() const { return settings_; }

  private:
    static constexpr double kNever = -1;

    TechniqueStep measure(const TorchSample& torch, const ArcState& arc) const;
    double continued(double place) const;
    bool noteFaults(double elapsed, bool burns, bool tracked);
    void updateNow();

    Seam seam_;
    TechniqueSettings settings_;
    std::vector<TechniqueStep> steps_;
    TechniqueValues now_;
    TechniqueFaults faults_;
    DirectionSense sense_;
    SlidingSlope slope_;
    size_t oldest_ = 0;         ///< step in slope_
    double guessedTo_ = kNever; ///< s, time of the last step on a guessed way
    double origin_ = 0;         ///< s, time that slope_ counts from
    bool burned_ = false;       ///< in the step before
    bool lost_ = false;         ///< tracking, since a moment when the arc burned
};

} // namespace meltpool
