// Chooses the cues shown next to the torch while welding, from the technique's measurements and the lesson's bands.
#pragma once

#include "core/training/judging/score.hpp"
#include "core/weld/process/arc.hpp"

#include <array>
#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

/// Kinds of cue, which can be switched on and off one by one.
enum class CueKind {
    speed,    ///< travel speed
    angles,   ///< work and travel angle
    distance, ///< contact tip to work distance or arc length
    aim,      ///< across the seam
    seam,     ///< the next stretch of the seam
    arc,      ///< the arc is out, and the remedy
};
inline constexpr std::array<CueKind, 6> kCueKinds{CueKind::speed, CueKind::angles, CueKind::distance,
                                                  CueKind::aim,   CueKind::seam,   CueKind::arc};

/// The word for a kind in lessons, settings, scores and records: "speed", "angles" ...
std::string_view cueName(CueKind kind);
std::optional<CueKind> findCue(std::string_view name);

/// A set of kinds.
class CueSet {
  public:
    static CueSet all();
    bool has(CueKind kind) const { return (bits_ & bit(kind)) != 0; }
    void set(CueKind kind, bool on = true) { bits_ = on ? bits_ | bit(kind) : bits_ & ~bit(kind); }
    bool empty() const { return bits_ == 0; }
    void add(CueSet other) { bits_ |= other.bits_; }
    bool operator==(const CueSet&) const = default;
    /// "speed aim", in the order of CueKind; empty for an empty set.
    std::string names() const;

  private:
    static unsigned bit(CueKind kind) { return 1U << static_cast<unsigned>(kind); }
    unsigned bits_ = 0;
};

/// A quantity that has a cue.
struct CuedQuantity {
    TechniqueQuantity quantity;
    CueKind kind;
    std::string_view name; ///< key in the file of best scores, equal for all processes
};
std::span<const CuedQuantity> cuedQuantities();

/// A trainee's progress with each cued quantity of a lesson, which fades its cue. Feedback during a movement guides
/// strongly, and a trainee who always had it does poorly without it; less of it makes less dependent
/// ("Reduced-Frequency Concurrent and Terminal Feedback: A Test of the Guidance Hypothesis", J. Motor Behavior 2000). A
/// ghost of fixed strength gained more in practice, a fading one lost less in the test (TU Delft repository, ca94599c).
/// So cues begin at full strength, fade with each good attempt, and a test has none; a poor attempt brings a step back,
/// as feedback is also needed to keep a skill. No source gives the numbers.
class CueSkill {
  public:
    static constexpr int kMastered = 4;           ///< good attempts until a cue is no longer shown
    static constexpr double kGood = 80;           ///< least points of the quantity in a good attempt
    static constexpr double kPoor = 60;           ///< an attempt with fewer points is a poor one
    static constexpr double kLeastCoverage = 0.5; ///< share of the wanted seam; a shorter weld does not count

    /// Good attempts minus poor ones, 0..kMastered.
    int good(TechniqueQuantity quantity) const { return good_[static_cast<size_t>(quantity)]; }
    /// Expects 0 <= good <= kMastered.
    void setGood(TechniqueQuantity quantity, int good) { good_[static_cast<size_t>(quantity)] = good; }

    /// Progress after one more attempt; unchanged if that is not scored or too short. The quantities that were `held`
    /// by the desk make no progress.
    CueSkill after(const TechniqueScore& score, const QuantitySet& held = {}) const;

    /// Opacity of the quantity's cue: 1 full .. 0 gone.
    double strength(TechniqueQuantity quantity) const { return 1 - double(good(quantity)) / kMastered; }
    /// Opacity of a kind: for the angles the greater of both; the seam's stretch fades with the aim; the cue that the
    /// arc is out does not fade, as no points measure it.
    double strength(CueKind kind) const;
    /// Strength of help that shows everything at once, such as a ghost: that of the least mastered cued quantity that
    /// the lesson judges; 1 if it judges none. `bands` may be null.
    double strength(const TechniqueBands* bands) const;

    bool operator==(const CueSkill&) const = default;

  private:
    std::array<int, kTechniqueQuantities> good_{};
};

/// A cue as shown.
struct Cue {
    CueKind kind = CueKind::speed;
    TechniqueQuantity quantity = TechniqueQuantity::aim; ///< quantity of a cue of speed, angles, distance or aim
    double offset = 0;                                   ///< value minus ideal, in the band's unit; positive is too
                                                         ///< much
    double share = 0;                                    ///< offset over the band's outer half width
    double inner = 0;                                    ///< the band's inner half width over its outer one
    BandZone zone = BandZone::inside;
    double opacity = 1; ///< 0..1

    /// Direction of the correction: 1 up, -1 down, 0 inside the band. For `arc`: 1 away from the metal, -1 towards it,
    /// 0 neither.
    int correction() const { return zone == BandZone::inside || offset == 0 ? 0 : offset > 0 ? -1 : 1; }
};

/// At most one cue of each quantity, one of the seam and one of the arc.
class CueList {
  public:
    void add(const Cue& cue) { cues_[count_++] = cue; }
    std::span<const Cue> all() const { return {cues_.data(), count_}; }
    bool empty() const { return count_ == 0; }
    /// Null if the list has none of this kind.
    const Cue* find(CueKind kind) const;
    const Cue* find(TechniqueQuantity quantity) const;

  private:
    std::array<Cue, 7> cues_;
    size_t count_ = 0;
};

/// Share of its opacity that a cue has inside the inner band: a correct value stays quiet.
inline constexpr double kQuietCue = 0.6;

/// m; a torch without arc that is higher above the seam, or points farther off it, counts as put aside: only the arc's
/// cue is left.
inline constexpr double kCueReach = 60e-3;

/// Direction of travel for the cues: the sensed one, before that the demanded one, else 0. `bands` may be null.
int cueDirection(const Technique& technique, const TechniqueBands* bands);

/// The cues of the kinds in `shown` after the last step. A quantity has none if the lesson has no band for it or its
/// value is unknown, and no aim if the lesson asks for a weave; an arc that does not burn yet has the way to the
/// metal in place of its length while that is longer than the lesson asks; until the direction of travel is sensed, the
/// travel angle uses the demanded one. The arc has a cue while it does not burn for a reason that the hand can change.
/// Empty before the first step.
CueList liveCues(const Technique& technique, const ArcState& arc, const TechniqueBands* bands, CueSet shown,
                 const CueSkill& skill);

} // namespace meltpool
