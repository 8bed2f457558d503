#include "core/training/trainer/lesson_metal.hpp"

#include "core/training/lesson/lesson.hpp"

namespace meltpool {

LessonMetal::LessonMetal(gl::ShaderLibrary& shaders, const Lesson& lesson, gl::ContextThread* there) : there_(there) {
    if (there_ == nullptr)
        metal_ = makeMetalModel(shaders, lesson);
    else
        there_->run([&] { metal_ = makeMetalModel(there_->shaders(), lesson); });
}

LessonMetal::~LessonMetal() {
    if (there_ == nullptr) return;
    there_->run([this] {
        times_.reset();
        metal_.reset();
    });
}

void LessonMetal::step(const TorchSample& torch, gl::Profiler* profiler) {
    changed_ = true;
    if (there_ == nullptr) return metal_->step(torch, profiler);
    if (profiler == nullptr || !profiler->inFrame()) return there_->run([&] { metal_->step(torch, nullptr); });
    there_->run([&] { stepTimed(torch); });
    profiler->include(*times_);
}

void LessonMetal::stepTimed(const TorchSample& torch) {
    if (!times_) times_.emplace();
    times_->reset();
    times_->beginFrame();
    metal_->step(torch, &*times_);
    times_->endFrame();
    times_->finish();
}

ParticleView LessonMetal::particles() const {
    const ParticleView original = metal_->particles();
    if (there_ == nullptr || there_->here()) return original;
    if (changed_) mirror_.take(original, *there_);
    changed_ = false;
    return mirror_.view();
}

} // namespace meltpool
