// The part of LessonSession that plays a kept attempt again.
#include "app/session/lesson_session.hpp"

#include <utility>

namespace meltpool {

void LessonSession::openReplay(Lesson attempt, Controls& controls) {
    prepare(controls);
    attempt.surface = lesson_.surface; // how it is shown is the viewer's choice
    trainer_ = std::make_unique<Trainer>(shaders_, std::move(attempt), metalThere_);
    hearing_.ear.reset();
    clock_.reset();
    fault_.clear();
    surfaceIsOld_ = true;
    replay_.begin(*trainer_, thisMachine(), now_);
}

double LessonSession::replaySpeed() const {
    return replay_.line().speed() * clock_.speed();
}

/// A seek is done here: it takes all the time that it can get.
bool LessonSession::beginReplay(double seconds, gl::Profiler* profiler) {
    ReplayTimeline& line = replay_.line();
    trainer_->listen(line.seeking() ? nullptr : &hearing_.ear);
    if (!fault_.empty() || (!line.seeking() && !line.playing())) {
        clock_.restart();
        replay_.collect();
        return false;
    }
    if (!line.seeking()) {
        steps_.due = clock_.due(seconds * line.speed(), trainer_->timeStep(), beside_);
        return true;
    }
    guarded([&] {
        surfaceIsOld_ |= replay_.seek(*trainer_, seconds, profiler);
        clock_.restart();
        finishReplay();
    });
    return false;
}

void LessonSession::finishReplay() {
    if (replay_.findFaults(*trainer_)) clock_.restart();
    replay_.collect();
}

} // namespace meltpool
