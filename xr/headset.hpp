// Drives an open headset with the calls of a frame loop, in their order.
#pragma once

#include "core/base/function_ref.hpp"
#include "core/base/work_meter.hpp"
#include "xr/eye_targets.hpp"
#include "xr/panel.hpp"
#include "xr/runtime_worker.hpp"

#include <memory>

namespace meltpool::xr {

/// Both eyes of one frame and their frame buffer, next to each other, the left eye on the left.
struct BothEyes {
    std::array<EyeView, 2> views; ///< poses in the session's space
    GLuint framebuffer = 0;       ///< colour and depth, 2 * width wide; multisampled if HeadsetSettings asks for it
    int width = 0;                ///< pixels of one eye
    int height = 0;
    bool encodesSrgb = true; ///< the colour format is sRGB
    float nearZ = 0;         ///< m, near plane of the projection, for the depth layer
    float farZ = 0;
    HiddenTriangles hidden; ///< parts that the lenses do not show
};

/// One session on one instance. A frame is:
///
///     poll(); if (!running()) wait otherwise;
///     timing = waitFrame(); look at input(); simulate;
///     beginFrame();                             // takes the head's pose, as late as possible
///     if (timing.shouldRender) drawEyes(...);
///     endFrame();
///
/// A separate thread calls the runtime. When the calls of a frame have taken kPatience in all, the current call throws
/// Stalled, and so does every further call until the runtime has answered; then poll() continues. It drops that frame,
/// unless the runtime was only slow to say when the frame begins: a runtime that expects slow frames waits that long on
/// purpose, and learns that they are fast from frames submitted alone. While stalled only the functions marked so may
/// be called.
class Headset {
  public:
    static constexpr std::chrono::milliseconds kPatience{500};

    /// Starts opening the session. The eyes are drawn with the OpenGL context that is current now.
    Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings);
    ~Headset();

    /// True once the session is open; before that no other function may be called. Throws XrFault or InputError (no
    /// usable format).
    bool opened();
    /// Waits until the session is open; throws as opened(), or Stalled after ten seconds.
    void waitUntilOpened();

    const Instance& instance() const { return *worker_->instance; }
    const Session& session() const { return *worker_->session; }
    const Input& input() const { return *worker_->input; }
    Panel& panel() { return *panel_; }
    const Panel& panel() const { return *panel_; }
    const Panel& notice() const { return *notice_; }
    const EyeTargets& eyes() const { return *targets_; } ///< valid also while stalled
    const HeadsetSettings& settings() const { return settings_; }
    bool hasDepthLayer() const { return worker_->depthFormat != GL_NONE; }
    /// Things drawn into the eyes hide the panel and the notice behind them (XR_FB_composition_layer_depth_test).
    bool hasLayerDepthTest() const { return worker_->testsLayerDepth(); }
    /// The runtime reports when the headset is put on and taken off (SessionNews::worn).
    bool hasUserPresence() const { return worker_->instance->info().userPresence; }
    /// The binding's name: GLX, EGL, WGL.
    const char* bindingKind() const { return worker_->bindingKind; }

    void poll();
    bool running() const { return running_; }  ///< valid also while stalled
    SessionMode mode() const { return mode_; } ///< valid also while stalled
    bool stalled() const { return stalled_; }  ///< a call was abandoned and was still in progress at the last poll()
    /// Waits for the next frame and reads the hands and the news for it.
    FrameTiming waitFrame();
    /// Happenings since the last frame: valid from waitFrame() to the next poll(), else empty. Each is shown in one
    /// frame; if that frame is abandoned in waitFrame(), or the session does not run, in the next one.
    const SessionNews& news() const { return news_; }
    void beginFrame();
    /// Poses of the eyes at the frame's time; false if the head is not tracked.
    bool locateEyes(std::array<EyeView, 2>& eyes);
    /// Lets `draw` fill both eyes and resolves them. False, without drawing, if the head is not tracked.
    bool drawEyes(FunctionRef<void(const BothEyes&)> draw);
    /// Shows the panel at this pose in this frame.
    void showPanel(const Pose& pose);
    /// Shows the notice at this pose, so wide (m), in this frame. `fresh`: its picture was redrawn; else the last one
    /// is shown.
    void showNotice(const Pose& pose, float width, bool fresh);
    /// Vibrates a controller, or the device wired to a tracker, from the end of the frame on; a silent pulse stops it.
    void play(Hand which, const HapticPulse& pulse);
    void playTracker(size_t which, const HapticPulse& pulse);
    void endFrame();
    void requestExit();

    /// Counts of starts and stops of the runtime's vibration; also while stalled.
    const Input::HapticCalls& hapticCalls() const { return hapticCalls_; }
    /// The views of the last drawEyes().
    const std::array<EyeView, 2>& views() const { return worker_->views; }

    /// Abandons the session without waiting; afterwards only the destructor may be called. The returned flag becomes
    /// true when the instance is gone; only then another one may be made.
    std::shared_ptr<const std::atomic<bool>> leave();

  private:
    void call(CallThread::Call work, WorkPlace place = WorkPlace::runtime);
    void note();
    void awaitDrawing();
    void finishOpening();
    void show(Quad quad, const Panel& picture, const Pose& pose, bool fresh);

    HeadsetSettings settings_;
    RuntimeWorker* worker_; ///< owned by the thread
    std::unique_ptr<CallThread> thread_;
    std::unique_ptr<EyeTargets> targets_;
    std::unique_ptr<Panel> panel_;
    std::unique_ptr<Panel> notice_;
    std::chrono::steady_clock::duration patience_ = kPatience; ///< time left for the calls of this frame
    bool polled_ = false;                                      ///< the end of the last frame polled the events
    bool stalled_ = false;
    bool waitedLate_ = false; ///< the abandoned call was waitFrame(); later: it is over, and its frame is not yet used
    bool running_ = false;
    SessionMode mode_ = SessionMode::waiting;
    SessionNews news_;
    Input::HapticCalls hapticCalls_;
};

} // namespace meltpool::xr
