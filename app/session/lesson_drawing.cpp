// The part of LessonSession that shows the lesson: its scene, the desk's picture, and the figures beside it.
#include "app/session/lesson_session.hpp"
#include "app/session/seeing.hpp"
#include "core/training/trainer/classic_model.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <span>
#include <utility>

namespace meltpool {

SceneView LessonSession::scene(gl::Profiler* profiler) {
    noteSurface();
    if (running()) trainer_->makeSurface(profiler);
    return sceneOfMetal();
}

void LessonSession::noteSurface() {
    // The vibration needs the surface also while the particles are shown.
    if (!running() || !surfaceIsOld_ || (!held_ && lesson_.look.mode == kPointsMode)) return;
    trainer_->noteMetal();
    surfaceIsOld_ = false;
}

void LessonSession::completeSurface(DeskPicture& picture, gl::Profiler* profiler) {
    if (!running()) return;
    trainer_->makeSurface(profiler);
    picture.scene.mesh = trainer_->mesh();
}

SceneView LessonSession::sceneOfMetal() {
    if (!running()) return {};
    SceneView scene = trainer_->scene();
    if (cut_.shown()) {
        scene.section = cut_.view();
        scene.putTorchAway();
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

DeskPicture LessonSession::picture(const Controls& controls, float aspect, float shift, bool surfaceLater,
                                   gl::Profiler* profiler) {
    noteSurface();
    if (running() && !surfaceLater) trainer_->makeSurface(profiler);
    DeskPicture picture{sceneOfMetal(), controls.view(aspect)};
    SceneView& scene = picture.scene;
    View& view = picture.view;
    if (!held_ && !played()) {
        const SteeredSource& source = controls.source();
        scene.source.position = glm::inverse(scene.modelToWorld) * glm::vec4(source.position(), 1);
        scene.source.on = source.on();
        scene.source.cold = source.cold();
    }
    if (cut_.shown()) { // its middle stands where the camera looks
        const glm::vec3 middle = scene.modelToWorld * glm::vec4(scene.section.at, 0, 0, 1);
        view.worldToEye = glm::translate(view.worldToEye, -middle);
        view.eye += middle;
        scene.section.strokes = cut_.strokes(layoutIn(view, scene.modelToWorld, scene.section.at));
        scene.room.shown = false; // the cut metal by itself
    }
    if (!held_) recordings_.person(deskPerson(view, fixture().turn, unit(), steps()));
    visor_.update(seenArc(scene, view, arc().length), visorOf(lesson_.look), lesson_.look,
                  std::exchange(sinceSeen_, 0));
    if (lesson_.look.adaptation) scene.afterImage = visor_.eye().afterImage();
    view.eyeToClip[2][0] -= shift; // clip x over w, and w is -z in the eye
    lookThroughTable(scene, view);
    scene.ghost = ghostMarkers(scene, view);
    scene.markers = cueMarkers(scene, view);
    return picture;
}

void LessonSession::draw(const DeskPicture& picture, const RenderTarget& target, gl::Profiler* profiler) {
    LookParameters seen = look();
    visor_.wear(visorOf(seen), seen);
    renderer_.draw(picture.scene, seen, std::span(&picture.view, 1), target, profiler);
}

LookParameters LessonSession::look() const {
    LookParameters look = lesson_.look;
    look.detail = detail_;
    return look;
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
