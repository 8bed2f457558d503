// The picture of the lesson: its scene with cut, cues and ghost, and the visor before the eye at the window.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/cut_view.hpp"
#include "app/session/lesson_run.hpp"
#include "app/session/torch_lead.hpp"
#include "core/render/effects/worn_visor.hpp"
#include "core/render/renderer.hpp"
#include "core/weld/workpiece/position.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// A scene and the eye that sees it.
struct DeskPicture {
    SceneView scene;
    View view;
};

/// The lesson that is shown; all of it must outlive the picture.
struct PictureSource {
    const Lesson& lesson;
    LessonRun& run; ///< where it has no metal, scenes are empty
    Activities& activities;
    const TorchLead& lead;
};

class LessonPicture {
  public:
    /// Throws InputError when the shaders cannot be used.
    LessonPicture(gl::ShaderLibrary& shaders, const PictureSource& source);

    Renderer& renderer() { return renderer_; }
    /// The detail of the pictures to come, whatever the lesson's file says; the highest at first.
    void setDetail(PictureDetail detail) { detail_ = detail; }
    /// The lesson's look with that detail.
    LookParameters look() const;
    /// The visor and the eye of the window's picture, see WornVisor. They are those of the lesson's look.
    const WornVisor& visor() const { return visor_; }

    /// Another frame begins, `seconds` of real time after the last. Brings the lesson's look and surface to the metal
    /// where `live`.
    void beginFrame(double seconds, bool live);

    /// The scene with the current surface.
    SceneView scene(gl::Profiler* profiler);
    /// The lesson as the desk sees it now. `aspect`: width over height; `shift`: how far right of the window's middle
    /// the picture's middle is, as a share of half its width. What it lends is valid until the lesson's next steps are
    /// finished. `surfaceLater`: the surface is still to be made by completeSurface().
    DeskPicture atDesk(const Controls& controls, float aspect, float shift, bool surfaceLater, gl::Profiler* profiler);
    /// Makes the surface that an atDesk() left for later.
    void completeSurface(DeskPicture& picture, gl::Profiler* profiler);
    void draw(const DeskPicture& picture, const RenderTarget& target, gl::Profiler* profiler);

    /// The cues for this eye, or for the middle between two, in the world of `scene`; none outside an attempt. Valid
    /// until the next call.
    std::span<const Marker> cueMarkers(const SceneView& scene, const View& eye);
    /// The ghost likewise. `zoom`: see AttemptGhost::markers().
    std::span<const Marker> ghostMarkers(const SceneView& scene, const View& eye, float zoom = 1);

    CutView& cut() { return cut_; }
    const CutView& cut() const { return cut_; }
    /// Cuts the weld open, the desk's camera square before the cut. Waits for the GPU. Throws RuntimeFault, and leaves
    /// it closed then.
    void openCut(Controls& controls);
    /// Closes the cut, with camera and mode as before; false where it was not open.
    bool closeCut(Controls& controls);
    /// Moves the open cut by what the hand does in this frame, and cuts where it is now. Throws RuntimeFault.
    void moveCut(const Controls& controls);

    /// How far under the workpiece's origin the lowest place of its space lies in the room, m, negative.
    float bottom() const;
    /// How the workpiece is held; as it lies without a running weld lesson.
    Fixture fixture() const;
    /// Place of the arc in the eye's frame of this view matrix, m. Nothing without a running weld lesson.
    std::optional<glm::vec3> arcFrom(const glm::mat4& worldToEye) const;

  private:
    Trainer* trainer() const { return source_.run.trainer(); }
    LessonScene* shown() const { return source_.run.scene(); }
    TorchLeader leader() const { return source_.lead.leader(source_.activities.allowed()); }
    bool showsHelp() const { return source_.activities.allowed().help && !cut_.shown(); }
    bool weld() const { return trainer() != nullptr && source_.lesson.model == LessonModel::Weld; }
    void noteSurface();
    SceneView sceneOfMetal();
    void standBeforeCut(SceneView& scene, View& view);
    void placeCameraBeforeCut(Controls& controls) const;

    PictureSource source_;
    Renderer renderer_;
    PictureDetail detail_ = kHighDetail;
    SurfaceParameters shownSurface_;
    WornVisor visor_;
    double sinceSeen_ = 0; ///< real s since the last picture
    CutView cut_;
    OrbitCamera cameraBeforeCut_;
    Mode modeBeforeCut_ = Mode::interact;
};

} // namespace meltpool
