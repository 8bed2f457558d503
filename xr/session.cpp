// Creates the session, follows its states, and ends it.
#include "xr/platform.hpp"

#include "xr/newer_openxr.hpp"
#include "xr/session.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace meltpool::xr {

namespace {

/// A runtime announces a change some frames ahead; a change farther away is a mistake of its clock.
constexpr XrTime kLongestNotice = 1'000'000'000; // ns

constexpr XrPosef kIdentity{{0, 0, 0, 1}, {0, 0, 0}};

/// A runtime refuses to create a session before it was asked for its supported OpenGL versions.
void askOpenGlRequirements(const Instance& instance) {
    const auto ask = instance.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>("xrGetOpenGLGraphicsRequirementsKHR");
    if (ask == nullptr)
        throw InputError("the OpenXR runtime names no OpenGL version; expected a runtime with OpenGL support");
    XrGraphicsRequirementsOpenGLKHR needed{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
    MELTPOOL_XR(ask(instance.handle(), instance.system(), &needed));
    const XrVersion ours = XR_MAKE_VERSION(4, 5, 0);
    if (ours < needed.minApiVersionSupported)
        throw InputError("the OpenXR runtime needs OpenGL " +
                         std::to_string(XR_VERSION_MAJOR(needed.minApiVersionSupported)) + "." +
                         std::to_string(XR_VERSION_MINOR(needed.minApiVersionSupported)) + "; expected at most 4.5");
}

} // namespace

void SessionNews::add(const SessionNews& later) {
    spaceMoved = spaceMoved || later.spaceMoved;
    profileChanged = profileChanged || later.profileChanged;
    if (later.worn) worn = later.worn;
}

Session::Session(const Instance& instance, const GraphicsBinding& binding) : instance_(instance) {
    if (binding.extension() != nullptr && !instance.has(binding.extension()))
        throw InputError(std::string("the OpenXR runtime does not take an OpenGL context made by ") + binding.kind() +
                         "; expected a window's context, or a runtime with " + binding.extension());
    askOpenGlRequirements(instance);
    create(binding);
    try {
        makeSpace();
    } catch (...) {
        xrDestroySession(session_);
        throw;
    }
}

Session::~Session() {
    leave();
    const ContextGuard guard;
    if (space_ != XR_NULL_HANDLE) xrDestroySpace(space_);
    xrDestroySession(session_);
}

void Session::create(const GraphicsBinding& binding) {
    const ContextGuard guard;
    XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO};
    info.next = binding.next();
    info.systemId = instance_.system();
    MELTPOOL_XR(xrCreateSession(instance_.handle(), &info, &session_));
}

void Session::makeSpace() {
    uint32_t count = 0;
    MELTPOOL_XR(xrEnumerateReferenceSpaces(session_, 0, &count, nullptr));
    std::vector<XrReferenceSpaceType> types(count);
    MELTPOOL_XR(xrEnumerateReferenceSpaces(session_, count, &count, types.data()));
    const auto offered = [&](XrReferenceSpaceType type) {
        return std::find(types.begin(), types.end(), type) != types.end();
    };
    if (offered(XR_REFERENCE_SPACE_TYPE_STAGE))
        spaceType_ = XR_REFERENCE_SPACE_TYPE_STAGE;
    else if (instance_.has("XR_EXT_local_floor") && offered(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT))
        spaceType_ = XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT;
    XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
    info.referenceSpaceType = spaceType_;
    info.poseInReferenceSpace = kIdentity;
    MELTPOOL_XR(xrCreateReferenceSpace(session_, &info, &space_));
}

SessionMode Session::mode() const {
    if (lost_) return SessionMode::lost;
    switch (state_) {
    case XR_SESSION_STATE_SYNCHRONIZED:
        return SessionMode::synchronized;
    case XR_SESSION_STATE_VISIBLE:
        return SessionMode::visible;
    case XR_SESSION_STATE_FOCUSED:
        return SessionMode::focused;
    case XR_SESSION_STATE_LOSS_PENDING:
        return SessionMode::lost;
    case XR_SESSION_STATE_EXITING:
        return SessionMode::ended;
    default:
        return SessionMode::waiting;
    }
}

void Session::onStateChanged(XrSessionState state) {
    state_ = state;
    switch (state) {
    case XR_SESSION_STATE_IDLE: // created, or the headset was taken off: wait for READY
        break;
    case XR_SESSION_STATE_READY: { // the headset is worn
        XrSessionBeginInfo begin{XR_TYPE_SESSION_BEGIN_INFO};
        begin.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
        MELTPOOL_XR(xrBeginSession(session_, &begin));
        running_ = true;
        break;
    }
    case XR_SESSION_STATE_SYNCHRONIZED: // frames are paced
    case XR_SESSION_STATE_VISIBLE:      // frames are shown
    case XR_SESSION_STATE_FOCUSED:      // controllers respond
        break;
    case XR_SESSION_STATE_STOPPING: // the headset was taken off, or requestExit() was called
        running_ = false;
        MELTPOOL_XR(xrEndSession(session_));
        break;
    case XR_SESSION_STATE_LOSS_PENDING: // the headset or the runtime goes away
        running_ = false;
        lost_ = true;
        break;
    case XR_SESSION_STATE_EXITING: // the runtime wants the program to end the session
        running_ = false;
        break;
    default:
        break;
    }
}

void Session::poll() {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    while (MELTPOOL_XR(xrPollEvent(instance_.handle(), &event)) == XR_SUCCESS) {
        onEvent(event);
        event = {XR_TYPE_EVENT_DATA_BUFFER};
    }
}

void Session::onEvent(const XrEventDataBuffer& event) {
    switch (static_cast<int>(event.type)) { // an older header does not list every event
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED:
        onStateChanged(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
        break;
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
        lost_ = true;
        running_ = false;
        break;
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING:
        onSpaceChange(reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event));
        break;
    case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED:
        news_.profileChanged = true;
        break;
    case XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR:
        maskChanged_ = true;
        break;
    case XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT:
        news_.worn = reinterpret_cast<const XrEventDataUserPresenceChangedEXT&>(event).isUserPresent == XR_TRUE;
        break;
    default:
        break;
    }
}

void Session::onSpaceChange(const XrEventDataReferenceSpaceChangePending& change) {
    // With STAGE the runtime's own centring moves only LOCAL, but the person wants the workshop in front all the same.
    if (change.referenceSpaceType != spaceType_ && change.referenceSpaceType != XR_REFERENCE_SPACE_TYPE_LOCAL) return;
    news_.spaceMoved = true;
    spaceMovesAt_ = change.changeTime;
}

SessionNews Session::takeNews(XrTime displayTime) {
    SessionNews taken = std::exchange(news_, {});
    const bool ahead = spaceMovesAt_ > displayTime && spaceMovesAt_ - displayTime < kLongestNotice;
    if (taken.spaceMoved && ahead) {
        news_.spaceMoved = true;
        taken.spaceMoved = false;
    }
    return taken;
}

void Session::requestExit() {
    if (running_) MELTPOOL_XR(xrRequestExitSession(session_));
}

void Session::leave() {
    using namespace std::chrono_literals;
    if (!running_ || lost_) return;
    try {
        dropFrame();
        requestExit();
        // The runtime changes its state only while it gets frames; it may also not answer at all.
        for (const auto end = std::chrono::steady_clock::now() + 500ms; std::chrono::steady_clock::now() < end;) {
            poll();
            if (!running_) break;
            const FrameTiming timing = waitFrame();
            beginFrame();
            endFrame(timing.displayTime, nullptr, 0);
        }
        for (int i = 0; i < 20 && state_ != XR_SESSION_STATE_EXITING; ++i) {
            poll();
            std::this_thread::sleep_for(5ms);
        }
    } catch (const std::exception&) {
        lost_ = true; // the runtime failed; the session counts as lost
    }
}

FrameTiming Session::waitFrame() {
    const ContextGuard guard;
    XrFrameState state{XR_TYPE_FRAME_STATE};
    const InWork waiting(WorkPlace::waiting);
    MELTPOOL_XR(xrWaitFrame(session_, nullptr, &state));
    waited_ = true;
    displayTime_ = state.predictedDisplayTime;
    return {state.predictedDisplayTime, static_cast<double>(state.predictedDisplayPeriod) * 1e-9,
            state.shouldRender == XR_TRUE};
}

void Session::beginFrame() {
    const ContextGuard guard;
    waited_ = false;
    MELTPOOL_XR(xrBeginFrame(session_, nullptr));
    inFrame_ = true;
}

void Session::dropFrame() {
    if (waited_) beginFrame();
    if (inFrame_) endFrame(displayTime_, nullptr, 0);
}

void Session::endFrame(XrTime displayTime, const XrCompositionLayerBaseHeader* const* layers, uint32_t count) {
    const ContextGuard guard;
    inFrame_ = false;
    XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO};
    end.displayTime = displayTime;
    end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    end.layerCount = count;
    end.layers = layers;
    MELTPOOL_XR(xrEndFrame(session_, &end));
}

bool Session::locateEyes(XrTime time, std::array<EyeView, 2>& eyes) const {
    XrViewLocateInfo locate{XR_TYPE_VIEW_LOCATE_INFO};
    locate.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    locate.displayTime = time;
    locate.space = space_;
    XrViewState state{XR_TYPE_VIEW_STATE};
    std::array<XrView, 2> views{XrView{XR_TYPE_VIEW}, XrView{XR_TYPE_VIEW}};
    uint32_t count = 0;
    MELTPOOL_XR(xrLocateViews(session_, &locate, &state, uint32_t(views.size()), &count, views.data()));
    constexpr XrViewStateFlags known = XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    if (count != views.size() || (state.viewStateFlags & known) != known) return false;
    for (size_t i = 0; i < views.size(); ++i)
        eyes[i] = {fromXr(views[i].pose), fromXr(views[i].fov)};
    return true;
}

bool Session::locate(XrSpace space, XrTime time, Pose& pose, bool& tracked) const {
    XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
    MELTPOOL_XR(xrLocateSpace(space, space_, time, &location));
    constexpr XrSpaceLocationFlags known =
        XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
    constexpr XrSpaceLocationFlags measured =
        known | XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
    tracked = (location.locationFlags & measured) == measured;
    if ((location.locationFlags & known) != known) return false;
    pose = fromXr(location.pose);
    return true;
}

} // namespace meltpool::xr
