#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/training/classic_model.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace meltpool {

namespace {

ParameterList startParameters(Lesson& lesson) {
    ParameterList list;
    for (const Parameter& p : lesson.model == LessonModel::Weld ? describe(lesson.workpiece) : describe(lesson.setup))
        if (p.key != "seed") list.push_back(p);
    for (const Parameter& p : describe(lesson.surface))
        if (p.onlyAtStart || p.key == "influence") list.push_back(p);
    return list;
}

ParameterList liveParameters(ParameterList list) {
    std::erase_if(list, [](const Parameter& p) { return p.onlyAtStart; });
    return list;
}

bool same(const SurfaceParameters& a, const SurfaceParameters& b) {
    return a.influence == b.influence && a.isoLevel == b.isoLevel && a.caps == b.caps;
}

TorchSample torchOf(const SteeredSource& source) {
    TorchSample sample;
    sample.tip = source.position() * kClassicUnit;
    sample.orientation = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1, 0, 0)); // straight down
    sample.trigger = source.on() ? 1.0f : 0.0f;
    return sample;
}

} // namespace

Lesson loadLesson(const std::string& name) {
    return findLesson(name, resourceFolder() / "data" / "lessons");
}

LessonSections::LessonSections(Lesson& lesson)
    : start("start", startParameters(lesson)),
      view("view", describe(lesson.look)),
      surface("surface", liveParameters(describe(lesson.surface))),
      simulation("simulation", liveParameters(lesson.model == LessonModel::Weld ? describe(lesson.process)
                                                                                : describe(lesson.metal))) {}

void LessonSections::restoreDefaults() {
    for (const ParameterSection* each : all())
        for (const auto& [key, text] : each->defaults)
            setParameter(each->parameters, key, text, each->name);
}

LessonSession::LessonSession(gl::ShaderLibrary& shaders, Lesson lesson)
    : shaders_(shaders), lesson_(std::move(lesson)), sections_(lesson_), renderer_(shaders) {}

void LessonSession::begin(Controls& controls) {
    controls.restart();
    controls.source().setCold(lesson_.source.kind == 1);
    const CameraParameters& camera = lesson_.camera;
    controls.placeCamera(OrbitCamera(glm::radians(camera.azimuth), glm::radians(camera.elevation), camera.distance));
    controls.lens.fieldOfView = glm::radians(camera.fieldOfView);
    trainer_ = std::make_unique<Trainer>(shaders_, lesson_);
    if (!record_.empty()) trainer_->record(record_);
    surfaceDistance_ = {};
    clock_.restart();
    fault_.clear();
    surfaceIsOld_ = true;
}

void LessonSession::record(const std::filesystem::path& file) {
    record_ = file;
    if (running()) trainer_->record(record_);
}

void LessonSession::reset(Controls& controls) {
    if (!running()) return;
    controls.reset();
    trainer_->reset();
    clock_.restart();
    fault_.clear();
    surfaceIsOld_ = true;
}

bool LessonSession::takeOverChanges(const Controls& controls) {
    lesson_.source.kind = controls.source().cold() ? 1 : 0;
    Lesson& running = trainer_->lesson();
    running.metal = lesson_.metal;
    running.process = lesson_.process;
    running.source = lesson_.source;
    const bool changed = !same(shownSurface_, lesson_.surface);
    running.surface = lesson_.surface;
    shownSurface_ = lesson_.surface;
    return changed;
}

void LessonSession::advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held) {
    if (!running()) return;
    surfaceIsOld_ |= takeOverChanges(controls);
    held_ = static_cast<bool>(held);
    if ((controls.mode() == Mode::view && !held_) || !fault_.empty()) {
        clock_.restart();
        return;
    }
    try {
        const int due = clock_.due(seconds, trainer_->timeStep());
        for (int step = 0; step < due; ++step) {
            trainer_->advance(held_ ? held(step, due) : torchOf(controls.source()), profiler);
            surfaceIsOld_ = true;
        }
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
    }
}

void LessonSession::sound(const TorchSample& torch) {
    if (!running()) return;
    if (const auto fresh = trainer_->pollDistance()) {
        surfaceDistance_ = *fresh;
        trainer_->setSurfaceDistance(surfaceDistance_);
    }
    trainer_->requestDistance(torch);
}

SceneView LessonSession::scene(gl::Profiler* profiler) {
    if (!running()) return {};
    // The vibration needs the surface also while the particles are shown.
    if (surfaceIsOld_ && (held_ || lesson_.look.mode != kPointsMode)) {
        trainer_->updateSurface(profiler);
        surfaceIsOld_ = false;
    }
    return trainer_->scene();
}

float LessonSession::unit() const {
    return kClassicUnit;
}

float LessonSession::bottom() const {
    if (!running()) return 0.0f;
    const SceneView scene = trainer_->scene();
    return (scene.modelToWorld * glm::vec4(0, scene.boxMin.y, 0, 1)).y * unit();
}

void LessonSession::draw(const Controls& controls, glm::ivec2 pixels, float shift, gl::Profiler* profiler) {
    SceneView scene = this->scene(profiler);
    if (!held_) {
        const SteeredSource& source = controls.source();
        scene.source.position = glm::inverse(scene.modelToWorld) * glm::vec4(source.position(), 1);
        scene.source.on = source.on();
        scene.source.cold = source.cold();
    }
    const float aspect = static_cast<float>(pixels.x) / static_cast<float>(std::max(pixels.y, 1));
    std::array<View, 1> views{controls.view(aspect)};
    views[0].eyeToClip[2][0] -= shift; // clip x over w, and w is -z in the eye
    renderer_.draw(scene, lesson_.look, views, {0, {0, 0, pixels.x, pixels.y}}, profiler);
}

void LessonSession::fillFigures(LessonFigures& figures) const {
    if (!running()) return;
    const MetalStatistics& metal = trainer_->figures();
    figures.time = trainer_->time();
    figures.speed = clock_.speed();
    figures.particles = metal.particles;
    figures.molten = metal.molten;
    figures.hottest = metal.maxTemperature;
    figures.kelvin = lesson_.model == LessonModel::Weld;
    figures.lost = metal.lost;
    figures.refused = metal.nonFinite;
    figures.stopped = !fault_.empty();
}

} // namespace meltpool
