// The measurement of this machine's speed before an attempt for score, and of cheaper values that keep the metal at the
// person's time.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/question.hpp"
#include "core/training/lesson/lesson.hpp"

#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// Values that make a lesson cheaper, and their measured speed.
struct SpeedOffer {
    std::string label; ///< "particle spacing 1.5 mm"; empty: the lesson with its current values
    std::vector<std::pair<std::string, std::string>> values;
    double ratio = 0; ///< simulated over real time
};

/// Speed trial. It runs the demonstration with all the program's work of a frame, for a second or two: first the lesson
/// with its current values, and if that is too slow one offer after the other until one keeps up.
class SpeedTrial final : public Activity {
  public:
    static constexpr double kSettling = 0.5;   ///< s of real time at the start that do not count
    static constexpr double kMeasuring = 1.25; ///< s of real time that count

    enum class Verdict { more, another, fastEnough, tooSlow };

    /// Blocks all input to the metal while it measures.
    Allowed allowed() const override;
    /// A trial given up by stop() can begin again.
    NextAttempt nextAttempt(bool) const override {
        return offers_.empty() ? NextAttempt::freshMetal : NextAttempt::none;
    }
    bool hurries() const override { return measuring(); }
    /// Makes the steps of the frame itself and counts them, see takeVerdict().
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame&, int, int) override {}
    void finish(ActivityFrame&) override {}

    /// Begins with the lesson's current values.
    void begin(const Lesson& lesson);
    /// Starts an offer whose metal was made: runs the demonstration from where it begins to heat.
    void beginOffer(const Lesson& lesson) { time_ = lesson.torch.firstPull().value_or(0); }
    /// Verdict of the last counted frame, once; `more` without one.
    Verdict takeVerdict() { return std::exchange(verdict_, Verdict::more); }
    void stop() { offers_.clear(); }
    /// True while offers remain to be measured; else it asks, or was stopped.
    bool measuring() const { return current_ < offers_.size(); }
    /// Offer to measure now.
    const SpeedOffer& current() const { return offers_[current_]; }

    /// Counts a frame. `another`: current() is another offer now, so its metal must be made.
    Verdict count(double real, double simulated);

    /// Drops the current offer, which does not fit the lesson; returns as count() does.
    Verdict skip();

    /// First offer at which the metal keeps up with the clock; null: none of those measured.
    const SpeedOffer* fitting() const;
    /// Question with the result: "start with it" if an offer is fitting(), then "practise", then "start menu".
    Question question() const;
    const std::vector<SpeedOffer>& offers() const { return offers_; }

  private:
    std::vector<SpeedOffer> offers_; ///< the first is the lesson with its current values
    size_t current_ = 0;
    double waited_ = 0, real_ = 0, simulated_ = 0;
    double time_ = 0; ///< s into the demonstration
    Verdict verdict_ = Verdict::more;
};

/// Values that make this lesson cheaper: fewer particles, a coarser surface, both.
std::vector<SpeedOffer> cheaperValues(const Lesson& lesson);

} // namespace meltpool
