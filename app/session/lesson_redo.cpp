// The part of LessonSession that goes back to an earlier moment of the attempt.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"

#include <cmath>

namespace meltpool {

/// An attempt for score is welded once, from its beginning to its end.
bool LessonSession::redoes() {
    return judges() && !sections_->attempt.forScore && !question_.asked() && fault_.empty() && redo_.can();
}

void LessonSession::redo(Controls& controls) {
    if (!redoes()) return;
    closeCut(controls);
    try {
        if (!redo_.back(*trainer_)) return;
    } catch (const std::exception& fault) { // the metal may be of neither moment
        fault_ = fault.what();
        event("fault", fault_);
        return;
    }
    controls.putOut(ArcOut::redone);
    const double place = trainer_->technique()->place();
    if (desk_.leads() && std::isfinite(place)) desk_.standAt(place);
    judge_.forget();
    surfaceDistance_ = {};
    surfaceIsOld_ = true;
    clock_.restart();
}

/// Keeps moments of an attempt that may go back, or that is recorded.
void LessonSession::beginMoments() {
    redo_.begin(recordings_.writer(), judges() && !sections_->attempt.forScore);
}

void LessonSession::keepMoment() {
    if (redo_.goes() || recordings_.current() != nullptr)
        redo_.update(*trainer_, clock_.speedOfSteps(trainer_->timeStep()));
}

} // namespace meltpool
