#include "app/session/lesson_picture.hpp"

#include "app/session/seeing.hpp"
#include "core/base/resources.hpp"
#include "core/training/trainer/classic_model.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

bool same(const SurfaceParameters& a, const SurfaceParameters& b) {
    return a.influence == b.influence && a.isoLevel == b.isoLevel && a.caps == b.caps;
}

} // namespace

LessonPicture::LessonPicture(gl::ShaderLibrary& shaders, const PictureSource& source)
    : source_(source), renderer_(shaders, cacheFolder()) {}

LookParameters LessonPicture::look() const {
    LookParameters look = source_.lesson.look;
    look.detail = detail_;
    return look;
}

void LessonPicture::beginFrame(double seconds, bool live) {
    sinceSeen_ += seconds;
    namedCues_.clear();
    if (!live) return;
    const SurfaceParameters& surface = source_.lesson.surface;
    Lesson& running = trainer()->lesson();
    const bool detailed = running.look.detail != detail_; // the detail decides what the surface holds
    if (detailed || !same(shownSurface_, surface)) source_.run.metalChanged();
    running.surface = surface;
    running.look.detail = detail_;
    shownSurface_ = surface;
}

void LessonPicture::placeCamera(Controls& controls) {
    controls.lens.fieldOfView = glm::radians(source_.lesson.camera.fieldOfView);
    startCamera_.begin(controls, source_.lesson, source_.lead.desk());
}

void LessonPicture::frameCamera(Controls& controls, const CoveredEdges& covered, float aspect) {
    constexpr float kNames = 0.03F; // of the picture's height: a board's names stand above and below it
    covered_ = covered;
    covered_.bottom += kNames;
    covered_.top += kNames;
    // Under a person's arc the picture stays; a replay begins with its arc.
    const bool welds = source_.run.arc().burns() && source_.activities.allowed().ownTorch;
    if (!welds) startCamera_.frame(controls, covered, aspect, !torchAside());
}

SceneView LessonPicture::scene(gl::Profiler* profiler) {
    noteSurface();
    if (shown() != nullptr) shown()->makeSurface(profiler);
    return sceneOfMetal();
}

void LessonPicture::noteSurface() {
    // The vibration needs the surface also while particles are shown.
    const bool needed = leader() == TorchLeader::hand || source_.lesson.look.mode != kPointsMode;
    if (needed) source_.run.noteMetal();
}

void LessonPicture::completeSurface(DeskPicture& picture, gl::Profiler* profiler) {
    if (shown() == nullptr) return;
    shown()->makeSurface(profiler);
    picture.scene.mesh = shown()->surface().mesh();
}

SceneView LessonPicture::sceneOfMetal() {
    if (shown() == nullptr) return {};
    SceneView scene = shown()->view();
    if (cut_.shown()) {
        scene.section = cut_.view();
        scene.putTorchAway();
    }
    if (torchAside()) scene.putTorchAway();
    return scene;
}

std::span<const Marker> LessonPicture::cueMarkers(const SceneView& scene, const View& eye, CueNaming naming) {
    if (!showsHelp()) return {};
    return source_.activities.attempt.cues().markers(*trainer(), scene, eye, naming);
}

std::span<const Marker> LessonPicture::ghostMarkers(const SceneView& scene, const View& eye, float zoom) {
    if (!showsHelp()) return {};
    Attempt& attempt = source_.activities.attempt;
    return attempt.ghost().markers(*trainer(), scene, eye, zoom, attempt.cues().boardSide());
}

Fixture LessonPicture::fixture() const {
    return weld() ? fixtureOf(trainer()->lesson().workpiece) : Fixture{};
}

void LessonPicture::addHolders(std::vector<Solid>& solids, float overTable) const {
    if (shown() != nullptr) shown()->addHolders(solids, overTable);
}

std::optional<glm::vec3> LessonPicture::arcFrom(const glm::mat4& worldToEye) const {
    if (!weld()) return std::nullopt;
    const glm::vec3 world = fixture().turn * source_.run.torchEnd() / kClassicUnit;
    return glm::vec3(worldToEye * glm::vec4(world, 1)) * kClassicUnit;
}

float LessonPicture::bottom() const {
    if (shown() == nullptr) return 0.0f;
    const SceneView scene = shown()->view();
    const glm::vec3 vertical = glm::row(glm::mat3(scene.modelToWorld), 1);
    return (lowestAlong(vertical, scene.boxMin, scene.boxMax) + scene.modelToWorld[3].y) * kClassicUnit;
}

float LessonPicture::toMetal(const glm::vec3& place) const {
    if (shown() == nullptr) return 0.0f;
    const SceneView scene = shown()->view();
    const glm::vec4 world(fixture().turn * place / kClassicUnit, 1);
    const glm::vec3 inBox = glm::inverse(scene.modelToWorld) * world;
    const glm::vec4 nearest(glm::clamp(inBox, scene.boxMin, scene.boxMax), 1);
    return glm::distance(world, scene.modelToWorld * nearest) * kClassicUnit;
}

DeskPicture LessonPicture::atDesk(const Controls& controls, float aspect, const glm::vec2& shift, bool surfaceLater,
                                  gl::Profiler* profiler) {
    noteSurface();
    if (shown() != nullptr && !surfaceLater) shown()->makeSurface(profiler);
    DeskPicture picture{sceneOfMetal(), controls.view(aspect), 0};
    SceneView& scene = picture.scene;
    View& view = picture.view;
    if (leader() == TorchLeader::desk) {
        const SteeredSource& source = controls.source();
        scene.source.position = glm::inverse(scene.modelToWorld) * glm::vec4(source.position(), 1);
        scene.source.on = source.on();
        scene.source.cold = source.cold();
    }
    if (cut_.shown()) standBeforeCut(scene, view);
    if (leader() == TorchLeader::desk)
        source_.activities.attempt.log().recordings().person(
            deskPerson(view, fixture().turn, kClassicUnit, trainer()->steps()));
    const LookParameters& look = source_.lesson.look;
    visor_.update(seenArc(scene, view, source_.run.arc().length), visorOf(look), look, std::exchange(sinceSeen_, 0));
    if (look.adaptation) scene.afterImage = visor_.eye().afterImage();
    view.eyeToClip[2][0] -= shift.x; // clip x over w, and w is -z in the eye
    view.eyeToClip[2][1] -= shift.y;
    lookThroughTable(scene, view);
    View free = view; // signs beside the work avoid the panels
    free.eyeToClip = covered_.uncovered() * view.eyeToClip;
    scene.markers = cueMarkers(scene, free, CueNaming::none); // the window writes their names in its own letters
    scene.ghost = ghostMarkers(scene, free);                  // beside the cues' board
    if (!scene.markers.empty()) picture.boardMarkers = source_.activities.attempt.cues().boardMarkers();
    nameCues(scene, view);
    return picture;
}

void LessonPicture::nameCues(const SceneView& scene, const View& view) {
    namedCues_.clear();
    if (scene.markers.empty()) return;
    const AttemptCues& cues = source_.activities.attempt.cues();
    const auto labels = cues.labels();
    // One field without a name among named ones would look like a fault.
    if (std::none_of(labels.begin(), labels.end(), [&](const CueLabel& each) { return cues.isNew(each.kind); })) return;
    for (const CueLabel& label : labels) {
        const auto inWindow = [&](const glm::vec3& world) {
            const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(world, 1);
            return glm::vec2(clip.x, -clip.y) / std::max(clip.w, 1e-6f) * 0.5f + 0.5f;
        };
        const glm::vec2 place = inWindow(label.place);
        const float width = 2 * std::abs(inWindow(label.end).x - place.x);
        namedCues_.push_back(
            {label.kind, place, width, label.above, static_cast<float>(label.opacity), label.correction});
    }
}

void LessonPicture::draw(const DeskPicture& picture, const RenderTarget& target, gl::Profiler* profiler) {
    LookParameters seen = look();
    visor_.wear(visorOf(seen), seen);
    renderer_.draw(picture.scene, seen, std::span(&picture.view, 1), target, profiler);
}

} // namespace meltpool
