// The ghost is another person's torch path next to one's own torch, paced by place on the seam or by time, with the
// hand's deviation from it. It is only shown: metal, arc and score do not depend on it.
#pragma once

#include "core/training/judging/technique.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meltpool {

/// Pace of the ghost.
enum class GhostPace {
    place, ///< the ghost is at one's own torch's place along the seam
    time,  ///< the ghost follows its own times, from the moment one's own arc first burned
};

/// The ghost at one moment, SI units; unknown values are NaN.
struct GhostMoment {
    TorchSample torch;      ///< pose in the path; its time is the path's
    double place = 0;       ///< m along the seam
    double height = 0;      ///< m of the tip above the seam
    double speed = 0;       ///< m/s along the seam, in its direction of travel
    double workAngle = 0;   ///< rad
    double travelAngle = 0; ///< rad, in its direction of travel
};

/// A torch path along a seam, measured as Technique measures a hand. A path does not record an arc, so its arc counts
/// as burning while the trigger is pulled.
class GhostPath {
  public:
    /// Period of the measured moments, s; longer for a path of more than kMostMoments of them.
    static constexpr double kGrain = 0.01;
    static constexpr double kMostMoments = 100000;

    /// An empty path: no ghost.
    GhostPath() = default;
    /// Takes time in proportion to the path's duration: some milliseconds a minute.
    GhostPath(const TorchPath& torch, const Seam& seam, const TechniqueSettings& settings = {});

    /// True if the path never welds: there is no ghost to show.
    bool empty() const { return moments_.empty(); }
    /// Direction of travel: +1 towards growing places, -1, or 0 without travel.
    int direction() const { return direction_; }
    /// Seconds from its first pull of the trigger to its last.
    double duration() const { return empty() ? 0 : moments_.back().time - moments_.front().time; }

    /// The ghost when it first reached this place (m along the seam): strokes back and further passes are left out.
    /// Empty before its start, beyond its farthest place, and in a gap without an arc. Around a closed seam places
    /// repeat after each turn. Allocates nothing.
    std::optional<GhostMoment> atPlace(double place) const;

    /// The ghost so many s after its first pull of the trigger; before that its pose at the first pull. Empty after its
    /// last release. Allocates nothing.
    std::optional<GhostMoment> atTime(double seconds) const;

  private:
    struct Moment {
        double time = 0, place = 0, height = 0, speed = 0, workAngle = 0, lean = 0;
        bool joined = false; ///< true: the arc burned from the moment before on
    };
    struct Reach {
        double way = 0; ///< m, place in the direction of travel
        double time = 0;
        bool joined = false; ///< true: the arc burned from the reach before on
    };

    void addReach(const Moment* before, const Moment& moment);
    std::optional<GhostMoment> atWay(double way) const;
    GhostMoment momentAt(double time) const;

    TorchPath torch_;
    std::vector<Moment> moments_; ///< moments with the arc burning, in ascending times
    std::vector<Reach> reached_;  ///< sorted by way, ascending
    int direction_ = 0;
    double turn_ = 0; ///< m, length of a closed seam; 0: open
};

/// One's own hand minus the ghost, SI units; unknown values are NaN.
struct GhostDelta {
    double speed = 0;       ///< m/s; positive: the hand travels faster
    double workAngle = 0;   ///< rad
    double travelAngle = 0; ///< rad; positive: the hand pushes more
    double ahead = 0;       ///< m along the seam, in the ghost's direction of travel
};

/// Difference at the hand's last step. `direction`: the hand's direction of travel, see cueDirection(); 0: its travel
/// angle is unknown. Expects `hand` to have a step.
GhostDelta ghostDelta(const Technique& hand, int direction, const GhostMoment& moment, const GhostPath& ghost);

/// Differences in words, a line each: "1.2 mm/s faster", "work angle 4° less". A difference that rounds to zero has no
/// line. Holds its text itself.
class GhostWords {
  public:
    GhostWords() = default;
    /// The lead of the hand is written for GhostPace::time alone: by place it is zero.
    GhostWords(const GhostDelta& delta, GhostPace pace);

    size_t lines() const { return count_; }
    std::string_view line(size_t i) const { return {lines_[i].text.data(), lines_[i].length}; }

  private:
    struct Line {
        std::array<char, 80> text{};
        size_t length = 0;
        Line& operator+=(std::string_view piece); ///< truncates at the line's size
    };
    void add(std::string_view key, double amount, int digits);

    std::array<Line, 4> lines_;
    size_t count_ = 0;
};

} // namespace meltpool
