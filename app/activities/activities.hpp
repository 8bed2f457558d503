// The activities of a person, who is at one of them.
#pragma once

#include "app/activities/attempt.hpp"
#include "app/activities/attempt_comparison.hpp"
#include "app/activities/attempt_replay.hpp"
#include "app/activities/demonstration.hpp"
#include "app/activities/speed_trial.hpp"

namespace meltpool {

class Activities {
  public:
    Activities() = default;
    Activities(const Activities&) = delete;
    Activities& operator=(const Activities&) = delete;

    Attempt attempt;
    Demonstration demonstration;
    AttemptReplay replay;
    AttemptComparison comparison;
    SpeedTrial trial;

    Activity& current() { return *current_; }
    const Activity& current() const { return *current_; }
    Allowed allowed() const { return current_->allowed(); }
    /// The person is at this one.
    bool at(const Activity& activity) const { return current_ == &activity; }

    /// The person turns to one of these. It has begun itself.
    void turnTo(Activity& activity) { current_ = &activity; }
    /// Ends all of them: there is no metal any more, or soon.
    void end() {
        attempt.end();
        trial.stop();
        demonstration.end();
        replay.end();
        comparison.end();
        leave();
    }
    /// Back to the list of attempts. No-op where none are compared.
    void endComparison() {
        if (!at(comparison)) return;
        comparison.end();
        leave();
    }
    /// There is no metal while it is made for another activity.
    void leave() { current_ = &none_; }

  private:
    NoActivity none_;
    Activity* current_ = &none_;
};

} // namespace meltpool
