// Measures the welder's hand along the seam in every step of the metal.
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
    double speedWindow = 0.5; ///< s of metal time; the travel speed is the slope of place against time over it
};

/// m along the seam after each strike, after which the direction of travel is known.
inline constexpr double kDirectionSense = 3e-3;
/// m back from the torch's farthest place that count as a turn of direction; a whip is shorter.
inline constexpr double kDirectionTurn = 8e-3;
/// s; the speed of a shorter stretch is unknown.
inline constexpr double kLeastSpeedSpan = 0.1;
/// s between two steps; in a longer gap samples were dropped.
inline constexpr double kLongestTechniqueStep = 0.1;

/// s of metal time in a frame that may be bridged by a guess of the hand's way between two places.
inline constexpr double kLongestGuess = 0.25;

/// The value of an event `samples` whose frame bridges `seconds`: "dropped 0.2", and the seconds of such a value. A
/// value without a time, from older programs, means kLongestGuess.
ShortText droppedText(double seconds);
double droppedSeconds(std::string_view value);

/// m and m/s: a step along the seam longer than both allow is a jump, which ends a stretch as a gap does.
inline constexpr double kJump = 2e-3;
inline constexpr double kJumpSpeed = 0.2;

/// One step, SI units; unknown values are NaN.
struct TechniqueStep {
    double time = 0;      ///< s of metal time
    double place = 0;     ///< m along the seam to the torch's axis; goes on growing around a circle
    double aim = 0;       ///< m, of this step alone, including the weave
    double height = 0;    ///< m
    double distance = 0;  ///< m
    double workAngle = 0; ///< rad
    double lean = 0;      ///< rad, travel angle for a travel towards growing places
    double rodAngle = 0;  ///< rad
    double rodGap = 0;    ///< m along the rod from its tip to the point where the torch's axis meets the seam; negative
                          ///< beyond
    double current = 0;   ///< A, of the arc
    double voltage = 0;   ///< V, of the arc
    bool welds = false;   ///< the arc burns and the torch is tracked
    bool joined = false;  ///< welds, as the step before did, with no gap and no jump between
    bool known = true;    ///< false: the hand's way since the step before, under an arc, is a guess
};

/// Bytes of a step in a saved state: eleven numbers and two bytes for three flags.
inline constexpr size_t kTechniqueStepBytes = 11 * sizeof(double) + 2;

/// Finds the direction of travel from the places: +1 towards growing places, -1, or 0 while unknown.
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

/// Slope of a line through points that come and go at its ends (least squares), in constant time for each point.
class SlidingSlope {
  public:
    void add(double time, double value);
    void remove(double time, double value);
    /// Slope of its points; NaN with fewer than two moments.
    double slope() const;
    void transfer(gl::StateArchive& archive); ///< saves or restores it

  private:
    double count_ = 0, sumT_ = 0, sumV_ = 0, sumTT_ = 0, sumTV_ = 0;
};

/// Times with the arc burning and the hand unknown.
struct TechniqueFaults {
    double arcSeconds = 0;  ///< arc time
    double lostSeconds = 0; ///< time without tracking, from a moment with the arc burning
    size_t dropped = 0;     ///< dropped samples of the torch while the arc burned
};

class Technique {
  public:
    explicit Technique(const Seam& seam, const TechniqueSettings& settings = {});

    /// Adds the next step, with torch and arc of that step; torch.time is the metal's time. Allocates only room for
    /// more steps. `tracked`: false if the torch's pose is an older one, not measured.
    void add(const TorchSample& torch, const ArcState& arc, bool tracked = true);
    /// Call it when a sample of the torch is missing: the steps of the next `seconds` of the metal's time are on a
    /// guessed way.
    void noteDropped(double seconds = kLongestGuess);
    /// Forgets everything except seam and settings.
    void reset();

    /// Saves or restores everything except seam, settings and steps(), which come before it.
    void transfer(gl::StateArchive& archive);
    /// Saves the steps from number `from` to before `to`, each as kTechniqueStepBytes. Restoring keeps the steps before
    /// `from`, which must be there, and forgets those from `to` on.
    void transferSteps(gl::StateArchive& archive, size_t from, size_t to);

    /// Values of the last step, for cues. The speed is that of the last speedWindow seconds; travel angle and the
    /// speed's sign are unknown until the direction is known; weave and whip are unknown here, and the aim is that of
    /// the step alone.
    const TechniqueValues& now() const { return now_; }
    /// Place of the last step, m along the seam.
    double place() const { return steps_.empty() ? 0 : steps_.back().place; }
    /// Direction of travel in the present stretch: +1 towards growing places, -1, or 0 while unknown.
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
    size_t oldest_ = 0;         ///< oldest step in slope_
    double guessedTo_ = kNever; ///< s, time of the last step on a guessed way
    double origin_ = 0;         ///< s, start of slope_'s times
    bool burned_ = false;       ///< state of the arc in the step before
    bool lost_ = false;         ///< tracking is lost, since a moment with the arc burning
};

} // namespace meltpool
