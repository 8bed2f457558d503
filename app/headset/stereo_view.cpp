#include "app/headset/stereo_view.hpp"

#include "app/session/cut_stand.hpp"
#include "app/session/seeing.hpp"
#include "core/render/look/measures.hpp"
#include "core/training/trainer/classic_model.hpp"

#include "shaders/shared/render.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

namespace meltpool {

namespace {

/// Shades by which the visor is lighter while a demonstration or a replay is watched. By EN 169 two shades pass seven
/// times the light.
constexpr float kLighterToWatch = 2;

std::optional<ViewSubmission> wantedSubmission(const HeadsetParameters& parameters) {
    if (parameters.bothEyes == HeadsetParameters::kAutomatic) return std::nullopt;
    return kViewSubmissions[static_cast<size_t>(parameters.bothEyes - HeadsetParameters::kViewports)];
}

View viewOf(const Workshop& workshop, const xr::EyeView& eye, const xr::BothEyes& eyes) {
    const xr::Pose pose = workshop.toWorkshop(eye.pose);
    return {pose.inverse().matrix(), xr::projection(eye.fov, eyes.nearZ, eyes.farZ), pose.position};
}

} // namespace

void StereoView::takeHands(const HeadsetHands& hands, const PanelPointer& panel) {
    const TrackedTorch& torch = hands.torch();
    hands_ = {};
    hands_.torch = torch.known();
    hands_.tip = torch.tip();
    hands_.holder = hands.holder();
    hands_.heat = torch.trigger();
    hands_.rod = hands.rod();
    hands_.rightHand = hands.torchHand() == xr::Hand::right;
    hands_.machineRight = panel.side() < 0;
    if (panel.pointingHand()) {
        hands_.rayStart = panel.rayStart();
        hands_.rayEnd = panel.rayEnd();
    }
}

/// Turns the cut workpiece to the person, with dimensions that are readable at arm's length.
void StereoView::standCut(LessonSession& session, SceneView& scene) const {
    constexpr float kFigure = 9e-3f; // m in the room
    const MarkLayout upright = uprightLayout(session.picture().fixture().up(), kFigure);
    scene.modelToWorld = standOfCut(scene.modelToWorld,
                                    {scene.section.at, upright.up, static_cast<float>(session.picture().cut().extent()),
                                     scene.boxMin, scene.boxMax},
                                    parameters_.tableHeight);
    MarkLayout layout = upright;
    layout.text = kFigure / glm::length(glm::vec3(scene.modelToWorld[0]));
    scene.section.strokes = session.picture().cut().strokes(layout);
}

/// Puts the visor on; a weld without an arc needs none.
void StereoView::wearVisor(const LessonSession& session, SceneView& scene, const View& between,
                           std::span<const View> eyes, LookParameters& look) {
    if (!scene.temperature.kelvin) return visor_.wear(parameters_, false, look);
    if (!isArcWelding(session.lesson().process)) return;
    const double elapsed = std::exchange(sinceSeen_, 0);
    HeadsetParameters worn = parameters_;
    // Who watches a demonstration wants to see its torch and hand, too.
    if (session.leader() == TorchLeader::path)
        worn.visorShade =
            std::max(worn.visorShade - kLighterToWatch, std::min(worn.visorShade, float(WornVisor::kProtects)));
    visor_.update(worn, seenArc(scene, between, eyes, session.run().arc().length), look, elapsed);
    visor_.wear(worn, true, look);
    scene.afterImage = visor_.afterImage(worn);
}

/// Adds torch and hands of the process, table, machine and holders, in a room with depth.
void StereoView::furnish(LessonSession& session, const SceneView& lesson, const WorkpiecePlace& place) {
    hands_.process = &session.lesson().process;
    if (!holdsRod(*hands_.process)) hands_.rod.reset();
    holders_.clear();
    // The zoom enlarges the holders with the workpiece.
    if (!session.picture().cut().shown()) session.picture().addHolders(holders_, place.overTable / place.zoom);
    hands_.holders = holders_;
    if (session.leader() != TorchLeader::path) return;
    hands_.rod.reset();
    if (lesson.fittings.empty()) return; // before a cut
    hands_.demonstrated = &session.run().torch();
    hands_.workpieceToWorkshop =
        glm::scale(glm::translate(glm::mat4(1.0f), place.origin) * glm::mat4(place.turn), glm::vec3(place.zoom));
}

/// Takes the state of wire, electrode and arc at the torch in the hand. On a workpiece that is shown larger, an
/// electrode burns off as much faster as the hand must come down.
void StereoView::takeArc(const LessonSession& session, const SceneView& scene, float zoom) {
    hands_.arcGlow.reset();
    if (scene.arc.intensity.g > 0)
        hands_.arcGlow = scene.arc.intensity / (std::numbers::pi_v<float> * scene.arc.radius * scene.arc.radius);
    hands_.extension = hands_.burnt = 0;
    if (session.lesson().model != LessonModel::Weld) return;
    hands_.extension = session.run().arc().extension;
    const auto whole = static_cast<float>(equipmentOf(session.lesson().process).electrodeLength);
    if (whole <= 0 || hands_.extension <= 0) return;
    hands_.burnt = std::min(zoom * (whole - hands_.extension), whole);
    hands_.extension = std::max(whole - hands_.burnt, 1e-3f);
}

void StereoView::draw(LessonSession& session, const SceneView& lesson, const WorkpiecePlace& place,
                      const Workshop& workshop, const xr::BothEyes& eyes, gl::Profiler* profiler) {
    SceneView scene = lesson;
    takeArc(session, scene, place.zoom);
    scene.modelToWorld = place.modelToWorkshop(kClassicUnit) * scene.modelToWorld;
    const bool demonstrated = session.leader() == TorchLeader::path;
    hands_.laidAside = demonstrated; // two torches of one look could be taken for each other
    hands_.tools = demonstrated ? lesson.solids : lesson.solids.last(lesson.rodSolids);
    hands_.toolsToWorkshop = place.modelToWorkshop(kClassicUnit);
    LookParameters look = session.picture().look();
    const bool fine = has(look, DetailFeature::room) && lesson.room.shown; // only weld lessons have a room
    if (fine)
        furnish(session, lesson, place);
    else if (session.lesson().model == LessonModel::Weld)
        hands_.plainly = &session.lesson().process;
    const xr::Pose head = workshop.toWorkshop(xr::interpolate(eyes.views[0].pose, eyes.views[1].pose, 0.5f));
    hands_.holder.forearm = forearmFrom(head, hands_.holder);
    if (hands_.rod) hands_.rod->forearm = forearmFrom(head, *hands_.rod);
    scene.solids = scene_.build(parameters_, hands_);
    scene.tableShown = true;
    scene.fittings = scene_.fittings();
    scene.hands = scene_.hands();
    scene.furniture = scene_.furniture();
    scene.room.shown = lesson.room.shown && look.showSky;
    scene.room.toWorld = glm::translate(glm::mat4(1.0f), {0, -float(WORKSHOP_FLOOR), 0});
    scene.source.shown &= demonstrated; // the drawn torch replaces the source otherwise
    if (session.picture().cut().shown()) standCut(session, scene);
    look.showBox = false;
    const std::array<View, 2> views{viewOf(workshop, eyes.views[0], eyes), viewOf(workshop, eyes.views[1], eyes)};
    View between = views[0]; // cues have one place for both eyes
    between.eye = (between.eye + views[1].eye) * 0.5f;
    wearVisor(session, scene, between, views, look);
    Renderer& renderer = session.picture().renderer();
    renderer.submitBy(wantedSubmission(parameters_));
    scene.markers = session.picture().cueMarkers(scene, between, CueNaming::whileNew);
    scene.ghost = session.picture().ghostMarkers(scene, between, place.zoom); // beside the cues' board
    const HiddenArea hidden{eyes.hidden.corners, eyes.hidden.version};
    renderer.draw(scene, look, views,
                  {eyes.framebuffer,
                   {0, 0, 2 * eyes.width, eyes.height},
                   eyes.encodesSrgb,
                   hidden.version == 0 ? nullptr : &hidden},
                  profiler);
}

} // namespace meltpool
