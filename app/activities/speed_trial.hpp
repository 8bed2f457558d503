// Measures, before an attempt for score, whether this machine keeps the metal at the person's time, and with which
// other values it would.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/question.hpp"
#include "core/training/lesson/lesson.hpp"

#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// Values that make a lesson cheaper, and what they were measured to give.
struct SpeedOffer {
    std::string label; ///< "particle spacing 1.5 mm"; empty: the lesson as it is set
    std::vector<std::pair<std::string, std::string>> values;
    double ratio = 0; ///< simulated over real time
};

/// The trial runs the demonstration with everything that the program does in a frame, for a second or two: first the
/// lesson as it is set, and where that is too slow each offer in turn.
class SpeedTrial final : public Activity {
  public:
    static constexpr double kSettling = 0.5;   ///< s of real time at the start that do not count
    static constexpr double kMeasuring = 1.25; ///< s of real time that count

    enum class Verdict { more, another, fastEnough, tooSlow };

    /// While it measures, nothing that a person does reaches the metal.
    Allowed allowed() const override;
    /// One that was given up, by stop(), can be begun again.
    NextAttempt nextAttempt(bool) const override {
        return offers_.empty() ? NextAttempt::freshMetal : NextAttempt::none;
    }
    bool hurries() const override { return measuring(); }
    /// Makes the steps of the frame itself and counts them, see takeVerdict().
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame&, int, int) override {}
    void finish(ActivityFrame&) override {}

    /// Begins with the lesson as it is set.
    void begin(const Lesson& lesson);
    /// The metal of current() was made: the demonstration is run from where it begins to heat.
    void beginOffer(const Lesson& lesson) { time_ = lesson.torch.firstPull().value_or(0); }
    /// Verdict of the frame that was counted last, once; `more` where none was.
    Verdict takeVerdict() { return std::exchange(verdict_, Verdict::more); }
    void stop() { offers_.clear(); }
    /// Offers are still to be measured; else it asks, or was stopped.
    bool measuring() const { return current_ < offers_.size(); }
    /// What is to be measured now.
    const SpeedOffer& current() const { return offers_[current_]; }

    /// Counts a frame. `another`: current() is another offer now, so the metal must be made anew.
    Verdict count(double real, double simulated);

    /// Drops the current offer, which the lesson cannot be made with; answers as count().
    Verdict skip();

    /// What was found, as a question: an answer for each offer in their order, then "practise", then "start menu".
    Question question() const;
    /// Those of the answers.
    const std::vector<SpeedOffer>& offers() const { return offers_; }

  private:
    std::vector<SpeedOffer> offers_; ///< the first is the lesson as it is set
    size_t current_ = 0;
    double waited_ = 0, real_ = 0, simulated_ = 0;
    double time_ = 0; ///< s in the demonstration
    Verdict verdict_ = Verdict::more;
};

/// What could make this lesson cheaper: fewer particles, a coarser surface, both.
std::vector<SpeedOffer> cheaperValues(const Lesson& lesson);

} // namespace meltpool
