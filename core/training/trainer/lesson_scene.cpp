#include "core/training/trainer/lesson_scene.hpp"

#include <utility>

namespace meltpool {

LessonScene::LessonScene(gl::ShaderLibrary& shaders, Trainer& trainer)
    : trainer_(trainer), around_(trainer.metal().model().makeScene()), probe_(shaders) {
    const SceneView scene = withoutSurface({});
    surface_ = std::make_unique<Surface>(shaders, trainer.lesson().surface, scene.boxMin, scene.boxMax);
    if (trainer.lesson().model == LessonModel::Weld) sight_.open(scene);
    trainer_.watch(this);
}

LessonScene::~LessonScene() {
    trainer_.watch(nullptr);
}

void LessonScene::stepped() {
    sight_.step(trainer_.lesson().process, trainer_.heard(), trainer_.torch(), trainer_.steps());
}

void LessonScene::beganAgain() {
    sight_.reset();
}

void LessonScene::restored() {
    sight_.reset();
    metalExchanged_ = true;
}

void LessonScene::noteMetal() {
    const Lesson& lesson = std::as_const(trainer_).lesson();
    const int cells = surface_->parameters.cells;
    surface_->parameters = lesson.surface;
    surface_->parameters.cells = cells;
    trainer_.metal().model().prepare(*surface_);
    noted_ = trainer_.metal().particles();
    if (lesson.look.detail == kLowDetail) noted_->frozenAt = nullptr; // ripples are not drawn
}

void LessonScene::makeSurface(gl::Profiler* profiler) {
    if (noted_) surface_->update(*noted_, profiler);
    noted_.reset();
}

SceneView LessonScene::withoutSurface(const TorchSample& torch) {
    SceneView scene = around_->view(torch);
    scene.particles = trainer_.metal().particles();
    return scene;
}

SceneView LessonScene::view() {
    SceneView scene = withoutSurface(trainer_.torch());
    scene.mesh = surface_->mesh();
    scene.meshIsOpen = !trainer_.lesson().surface.caps;
    scene.effects = sight_.view();
    return scene;
}

void LessonScene::forgetOldMetal() {
    if (std::exchange(metalExchanged_, false)) probe_.forget();
}

void LessonScene::requestDistance(const TorchSample& torch) {
    forgetOldMetal();
    probe_.request(*surface_, trainer_.metal().model(), torch);
}

std::optional<SurfaceDistance> LessonScene::pollDistance() {
    forgetOldMetal();
    return probe_.poll(trainer_.metal().model());
}

SurfaceDistance LessonScene::distanceNow(const TorchSample& torch) {
    return probe_.now(*surface_, trainer_.metal().model(), torch);
}

} // namespace meltpool
