// The picture of the lesson: its scene with cut, cues and ghost, and the visor before the eye at the window.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/cut_view.hpp"
#include "app/session/lesson_run.hpp"
#include "app/session/start_camera.hpp"
#include "app/session/torch_lead.hpp"
#include "core/render/effects/worn_visor.hpp"
#include "core/render/renderer.hpp"
#include "core/weld/workpiece/position.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// A scene and the eye that sees it.
struct DeskPicture {
    SceneView scene;
    View view;
    size_t boardMarkers = 0; ///< number of the scene's last markers that are a board beside the work, not on it
};

/// Name of a cue's field in the window, or what the hand has to do.
struct NamedCue {
    CueKind kind = CueKind::speed;
    glm::vec2 place{0}; ///< middle of the field's upper or lower edge
    float width = 0;    ///< of the field
    bool above = false; ///< the edge is the upper one
    float opacity = 1;
    int correction = 0; ///< see CueLabel
};

/// The lesson to show; all of it must outlive the picture.
struct PictureSource {
    const Lesson& lesson;
    LessonRun& run; ///< its scenes are empty while it has no metal
    Activities& activities;
    const TorchLead& lead;
};

class LessonPicture {
  public:
    /// Throws InputError when the shaders cannot be used.
    LessonPicture(gl::ShaderLibrary& shaders, const PictureSource& source);

    Renderer& renderer() { return renderer_; }
    /// Sets the detail of the pictures from now on, regardless of the lesson's file; the highest at first.
    void setDetail(PictureDetail detail) { detail_ = detail; }
    /// Look of the lesson with that detail.
    LookParameters look() const;
    /// Visor and eye of the window's picture, see WornVisor; from the lesson's look.
    const WornVisor& visor() const { return visor_; }

    /// Begins a frame, `seconds` of real time after the last. Applies the lesson's look and surface to the metal if
    /// `live`.
    void beginFrame(double seconds, bool live);

    /// Places the desk's camera as the lesson says.
    void placeCamera(Controls& controls);
    /// Keeps torch and seam in the uncovered part of a picture of this width over height, from the lesson's start until
    /// the person moves the camera; not while their arc burns.
    void frameCamera(Controls& controls, const CoveredEdges& covered, float aspect);

    /// Scene with the current surface.
    SceneView scene(gl::Profiler* profiler);
    /// Picture of the lesson from the desk's camera. `aspect`: width over height; `shift`: of the picture's middle to
    /// the right of the window's and above it, as a share of half the window's width and height. Valid until the
    /// lesson's next steps are finished. `surfaceLater`: leaves the surface to completeSurface().
    DeskPicture atDesk(const Controls& controls, float aspect, const glm::vec2& shift, bool surfaceLater,
                       gl::Profiler* profiler);
    /// Makes the surface that atDesk() left for later.
    void completeSurface(DeskPicture& picture, gl::Profiler* profiler);
    void draw(const DeskPicture& picture, const RenderTarget& target, gl::Profiler* profiler);

    /// Cues for this eye, or for the middle between two, in the world of `scene`; none outside an attempt. Valid until
    /// the next call.
    std::span<const Marker> cueMarkers(const SceneView& scene, const View& eye, CueNaming naming);
    /// Names of the cues on the board of the last desk picture that the person has made no progress with. Places are in
    /// the window: shares of its width and height from the upper left.
    std::span<const NamedCue> namedCues() const { return namedCues_; }
    /// Markers of the ghost, likewise, beside the board of the last cueMarkers(). `zoom`: see AttemptGhost::markers().
    std::span<const Marker> ghostMarkers(const SceneView& scene, const View& eye, float zoom = 1);

    CutView& cut() { return cut_; }
    const CutView& cut() const { return cut_; }
    /// Cuts the weld open and puts the desk's camera square before the cut. Waits for the GPU. Throws RuntimeFault; the
    /// weld then stays closed.
    void openCut(Controls& controls);
    /// Closes the cut and restores camera and mode; returns false if it was not open.
    bool closeCut(Controls& controls);
    /// Moves the open cut by this frame's input and cuts at its new place. Throws RuntimeFault.
    void moveCut(const Controls& controls);

    /// Height of the lowest point of the workpiece's space over its origin in the room, m, negative.
    float bottom() const;
    /// Returns the distance of a place from the box of the metal, 0 inside and while no metal is shown; both m, the
    /// workpiece's frame.
    float toMetal(const glm::vec3& place) const;
    /// Fixture of the workpiece; flat without a running weld lesson.
    Fixture fixture() const;
    /// See MetalScene::addHolders(); a no-op without metal.
    void addHolders(std::vector<Solid>& solids, float overTable) const;
    /// Place of the arc in the eye's frame of this view matrix, m. Nothing without a running weld lesson.
    std::optional<glm::vec3> arcFrom(const glm::mat4& worldToEye) const;

  private:
    Trainer* trainer() const { return source_.run.trainer(); }
    LessonScene* shown() const { return source_.run.scene(); }
    TorchLeader leader() const { return source_.lead.leader(source_.activities.allowed()); }
    bool showsHelp() const { return source_.activities.allowed().help && !cut_.shown() && !torchAside(); }
    bool torchAside() const { return leader() == TorchLeader::desk && source_.lead.desk().aside(); }
    bool weld() const { return trainer() != nullptr && source_.lesson.model == LessonModel::Weld; }
    void noteSurface();
    void nameCues(const SceneView& scene, const View& view);
    SceneView sceneOfMetal();
    void standBeforeCut(SceneView& scene, View& view);
    void placeCameraBeforeCut(Controls& controls) const;

    PictureSource source_;
    Renderer renderer_;
    PictureDetail detail_ = kHighDetail;
    SurfaceParameters shownSurface_;
    WornVisor visor_;
    double sinceSeen_ = 0; ///< s of real time since the last picture
    std::vector<NamedCue> namedCues_;
    StartCamera startCamera_;
    CoveredEdges covered_; ///< of the window, for signs that avoid the panels
    CutView cut_;
    OrbitCamera cameraBeforeCut_;
    Mode modeBeforeCut_ = Mode::interact;
};

} // namespace meltpool
