// The activities of a person, one of which is current.
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
    /// True if this activity is the current one.
    bool at(const Activity& activity) const { return current_ == &activity; }

    /// Makes an activity that has begun the current one.
    void turnTo(Activity& activity) { current_ = &activity; }
    /// Ends all of them, because the metal is gone or about to go.
    void end() {
        attempt.end();
        trial.stop();
        demonstration.end();
        replay.end();
        comparison.end();
        leave();
    }
    /// Returns to the list of attempts. No-op outside a comparison.
    void endComparison() {
        if (!at(comparison)) return;
        comparison.end();
        leave();
    }
    /// Leaves the current activity while the metal is made for another one.
    void leave() { current_ = &none_; }

  private:
    NoActivity none_;
    Activity* current_ = &none_;
};

} // namespace meltpool
