// The part of LessonSession that plays the lesson's demonstration.
#include "app/session/lesson_session.hpp"

#include <algorithm>

namespace meltpool {

namespace {

bool sameSettings(ProcessSettings a, ProcessSettings b) {
    const ParameterList first = describe(a), second = describe(b);
    return a.kind == b.kind && std::equal(first.begin(), first.end(), second.begin(), second.end(), sameValue);
}

} // namespace

void LessonSession::demonstrate(Controls& controls) {
    if (!hasDemonstration()) return;
    prepare(controls);
    makeTrainer(lesson_.choose.empty() || sameSettings(lesson_.process, given_) ? nullptr : &given_);
    fault_.clear();
    surfaceIsOld_ = true;
    demonstration_.begin(lesson_.torch.duration());
}

/// The metal is welded only where the demonstration asks for it; else the torch alone moves.
bool LessonSession::beginDemonstration(double seconds) {
    guarded([&] {
        if (!demonstration_.takeMetalDue()) return;
        trainer_->reset();
        clock_.restart();
        fault_.clear();
        surfaceIsOld_ = true;
    });
    const bool plays = demonstration_.playing() && fault_.empty();
    if (!plays) clock_.restart();
    if (plays && demonstration_.welds()) {
        steps_.due = clock_.due(seconds, trainer_->timeStep(), beside_);
        return true;
    }
    if (plays) demonstration_.reach(demonstration_.time() + seconds);
    if (!demonstration_.welds()) trainer_->show(lesson_.torch.sample(demonstration_.time()));
    return false;
}

} // namespace meltpool
