#include "app/session/lesson_run.hpp"

#include <stdexcept>
#include <utility>

namespace meltpool {

LessonRun::LessonRun(gl::ShaderLibrary& shaders, Activities& activities, Stopwatch now, gl::ContextThread* metalThread)
    : shaders_(shaders), activities_(activities), metalThread_(metalThread), now_(now) {}

void LessonRun::make(Lesson lesson) {
    free(); // the next metal may need its memory
    auto trainer = std::make_unique<Trainer>(shaders_, std::move(lesson), metalThread_);
    scene_ = std::make_unique<LessonScene>(shaders_, *trainer);
    trainer_ = std::move(trainer);
    clock_.reset();
}

void LessonRun::free() {
    activities_.leave();
    scene_.reset();
    trainer_.reset();
}

void LessonRun::beginAgain() {
    fault_.clear();
    changed_ = true;
}

void LessonRun::event(std::string_view name, std::string_view value) {
    if (activities_.allowed().notes) trainer_->event(name, value);
}

const std::string& LessonRun::recordFault() const {
    static const std::string kNone;
    return trainer_ ? trainer_->recordFault() : kNone;
}

void LessonRun::guarded(FunctionRef<void()> work) {
    try {
        work();
    } catch (const std::runtime_error& fault) {
        fault_ = fault.what();
        event("fault", fault_);
    }
}

bool LessonRun::beginSteps(RunFrame frame, SoundSteps& soundSteps, gl::Profiler* profiler) {
    ActivityFrame& now = frame_.emplace(ActivityFrame{shaders_, trainer_.get(), clock_, soundSteps, now_, profiler,
                                                      frame.seconds, beside_, frame.waits, frame.forScore,
                                                      !fault_.empty(), false, std::move(frame.torch)});
    std::optional<int> due;
    guarded([&] {
        due = activities_.current().due(now);
        if (!now.stopped) fault_.clear();
    });
    changed_ |= now.changed;
    due_ = due.value_or(0);
    return due.has_value();
}

void LessonRun::makeSteps(gl::Profiler* profiler) {
    frame_->profiler = profiler;
    guarded([&] {
        const double begin = now_();
        for (int step = 0; step < due_; ++step) {
            changed_ = true;
            activities_.current().step(*frame_, step, due_);
        }
        clock_.took(now_() - begin, due_);
    });
}

void LessonRun::finishSteps() {
    if (fault_.empty()) guarded([&] { activities_.current().finish(*frame_); });
    if (activities_.allowed().notes) activities_.attempt.log().records().check(*trainer_);
    frame_.reset();
}

void LessonRun::noteMetal() {
    if (!scene_ || !changed_) return;
    scene_->noteMetal();
    changed_ = false;
}

void LessonRun::requestSurfaceDistance(const TorchSample& torch) {
    if (!trainer_) return;
    if (const auto fresh = scene_->pollDistance()) {
        surfaceDistance_ = *fresh;
        trainer_->setSurfaceDistance(surfaceDistance_);
    }
    scene_->requestDistance(torch);
}

} // namespace meltpool
