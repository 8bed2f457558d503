// A headset with a person in it: what a frame loop has to do, in the order in which it has to do it.
#pragma once

#include "core/base/function_ref.hpp"
#include "core/base/work_meter.hpp"
#include "xr/headset_calls.hpp"
#include "xr/session/eye_targets.hpp"
#include "xr/session/panel.hpp"

#include <memory>

namespace meltpool::xr {

/// Both eyes of one frame and what they are drawn into: side by side, left eye left, for one submission or two.
struct BothEyes {
    std::array<EyeView, 2> views; ///< in the session's space
    GLuint framebuffer = 0;       ///< colour and depth, perhaps multisampled, 2 * width wide
    int width = 0;                ///< pixels, of one eye
    int height = 0;
    bool encodesSrgb = true; ///< the colour format is sRGB
    float nearZ = 0;         ///< m, what the depth layer says of the projection
    float farZ = 0;
};

/// One session on one instance. A frame is
///
///     poll(); if (!running()) wait otherwise;
///     timing = waitFrame(); look at input(); simulate;
///     beginFrame();                             // takes the head's pose: as late as can be
///     if (timing.shouldRender) drawEyes(...);
///     endFrame();
///
/// The runtime is called on a thread of its own. Once the calls of a frame have taken kPatience in all, the one that is
/// under way throws Stalled, and so does every other one until it is over; then poll() drops the frame that was given
/// up and goes on. Between calls everything may be looked at; while stalled only what says so.
class Headset {
  public:
    static constexpr std::chrono::milliseconds kPatience{500};

    /// Begins to open the session. The OpenGL context that is current now draws.
    Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings);
    ~Headset();

    /// The session is open. Throws XrFault or InputError (no usable format). Until then nothing else may be called.
    bool opened();
    /// Waits for that; throws as opened(), or Stalled after ten seconds.
    void waitUntilOpened();

    const Instance& instance() const { return *calls_->instance; }
    const Session& session() const { return *calls_->session; }
    const Input& input() const { return *calls_->input; }
    Panel& panel() { return *panel_; }
    const Panel& panel() const { return *panel_; }
    const EyeTargets& eyes() const { return *targets_; } ///< also while stalled
    const HeadsetSettings& settings() const { return settings_; }
    bool hasDepthLayer() const { return calls_->depthFormat != GL_NONE; }
    /// The binding's name: GLX, EGL, WGL.
    const char* bindingKind() const { return calls_->bindingKind; }

    void poll();
    bool running() const { return running_; }  ///< also while stalled
    SessionMode mode() const { return mode_; } ///< also while stalled
    bool stalled() const { return stalled_; }  ///< a call was given up and is not over yet, as far as known
    /// Waits for the next frame and reads the hands for it.
    FrameTiming waitFrame();
    void beginFrame();
    /// Where the eyes are at the frame's time; false where the head is not tracked.
    bool locateEyes(std::array<EyeView, 2>& eyes);
    /// Lets `draw` fill both eyes and resolves them. False, and nothing drawn, where the head is not tracked.
    bool drawEyes(FunctionRef<void(const BothEyes&)> draw);
    /// Shows the panel at this pose in this frame.
    void showPanel(const Pose& pose);
    /// What a hand, or what is wired to a tracker, feels from the end of the frame on; a silent pulse stops it.
    void play(Hand which, const HapticPulse& pulse);
    void playTracker(size_t which, const HapticPulse& pulse);
    void endFrame();
    void requestExit();

    /// Calls to the runtime's vibration so far; also while stalled.
    const Input::HapticCalls& hapticCalls() const { return hapticCalls_; }
    /// The views of the last drawEyes().
    const std::array<EyeView, 2>& views() const { return calls_->views; }

    /// Lets go without waiting; only destroying is left. True from when the instance is gone: another one may be made
    /// only then.
    std::shared_ptr<const std::atomic<bool>> leave();

  private:
    void call(CallThread::Call work, WorkPlace place = WorkPlace::runtime);
    void note();
    void finishOpening();

    HeadsetSettings settings_;
    HeadsetCalls* calls_; ///< belongs to the thread
    std::unique_ptr<CallThread> thread_;
    std::unique_ptr<EyeTargets> targets_;
    std::unique_ptr<Panel> panel_;
    std::chrono::steady_clock::duration patience_ = kPatience; ///< left for this frame
    bool heard_ = false; ///< what the runtime has to say, at the end of the last frame
    bool stalled_ = false;
    bool running_ = false;
    SessionMode mode_ = SessionMode::waiting;
    Input::HapticCalls hapticCalls_;
};

} // namespace meltpool::xr
