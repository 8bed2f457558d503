// Notices changes around the torch between two frames: they put the arc out and go into the lesson's record.
#pragma once

#include "app/headset/headset_hands.hpp"
#include "app/session/lesson_session.hpp"
#include "xr/headset_connection.hpp"

#include <optional>

namespace meltpool {

class HeadsetChanges {
  public:
    /// Returns true if a lesson has begun, or begun again, since the last call.
    bool lessonBegan(const LessonSession& session);
    /// Returns true if the lesson did not run in the call before: a start, not a reset.
    bool lessonStarted() const { return started_; }
    /// Returns true if a lesson ran at the last call of lessonBegan().
    bool lessonRuns() const { return running_; }
    /// Compares the parameters with those of the last call; in the first frame of a lesson it writes all of them.
    void takeParameters(const HeadsetParameters& parameters, float zoom, HeadsetHands& hands, LessonSession& session);
    /// Notes that the workshop was moved to the person.
    void recentred(HeadsetHands& hands, LessonSession& session);
    /// Notes the headset's state in this frame.
    void takeConnection(bool inUse, HeadsetHands& hands, ArcOut reason, LessonSession& session);
    /// Notes the leader of the torch, its tracking and the lock of its trigger. Call once hands are read.
    void takeTorch(const HeadsetHands& hands, LessonSession& session);

  private:
    /// Values compared between frames.
    struct RecordedValues {
        float zoom = 1;
        float tableHeight = 0;
        int hand = 0;
        int table = 0;
    };

    std::optional<RecordedValues> shown_; ///< empty: all values are new to the record
    std::optional<TorchHolder> holder_;
    bool running_ = false;
    bool started_ = false;
    size_t steps_ = 0;
    bool inUse_ = false;
    bool seen_ = false;
    bool burning_ = false; ///< the trigger counted in the last frame
};

} // namespace meltpool
