// The part of LessonSession that plays a kept attempt again.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"

#include <utility>

namespace meltpool {

void LessonSession::openReplay(Lesson attempt, Controls& controls) {
    prepare(controls);
    attempt.surface = lesson_.surface; // how it is shown is the viewer's choice
    trainer_ = std::make_unique<Trainer>(shaders_, std::move(attempt));
    hearing_.ear.reset();
    clock_.reset();
    fault_.clear();
    surfaceIsOld_ = true;
    replay_.begin(*trainer_, thisMachine(), now_);
}

double LessonSession::replaySpeed() const {
    return replay_.line().speed() * clock_.speed();
}

void LessonSession::playReplay(double seconds, gl::Profiler* profiler) {
    ReplayTimeline& line = replay_.line();
    trainer_->listen(line.seeking() ? nullptr : &hearing_.ear);
    if (!fault_.empty() || (!line.seeking() && !line.playing())) {
        clock_.restart();
        return replay_.collect();
    }
    try {
        if (line.seeking()) {
            surfaceIsOld_ |= replay_.seek(*trainer_, seconds, profiler);
            clock_.restart();
        } else {
            makeDueSteps(seconds * line.speed(), [&](int, int) { replay_.step(*trainer_, profiler); });
            surfaceIsOld_ = true;
        }
        if (replay_.findFaults(*trainer_)) clock_.restart();
        replay_.collect();
    } catch (const std::runtime_error& fault) { // also a state that is damaged
        fault_ = fault.what();
    }
}

} // namespace meltpool
