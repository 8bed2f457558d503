// What changes around the torch between two frames: it puts the arc out and is written into the lesson's record.
#pragma once

#include "app/headset/headset_hands.hpp"
#include "app/session/lesson_session.hpp"
#include "xr/headset_connection.hpp"

#include <optional>

namespace meltpool {

class HeadsetChanges {
  public:
    /// Looks whether a lesson has begun, or begun again, since the last call.
    bool lessonBegan(const LessonSession& session);
    /// It had not run in the call before: a start, no reset.
    bool lessonStarted() const { return started_; }
    /// A lesson ran at that call.
    bool lessonRuns() const { return running_; }
    /// Compares the parameters with those of the last call; in the first frame of a lesson all of them are written.
    void takeParameters(const HeadsetParameters& parameters, float zoom, HeadsetHands& hands, LessonSession& session);
    /// The workshop was brought before the person.
    void recentred(HeadsetHands& hands, LessonSession& session);
    /// The headset's state in this frame.
    void takeConnection(bool inUse, HeadsetHands& hands, ArcOut reason, LessonSession& session);
    /// Who leads the torch, whether it is seen and whether its trigger is locked, once hands are read.
    void takeTorch(const HeadsetHands& hands, LessonSession& session);

  private:
    /// What is compared.
    struct Shown {
        float zoom = 1;
        float tableHeight = 0;
        int hand = 0;
        int posture = 0;
    };

    std::optional<Shown> shown_; ///< nothing: all of it is new to the record
    std::optional<TorchHolder> holder_;
    bool running_ = false;
    bool started_ = false;
    size_t steps_ = 0;
    bool inUse_ = false;
    bool seen_ = false;
    bool burning_ = false; ///< the trigger counted in the last frame
};

} // namespace meltpool
