// The headset beside the desk: one object that the window's frame drives, whether a headset is there, asleep, lost or
// in use.
#pragma once

#include "app/headset/headset_panel.hpp"
#include "app/headset/held_torch.hpp"
#include "app/headset/tip_measuring.hpp"
#include "app/headset/torch_hold.hpp"
#include "app/headset/visor.hpp"
#include "app/headset/workshop_scene.hpp"
#include "core/render/renderer.hpp"
#include "core/training/feedback/haptics.hpp"
#include "xr/headset_connection.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <string>

namespace meltpool {

/// What the lesson shows and how large its model is.
struct LessonInSight {
    const SceneView* scene = nullptr;
    const LookParameters* look = nullptr;
    float unit = 1.0f;      ///< metres of a unit of the scene's world
    bool handLeads = false; ///< the lesson's torch is the one in the hand
    TipGap gap;             ///< of the lesson's process
    TipSounding sounding;   ///< newest known place of the metal under the torch in the hand
};

/// A frame is begin(), the simulation with torch(), draw(), end(); each does nothing while there is no frame for a
/// headset.
class HeadsetDesk {
  public:
    /// Looks for a headset from the first begin() on. The calibrations of controller and tracker are read from
    /// `torch-tip.txt` and `torch-tip-tracker.txt` in this folder where they are, and kept there.
    HeadsetDesk(const HeadsetParameters& parameters, const std::filesystem::path& folder);

    /// Waits for the headset's next frame and reads the hands. False: there is none now, the desk goes on alone.
    /// `bottom`: lowest place of the workpiece in its frame, m. `elapsed`: real seconds since the last call.
    bool begin(float bottom, double elapsed);

    /// The hand leads the torch: it is tracked, or was until it got lost (then the arc is out).
    bool leadsTorch() const { return inFrame_ && torch_.known(); }
    const HeldTorch& heldTorch() const { return torch_; }
    /// The other hand, which holds the filler rod: its grip in the workshop; nothing while it is not tracked.
    const std::optional<xr::Pose>& rod() const { return rod_; }
    /// The torch for step `step` of the `steps` of this frame, in the workpiece's frame.
    TorchSample torch(int step, int steps) const;

    bool inFrame() const { return inFrame_; }

    /// Both eyes, the visor's shade and the hands' vibration.
    void draw(Renderer& renderer, const LessonInSight& lesson, gl::Profiler* profiler);
    /// The panel is open. Its menu button opens it beside the workpiece and closes it.
    bool panelOpen() const { return panelOpen_; }
    bool panelShown() const { return inFrame_ && panelOpen_; }
    xr::PanelShape panelShape() const { return link_.headset()->panel().shape(); }
    /// Between draw() and end(): lets `fill` draw the panel's picture and shows it.
    void showPanel(FunctionRef<void(GLuint framebuffer, const PanelPointer& pointer)> fill);
    /// Hands the frame to the runtime.
    void end();

    /// Fills the viewport of the current draw frame buffer with the left eye's picture, cut to the viewport's shape.
    /// False while there is none.
    bool mirror(GLuint framebuffer, const Viewport& viewport) const;

    xr::ConnectionState state() const { return link_.state(); }
    /// The session's mode in a word; empty while there is none.
    std::string sessionMode() const;
    /// For the desk: what the headset does, or why there is none.
    std::string status() const;
    /// A warning for the trainee and the teacher; empty while all is well.
    std::string_view warning() const;
    int openings() const { return link_.openings(); }
    void recentre() { recentreAsked_ = true; }

    /// Measures the tip of the torch, or the way it points, from the poses of the next seconds.
    void measureTip() { measuring_.begin(TipMeasuring::Task::pivot); }
    void measureAxis() { measuring_.begin(TipMeasuring::Task::axis); }
    /// What the measuring wants or has found; empty where none was asked for.
    std::string tipReport() const { return measuring_.report(); }
    void close() { link_.close(); }

    /// What happens at the tip, and what the hand is made to feel of it.
    const TipSounding& sounding() const { return sounding_; }
    const TipTouch& touch() const { return touch_; }
    unsigned pulsesSent() const;
    const TipFeel& tipFeel() const { return feel_; }
    const Vibration& vibration() const { return vibration_; }

    /// CPU time of this object in the last frame, s, without waiting for the runtime.
    double busySeconds() const { return busy_; }

  private:
    using Clock = std::chrono::steady_clock;

    void readHands(double elapsed);
    void holdTorch(double elapsed);
    void placeWorkshop();
    void placePanel();
    void point();
    bool pointWith(xr::Hand which);
    xr::Pose panelPose() const; ///< in the workshop
    void drawEyes(Renderer& renderer, const LessonInSight& lesson, const xr::BothEyes& eyes, gl::Profiler* profiler);
    void vibrate(const LessonInSight& lesson);
    void play(const Vibration& vibration);
    void guarded(FunctionRef<void()> work);

    const HeadsetParameters& parameters_;
    std::array<CalibrationFile, 2> calibrations_; ///< by TorchHolder
    TipMeasuring measuring_;
    TorchHold hold_;
    xr::HeadsetConnection link_;
    Workshop workshop_;
    WorkpiecePlace place_;
    HeldTorch torch_;
    std::optional<xr::Pose> rod_;
    Visor visor_;
    WorkshopScene scene_;
    xr::FrameTiming timing_;
    xr::Hand torchHand_ = xr::Hand::right;
    bool inFrame_ = false;
    bool drawn_ = false;
    bool pointing_ = false;
    bool recentreAsked_ = false;
    bool panelOpen_ = false;
    xr::Hand pointingHand_ = xr::Hand::right; ///< opened the panel, or pulled its trigger at it last
    PanelPointer pointer_;
    xr::Pose pointingRay_; ///< of the hand that points at the panel, in the workshop
    glm::vec3 pointedAt_{0.0f};
    double busy_ = 0;
    double time_ = 0;
    double elapsed_ = 0; ///< real seconds since the frame before
    TipSounding sounding_;
    TipTouch touch_;
    TipFeel feel_;
    Vibration vibration_;
    TorchHolder felt_ = TorchHolder::hand; ///< what was made to vibrate last, and which hand
    xr::Hand feltHand_ = xr::Hand::right;
};

} // namespace meltpool
