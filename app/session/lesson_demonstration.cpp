// The part of LessonSession that plays the lesson's demonstration.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"

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

void LessonSession::playDemonstration(double seconds, gl::Profiler* profiler) {
    try {
        if (demonstration_.takeMetalDue()) {
            trainer_->reset();
            clock_.restart();
            fault_.clear();
            surfaceIsOld_ = true;
        }
        if (!demonstration_.playing() || !fault_.empty()) {
            clock_.restart();
        } else if (demonstration_.welds()) {
            makeDueSteps(seconds, [&](int, int) {
                trainer_->advanceDemonstration(profiler);
                surfaceIsOld_ = true;
            });
            demonstration_.reach(trainer_->time());
        } else {
            demonstration_.reach(demonstration_.time() + seconds);
        }
        if (!demonstration_.welds()) trainer_->show(lesson_.torch.sample(demonstration_.time()));
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
    }
}

} // namespace meltpool
