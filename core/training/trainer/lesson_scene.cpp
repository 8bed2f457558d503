#include "core/training/trainer/lesson_scene.hpp"

#include <utility>

namespace meltpool {

LessonScene::LessonScene(gl::ShaderLibrary& shaders, Trainer& trainer)
    : trainer_(trainer), around_(trainer.metal().model().makeScene()), probe_(shaders) {
    const SceneView scene = withoutSurface({});
    surface_ = std::make_unique<Surface>(shaders, trainer.lesson().surface, scene.boxMin, scene.boxMax);
    if (trainer.lesson().model == LessonModel::Weld) sight_.open(scene);
    drawChalk();
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
    wipeChalk();
}

/// Draws the line to weld on a plate without a joint, and marks beside a joint where the length begins and ends that
/// counts. A test has them too.
void LessonScene::drawChalk() {
    const Lesson& lesson = std::as_const(trainer_).lesson();
    if (lesson.model != LessonModel::Weld || !lesson.technique || trainer_.technique() == nullptr) return;
    const TechniqueBands& bands = *lesson.technique;
    if (static_cast<WorkpieceKind>(lesson.workpiece.kind) != WorkpieceKind::Plate) return markJoint(bands);
    const TechniqueBand* aim = bands.find(TechniqueQuantity::aim);
    const double line = aim != nullptr ? aim->ideal / quantityInfo(TechniqueQuantity::aim, bands.distance).perSi : 0;
    const Seam& seam = trainer_.technique()->seam();
    const auto place = [&](double mm) {
        const SeamFrame frame = seam.at(mm * 1e-3);
        return glm::vec3(frame.point + line * frame.across);
    };
    const SeamFrame middle = seam.at(0);
    chalk_.emplace(
        ChalkEnds{place(bands.lengthFromMm), place(bands.lengthToMm), glm::vec3(middle.up), glm::vec3(middle.across)});
    welded_.emplace(seam, line);
}

void LessonScene::markJoint(const TechniqueBands& bands) {
    const Seam& seam = trainer_.technique()->seam();
    std::vector<JointEnd> ends;
    for (const double mm : {bands.lengthFromMm, bands.lengthToMm}) {
        const SeamFrame frame = seam.at(mm * 1e-3);
        ends.push_back(
            {glm::vec3(frame.point), glm::vec3(frame.across), glm::vec3(frame.up), glm::vec3(frame.tangent)});
    }
    marks_ = jointMarks(ends, withoutSurface({}).blocks);
}

void LessonScene::wipeChalk() {
    if (!chalk_) return;
    welded_->update(*trainer_.technique());
    if (std::exchange(wiped_, welded_->changes()) == welded_->changes()) return;
    const double first = std::as_const(trainer_).lesson().technique->lengthFromMm * 1e-3;
    chalk_->wipe([&](double from, double to) { return welded_->any(first + from, first + to); });
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
    scene.chalk = chalk_ ? chalk_->solids() : std::span<const Solid>(marks_);
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
