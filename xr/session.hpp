// Wraps one OpenXR session: its state machine, reference space and frame calls.
#pragma once

#include "core/base/function_ref.hpp"
#include "xr/graphics_binding.hpp"
#include "xr/instance.hpp"
#include "xr/pose.hpp"

#include <array>
#include <optional>
#include <utility>

namespace meltpool::xr {

/// The session's state, as far as the program needs it.
enum class SessionMode {
    waiting,      ///< not begun: the headset is not worn, or another program uses it
    synchronized, ///< the runtime asks for frames but does not show them
    visible,      ///< shown, without input (the runtime's own menu is over it)
    focused,      ///< shown, with input
    ended,        ///< the runtime asked the program to leave
    lost,         ///< a new session has to be opened
};

/// One eye: its pose in the reference space and its field of view.
struct EyeView {
    Pose pose;
    FieldOfView fov;
};

/// Result of xrWaitFrame.
struct FrameTiming {
    XrTime displayTime = 0; ///< nanoseconds on the runtime's clock
    double period = 0;      ///< seconds between displayed frames
    bool shouldRender = false;
};

/// Happenings that the runtime reported.
struct SessionNews {
    /// The reference space moved, or the person centred the view by the runtime's own button. A space on the floor may
    /// stay where it is then.
    bool spaceMoved = false;
    bool profileChanged = false; ///< a hand holds another controller
    std::optional<bool> worn;    ///< the headset was put on or taken off; needs RuntimeInfo::userPresence

    void add(const SessionNews& later);
};

class Session {
  public:
    /// `instance` outlives the session; the binding's context is current and stays so. Throws XrFault.
    Session(const Instance& instance, const GraphicsBinding& binding);
    /// Requests the end, submits empty frames until the runtime has ended the session (half a second at most), and
    /// destroys it. Never throws.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    XrSession handle() const { return session_; }
    const Instance& instance() const { return instance_; }
    /// STAGE or else LOCAL_FLOOR (both with the origin on the floor) if the runtime offers one of them, else LOCAL
    /// (origin near the head at start).
    XrSpace space() const { return space_; }
    XrReferenceSpaceType spaceType() const { return spaceType_; }
    bool originOnFloor() const { return spaceType_ != XR_REFERENCE_SPACE_TYPE_LOCAL; }

    SessionMode mode() const;
    bool running() const { return running_; }
    /// Handles all pending events.
    void poll();
    /// The news of all polls since the last call. A moved space waits for a frame whose `displayTime` has reached the
    /// change.
    SessionNews takeNews(XrTime displayTime);
    /// True once after the runtime changed the hidden parts of the eyes' pictures.
    bool takeMaskChange() { return std::exchange(maskChanged_, false); }
    /// Asks the runtime to end the session; poll() follows the states to its end.
    void requestExit();

    /// Blocks until the runtime wants the next frame. Only while running().
    FrameTiming waitFrame();
    void beginFrame();
    /// Ends an abandoned frame, without a picture.
    void dropFrame();
    /// Shows the layers (none: an empty picture) at the frame's time.
    void endFrame(XrTime displayTime, const XrCompositionLayerBaseHeader* const* layers, uint32_t count);

    /// Poses of both eyes at a time. False if the head is not tracked; `eyes` then keeps the last known views.
    bool locateEyes(XrTime time, std::array<EyeView, 2>& eyes) const;
    /// Pose of `space` in the reference space; `tracked`: position and orientation are measured, not guessed.
    bool locate(XrSpace space, XrTime time, Pose& pose, bool& tracked) const;

  private:
    void create(const GraphicsBinding& binding);
    void makeSpace();
    void onEvent(const XrEventDataBuffer& event);
    void onStateChanged(XrSessionState state);
    void onSpaceChange(const XrEventDataReferenceSpaceChangePending& change);
    void leave();

    const Instance& instance_;
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace space_ = XR_NULL_HANDLE;
    XrReferenceSpaceType spaceType_ = XR_REFERENCE_SPACE_TYPE_LOCAL;
    XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
    bool running_ = false;
    bool lost_ = false;
    bool waited_ = false; ///< true: waitFrame() returned a frame that has not begun
    bool inFrame_ = false;
    XrTime displayTime_ = 0; ///< time of the frame last waited for
    SessionNews news_;
    XrTime spaceMovesAt_ = 0;
    bool maskChanged_ = true;
};

} // namespace meltpool::xr
