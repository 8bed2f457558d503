// One OpenXR session: its state machine, reference space and frame calls.
#pragma once

#include "core/base/function_ref.hpp"
#include "xr/session/graphics_binding.hpp"
#include "xr/session/instance.hpp"
#include "xr/session/pose.hpp"

#include <array>

namespace meltpool::xr {

/// What the runtime wants of the session at the moment.
enum class SessionMode {
    waiting,      ///< not begun: the headset sleeps or another program has it
    synchronized, ///< frames are asked for but not shown
    visible,      ///< shown, without input (the runtime's own menu is over it)
    focused,      ///< shown, with input
    ended,        ///< the runtime asked the program to leave
    lost,         ///< gone; has to be opened anew
};

/// One eye: where it is in the reference space and what it sees.
struct EyeView {
    Pose pose;
    FieldOfView fov;
};

/// The answer to xrWaitFrame.
struct FrameTiming {
    XrTime displayTime = 0; ///< nanoseconds on the runtime's clock
    double period = 0;      ///< seconds between displayed frames
    bool shouldRender = false;
};

class Session {
  public:
    /// `instance` outlives the session; the binding's context is current and stays so. Throws XrFault.
    Session(const Instance& instance, const GraphicsBinding& binding);
    /// Asks for the end, sees the runtime through it for a moment, and lets go. Never throws.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    XrSession handle() const { return session_; }
    const Instance& instance() const { return instance_; }
    /// STAGE (origin on the floor) where the runtime offers it, else LOCAL (origin near the head at start).
    XrSpace space() const { return space_; }
    bool originOnFloor() const { return stage_; }

    SessionMode mode() const;
    bool running() const { return running_; }
    /// Takes note of everything that the runtime has to say. `onOther` sees the events that are not the session's own.
    void poll(FunctionRef<void(const XrEventDataBuffer&)> onOther = {});
    /// The person wants to leave; the rest happens in poll().
    void requestExit();

    /// Blocks until the runtime wants the next frame. Only while running().
    FrameTiming waitFrame();
    void beginFrame();
    /// Brings a frame that was given up in its middle to its end, showing nothing.
    void dropFrame();
    /// Shows the layers (none: nothing) at the frame's time.
    void endFrame(XrTime displayTime, const XrCompositionLayerBaseHeader* const* layers, uint32_t count);

    /// Both eyes at a time. False where the head is not tracked; the last known views stay in `eyes` then.
    bool locateEyes(XrTime time, std::array<EyeView, 2>& eyes) const;
    /// Where `space` is in the reference space; `tracked`: position and orientation are measured, not guessed.
    bool locate(XrSpace space, XrTime time, Pose& pose, bool& tracked) const;

  private:
    void create(const GraphicsBinding& binding);
    void makeSpace();
    void onStateChanged(XrSessionState state);
    void leave();

    const Instance& instance_;
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace space_ = XR_NULL_HANDLE;
    bool stage_ = false;
    XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
    bool running_ = false;
    bool lost_ = false;
    bool waited_ = false; ///< for a frame that was not begun yet
    bool inFrame_ = false;
    XrTime displayTime_ = 0; ///< of the frame that was waited for last
};

} // namespace meltpool::xr
