// The ghost: another's torch path beside one's own torch, paced by place on the seam or by time, and how far one's own
// hand is off it. It is only shown: neither metal nor arc nor score know of it.
#pragma once

#include "core/training/judging/technique.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meltpool {

/// What brings the ghost on.
enum class GhostPace {
    place, ///< it stands where one's own torch is along the seam
    time,  ///< it goes its own way from the moment when one's own arc first burned
};

/// The ghost at one moment, SI units; what is unknown is NaN.
struct GhostMoment {
    TorchSample torch;      ///< as its path has it then; its time is the path's
    double place = 0;       ///< m along the seam
    double height = 0;      ///< m of the tip over the seam
    double speed = 0;       ///< m/s along the seam, the way that it travels
    double workAngle = 0;   ///< rad
    double travelAngle = 0; ///< rad, the way that it travels
};

/// A torch path as it is led along a seam. What it does there is measured as Technique measures a hand; since a path
/// knows no arc, its arc counts as burning while the trigger is pulled.
class GhostPath {
  public:
    /// s between the moments at which a path is looked at, more where it is longer than kMostMoments of them.
    static constexpr double kGrain = 0.01;
    static constexpr double kMostMoments = 100000;

    /// No ghost.
    GhostPath() = default;
    /// Takes time in proportion to the path's duration: some milliseconds a minute.
    GhostPath(const TorchPath& torch, const Seam& seam, const TechniqueSettings& settings = {});

    /// It never welds, so there is nothing to show.
    bool empty() const { return moments_.empty(); }
    /// +1 towards growing places, -1, or 0 where it does not travel.
    int direction() const { return direction_; }
    /// s from its first pull of the trigger to its last.
    double duration() const { return empty() ? 0 : moments_.back().time - moments_.front().time; }

    /// How it stood when it first came to this place (m along the seam): strokes back and further passes are left out.
    /// Nothing before the place where it began to weld and beyond the farthest that it reached, nor where it went on
    /// without an arc. Around a closed seam places repeat after each turn. Allocates nothing.
    std::optional<GhostMoment> atPlace(double place) const;

    /// How it stood so many s after it first pulled the trigger; before that as it stood then. Nothing once it had let
    /// go for the last time. Allocates nothing.
    std::optional<GhostMoment> atTime(double seconds) const;

  private:
    struct Moment {
        double time = 0, place = 0, height = 0, speed = 0, workAngle = 0, lean = 0;
        bool joined = false; ///< it welded on from the moment before
    };
    struct Reach {
        double way = 0; ///< m, place the way that it travels
        double time = 0;
        bool joined = false; ///< it welded on from the reach before
    };

    void addReach(const Moment* before, const Moment& moment);
    std::optional<GhostMoment> atWay(double way) const;
    GhostMoment momentAt(double time) const;

    TorchPath torch_;
    std::vector<Moment> moments_; ///< at which it welded, in ascending times
    std::vector<Reach> reached_;  ///< in ascending ways
    int direction_ = 0;
    double turn_ = 0; ///< m, length of a closed seam; 0: open
};

/// One's own hand less the ghost, SI units; what is unknown is NaN.
struct GhostDelta {
    double speed = 0;       ///< m/s; positive: the hand travels faster
    double workAngle = 0;   ///< rad
    double travelAngle = 0; ///< rad; positive: the hand pushes more
    double ahead = 0;       ///< m along the seam, the way that the ghost travels
};

/// Of the hand's last step. `direction`: that the hand travels to, see cueDirection(); 0: its travel angle is unknown.
/// Expects `hand` to have a step.
GhostDelta ghostDelta(const Technique& hand, int direction, const GhostMoment& moment, const GhostPath& ghost);

/// Differences in words, a line each: "1.2 mm/s faster", "work angle 4° less". What rounds to nothing has no line.
/// Holds its text itself.
class GhostWords {
  public:
    GhostWords() = default;
    /// How far the hand is ahead is told by time only: by place it is nothing.
    GhostWords(const GhostDelta& delta, GhostPace pace);

    size_t lines() const { return count_; }
    std::string_view line(size_t i) const { return {lines_[i].text.data(), lines_[i].length}; }

  private:
    struct Line {
        std::array<char, 80> text{};
        size_t length = 0;
        Line& operator+=(std::string_view piece); ///< cuts what does not fit
    };
    void add(std::string_view key, double amount, int digits);

    std::array<Line, 4> lines_;
    size_t count_ = 0;
};

} // namespace meltpool
