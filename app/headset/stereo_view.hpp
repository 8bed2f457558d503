// Draws the view of both eyes: the lesson's metal on the table, the workshop around it, and the visor before it.
#pragma once

#include "app/headset/headset_hands.hpp"
#include "app/headset/panel_pointer.hpp"
#include "app/headset/visor.hpp"
#include "app/headset/workshop_scene.hpp"
#include "app/session/lesson_session.hpp"
#include "xr/headset.hpp"

#include <span>
#include <vector>

namespace meltpool {

class StereoView {
  public:
    explicit StereoView(const HeadsetParameters& parameters) : parameters_(parameters) {}

    /// Darkens the visor of the classic lesson with the heat of the torch, the hand's or that of a demonstration or
    /// replay; the visor of a weld sees the arc when it is drawn. It is up while the person `reads` a page. `elapsed`:
    /// real seconds since the last frame.
    void update(const LessonSession& session, const TrackedTorch& torch, bool reads, double elapsed) {
        const float trigger = session.leader() == TorchLeader::path ? session.run().torch().trigger : torch.trigger();
        visor_.update(trigger > 0, elapsed);
        visor_.read(reads, elapsed);
        sinceSeen_ += elapsed;
    }
    /// See WornVisor::sentence().
    std::string_view dazzled() const { return visor_.sentence(parameters_); }

    /// Returns true if the trainee looks through a visor that the arc will darken.
    bool visorDown(const LessonSession& session) const {
        return parameters_.visor && isArcWelding(session.lesson().process);
    }

    /// Returns true if the trainee sees little but the arc, through a dark visor.
    bool dark(const LessonSession& session) const {
        return session.running() && isArcWelding(session.lesson().process) && visor_.hides(parameters_);
    }

    /// Sets the contents of draw() other than the metal.
    void takeHands(const HeadsetHands& hands, const PanelPointer& panel);
    /// Draws both eyes. `lesson`: the lesson's scene of this frame; `place`: the place of its workpiece.
    void draw(LessonSession& session, const SceneView& lesson, const WorkpiecePlace& place, const Workshop& workshop,
              const xr::BothEyes& eyes, gl::Profiler* profiler);

  private:
    void takeArc(const LessonSession& session, const SceneView& scene, float zoom);
    void furnish(LessonSession& session, const SceneView& lesson, const WorkpiecePlace& place);
    void standCut(LessonSession& session, SceneView& scene) const;
    void wearVisor(const LessonSession& session, SceneView& scene, const View& between, std::span<const View> eyes,
                   LookParameters& look);

    const HeadsetParameters& parameters_;
    WorkshopScene scene_;
    HandsView hands_;
    std::vector<Solid> holders_; ///< of the workpiece, in the lesson's world
    Visor visor_;
    double sinceSeen_ = 0; ///< s since the eye last saw a picture
};

} // namespace meltpool
