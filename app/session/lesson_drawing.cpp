// The part of LessonSession that shows the lesson: its scene, the desk's picture, and the figures beside it.
#include "app/session/lesson_session.hpp"
#include "core/training/classic_model.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>

namespace meltpool {

SceneView LessonSession::scene(gl::Profiler* profiler) {
    if (!running()) return {};
    // The vibration needs the surface also while the particles are shown.
    if (surfaceIsOld_ && (held_ || lesson_.look.mode != kPointsMode)) {
        trainer_->updateSurface(profiler);
        surfaceIsOld_ = false;
    }
    SceneView scene = trainer_->scene();
    if (cut_.shown()) {
        scene.section = cut_.view();
        scene.solids = {};
        scene.rodSolids = 0;
    }
    return scene;
}

std::span<const Marker> LessonSession::cueMarkers(const SceneView& scene, const View& eye) {
    if (!running() || played() || trial_.running() || cut_.shown()) return {};
    return cues_.markers(*trainer_, scene, eye);
}

std::span<const Marker> LessonSession::ghostMarkers(const SceneView& scene, const View& eye, float zoom) {
    if (!running() || played() || trial_.running() || cut_.shown()) return {};
    return ghost_.markers(*trainer_, scene, eye, zoom);
}

float LessonSession::unit() const {
    return kClassicUnit;
}

Fixture LessonSession::fixture() const {
    if (!running() || lesson_.model != LessonModel::Weld) return {};
    return fixtureOf(trainer_->lesson().workpiece);
}

std::optional<glm::vec3> LessonSession::arcFrom(const glm::mat4& worldToEye) const {
    if (!running() || lesson_.model != LessonModel::Weld) return std::nullopt;
    const glm::vec3 world = fixture().turn * trainer_->torch().tip / unit();
    return glm::vec3(worldToEye * glm::vec4(world, 1)) * unit();
}

float LessonSession::bottom() const {
    if (!running()) return 0.0f;
    const SceneView scene = trainer_->scene();
    // Along the world's vertical each axis of the box has its lower end.
    const glm::vec3 vertical = glm::row(glm::mat3(scene.modelToWorld), 1);
    const glm::vec3 lowest = glm::mix(scene.boxMax, scene.boxMin, glm::greaterThan(vertical, glm::vec3(0)));
    return (glm::dot(vertical, lowest) + scene.modelToWorld[3].y) * unit();
}

void LessonSession::draw(const Controls& controls, const RenderTarget& target, float shift, gl::Profiler* profiler) {
    SceneView scene = this->scene(profiler);
    if (!held_ && !played()) {
        const SteeredSource& source = controls.source();
        scene.source.position = glm::inverse(scene.modelToWorld) * glm::vec4(source.position(), 1);
        scene.source.on = source.on();
        scene.source.cold = source.cold();
    }
    const Viewport& shape = target.viewport;
    const float aspect = static_cast<float>(shape.width) / static_cast<float>(std::max(shape.height, 1));
    std::array<View, 1> views{controls.view(aspect)};
    if (cut_.shown()) { // its middle stands where the camera looks
        const glm::vec3 middle = scene.modelToWorld * glm::vec4(scene.section.at, 0, 0, 1);
        views[0].worldToEye = glm::translate(views[0].worldToEye, -middle);
        views[0].eye += middle;
        scene.section.strokes = cut_.strokes(layoutIn(views[0], scene.modelToWorld, scene.section.at));
    }
    if (!held_) recordings_.person(deskPerson(views[0], fixture().turn, unit(), steps()));
    views[0].eyeToClip[2][0] -= shift; // clip x over w, and w is -z in the eye
    scene.ghost = ghostMarkers(scene, views[0]);
    scene.markers = cueMarkers(scene, views[0]);
    renderer_.draw(scene, lesson_.look, views, target, profiler);
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
    figures.caption = hearing_.caption();
    const bool desk = desk_.leads() && !held_ && !played();
    figures.torch = desk ? std::optional(desk_.pose()) : std::nullopt;
    figures.distance = desk_.distanceKind();
}

} // namespace meltpool
