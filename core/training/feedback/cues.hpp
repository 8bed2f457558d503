// Cues: what a trainee is shown beside the torch while welding, read from what technique measures by the lesson's
// bands.
#pragma once

#include "core/training/judging/score.hpp"
#include "core/weld/process/arc.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

/// What can be switched on and off.
enum class CueKind {
    speed,    ///< travel speed
    angles,   ///< work and travel angle
    distance, ///< contact tip to work distance or arc length
    aim,      ///< across the seam
    seam,     ///< the seam's next stretch
    arc,      ///< that the arc is out, and what to do
};
inline constexpr std::array<CueKind, 6> kCueKinds{CueKind::speed, CueKind::angles, CueKind::distance,
                                                  CueKind::aim,   CueKind::seam,   CueKind::arc};

/// The word for a kind in lessons, settings, scores and records: "speed", "angles" ...
std::string_view cueName(CueKind kind);
std::optional<CueKind> findCue(std::string_view name);

/// Some of the kinds.
class CueSet {
  public:
    static CueSet all();
    bool has(CueKind kind) const { return (bits_ & bit(kind)) != 0; }
    void set(CueKind kind, bool on = true) { bits_ = on ? bits_ | bit(kind) : bits_ & ~bit(kind); }
    bool empty() const { return bits_ == 0; }
    void add(CueSet other) { bits_ |= other.bits_; }
    bool operator==(const CueSet&) const = default;
    /// "speed aim", in the order of CueKind; empty for none.
    std::string names() const;

  private:
    static unsigned bit(CueKind kind) { return 1U << static_cast<unsigned>(kind); }
    unsigned bits_ = 0;
};

/// A quantity that has a cue.
struct CuedQuantity {
    TechniqueQuantity quantity;
    CueKind kind;
    std::string_view name; ///< in the file of best scores, whichever the process
};
std::span<const CuedQuantity> cuedQuantities();

/// How far a trainee has come with each cued quantity of a lesson, from which its cue fades. Feedback during a movement
/// guides strongly, and who always had it does poorly without it; less of it makes less dependent ("Reduced-Frequency
/// Concurrent and Terminal Feedback: A Test of the Guidance Hypothesis", J. Motor Behavior 2000). A ghost of fixed
/// strength gained more in practice, a fading one lost less in the test (TU Delft repository, ca94599c). So cues begin
/// at full strength, fade with each good attempt, and a test has none; a poor attempt brings a step back, as feedback
/// is also needed to keep a skill. No source gives the numbers.
class CueSkill {
  public:
    static constexpr int kMastered = 4;           ///< good attempts after which a cue is no longer shown
    static constexpr double kGood = 80;           ///< points of the quantity from which on an attempt is a good one
    static constexpr double kPoor = 60;           ///< points below which it is a poor one
    static constexpr double kLeastCoverage = 0.5; ///< of the wanted seam; a shorter weld tells nothing

    /// 0..kMastered: good attempts less poor ones.
    int good(TechniqueQuantity quantity) const { return good_[static_cast<size_t>(quantity)]; }
    /// Expects 0 <= good <= kMastered.
    void setGood(TechniqueQuantity quantity, int good) { good_[static_cast<size_t>(quantity)] = good; }

    /// With one more attempt; the same where that is not scored or too short.
    CueSkill after(const TechniqueScore& score) const;

    /// 1 full .. 0 gone.
    double strength(TechniqueQuantity quantity) const { return 1 - double(good(quantity)) / kMastered; }
    /// Of the angles the greater of both; the seam's stretch fades with the aim; that the arc is out does not fade, as
    /// no points measure it.
    double strength(CueKind kind) const;
    /// Of help that shows all at once, as a ghost does: that of the cued quantity which is mastered least among those
    /// that the lesson judges; 1 where it judges none. `bands` may be null.
    double strength(const TechniqueBands* bands) const;

    bool operator==(const CueSkill&) const = default;

  private:
    std::array<int, kTechniqueQuantities> good_{};
};

/// One thing that is shown.
struct Cue {
    CueKind kind = CueKind::speed;
    TechniqueQuantity quantity = TechniqueQuantity::aim; ///< of speed, angles, distance and aim
    double offset = 0;                                   ///< value less ideal, in the band's unit; positive is too much
    double share = 0;                                    ///< offset over the band's outer half width
    double inner = 0;                                    ///< the band's inner half width over its outer one
    BandZone zone = BandZone::inside;
    double opacity = 1; ///< 0..1

    /// Which way the value must go: 1 up, -1 down, 0 where it is good. Of `arc`: 1 away from the metal, -1 towards it,
    /// 0 neither.
    int correction() const { return zone == BandZone::inside || offset == 0 ? 0 : offset > 0 ? -1 : 1; }
};

/// At most one cue of each quantity, one of the seam and one of the arc.
class CueList {
  public:
    void add(const Cue& cue) { cues_[count_++] = cue; }
    std::span<const Cue> all() const { return {cues_.data(), count_}; }
    bool empty() const { return count_ == 0; }
    /// Null where there is none.
    const Cue* find(CueKind kind) const;
    const Cue* find(TechniqueQuantity quantity) const;

  private:
    std::array<Cue, 7> cues_;
    size_t count_ = 0;
};

/// Share of its opacity that a cue has while its value lies within the inner band: what is right stays quiet.
inline constexpr double kQuietCue = 0.6;

/// m; a torch without arc that is higher over the seam, or points farther beside it, is put aside: only the arc's cue
/// is left.
inline constexpr double kCueReach = 60e-3;

/// The direction of travel that cues are drawn for: the sensed one, before that the demanded one, else 0. `bands` may
/// be null.
int cueDirection(const Technique& technique, const TechniqueBands* bands);

/// The kinds of `shown` as they stand in the last step. A quantity has none where the lesson has no band for it or its
/// value is unknown, and no aim where the lesson asks for a weave; where the direction of travel is not sensed yet the
/// demanded one serves for the travel angle. The arc has one while it does not burn for a reason that the hand can
/// change. Nothing before the first step.
CueList liveCues(const Technique& technique, const ArcState& arc, const TechniqueBands* bands, CueSet shown,
                 const CueSkill& skill);

} // namespace meltpool
