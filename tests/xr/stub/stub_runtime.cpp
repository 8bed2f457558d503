// Implements the functions of the OpenXR API that the program calls.
#include "tests/xr/stub/stub_runtime.hpp"

#include "xr/headset.hpp"

#include <array>
#include <chrono>
#include <cstring>
#include <thread>

namespace meltpool::test {

void StubRuntime::hang() {
    const std::lock_guard lock(mutex_);
    hangs_ = true;
}

void StubRuntime::goOn() {
    const std::lock_guard lock(mutex_);
    hangs_ = false;
    changed_.notify_all();
}

XrResult StubRuntime::call() {
    std::unique_lock lock(mutex_);
    ++hanging_;
    changed_.wait(lock, [this] { return !hangs_; });
    --hanging_;
    return lost_ ? XR_ERROR_INSTANCE_LOST : XR_SUCCESS;
}

void StubRuntime::onFrame(bool pictures) {
    ++frames_;
    if (pictures && slowFrames_ > 0) --slowFrames_;
}

void StubRuntime::changeState(XrSessionState state) {
    const std::lock_guard lock(mutex_);
    states_.push_back(state);
}

bool StubRuntime::takeEvent(XrEventDataBuffer& event) {
    const std::lock_guard lock(mutex_);
    if (states_.empty()) return false;
    XrEventDataSessionStateChanged told{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
    told.state = states_.front();
    states_.pop_front();
    std::memcpy(&event, &told, sizeof told);
    return true;
}

void StubRuntime::onInstance(int change) {
    const std::lock_guard lock(mutex_);
    instances_ += change;
    states_.clear();
    if (change > 0) lost_ = false;
}

StubRuntime& stubRuntime() {
    static StubRuntime only;
    return only;
}

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kPeriod = 2'000'000; // ns: faster than any display, so that the threads meet often
constexpr std::chrono::nanoseconds kSlowPeriod = xr::Headset::kPatience + std::chrono::milliseconds(100);

/// Makes a handle that no two objects share.
template <class Handle>
Handle newHandle() {
    static std::atomic<std::uintptr_t> last = 0;
    return reinterpret_cast<Handle>(++last);
}

/// Fills a list as OpenXR does: the count alone, or the values too.
template <class Value, size_t size>
XrResult answerList(const std::array<Value, size>& values, uint32_t capacity, uint32_t* count, Value* out) {
    *count = size;
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < size) return XR_ERROR_SIZE_INSUFFICIENT;
    for (const Value& value : values)
        *out++ = value;
    return XR_SUCCESS;
}

constexpr XrPosef kIdentity{{0, 0, 0, 1}, {0, 0, 0}};

/// Holds the textures of a swapchain.
struct StubImages {
    std::array<GLuint, 2> textures{};
    uint32_t next = 0;
};

XrResult openGlRequirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR* needed) {
    needed->minApiVersionSupported = XR_MAKE_VERSION(4, 5, 0);
    needed->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
    return XR_SUCCESS;
}

} // namespace

} // namespace meltpool::test

using namespace meltpool::test;

extern "C" {

XrResult xrEnumerateInstanceExtensionProperties(const char*, uint32_t capacity, uint32_t* count,
                                                XrExtensionProperties* out) {
    constexpr std::array names{"XR_KHR_opengl_enable", "XR_MNDX_egl_enable", "XR_KHR_composition_layer_depth"};
    *count = names.size();
    for (uint32_t i = 0; i < capacity; ++i)
        std::strncpy(out[i].extensionName, names[i], XR_MAX_EXTENSION_NAME_SIZE - 1);
    return XR_SUCCESS;
}

XrResult xrCreateInstance(const XrInstanceCreateInfo*, XrInstance* instance) {
    stubRuntime().onInstance(1);
    *instance = newHandle<XrInstance>();
    return XR_SUCCESS;
}

XrResult xrDestroyInstance(XrInstance) {
    stubRuntime().onInstance(-1);
    return XR_SUCCESS;
}

XrResult xrGetInstanceProperties(XrInstance, XrInstanceProperties* properties) {
    properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
    std::strcpy(properties->runtimeName, "stub");
    return XR_SUCCESS;
}

XrResult xrGetInstanceProcAddr(XrInstance, const char* name, PFN_xrVoidFunction* function) {
    if (std::strcmp(name, "xrGetOpenGLGraphicsRequirementsKHR") != 0) return XR_ERROR_FUNCTION_UNSUPPORTED;
    *function = reinterpret_cast<PFN_xrVoidFunction>(openGlRequirements);
    return XR_SUCCESS;
}

XrResult xrGetSystem(XrInstance, const XrSystemGetInfo*, XrSystemId* system) {
    *system = 1;
    return XR_SUCCESS;
}

XrResult xrGetSystemProperties(XrInstance, XrSystemId, XrSystemProperties* properties) {
    std::strcpy(properties->systemName, "stub headset");
    properties->trackingProperties.positionTracking = XR_TRUE;
    return XR_SUCCESS;
}

XrResult xrStringToPath(XrInstance, const char* text, XrPath* path) {
    *path = std::hash<std::string_view>()(text) | 1u;
    return XR_SUCCESS;
}

XrResult xrPathToString(XrInstance, XrPath, uint32_t capacity, uint32_t* length, char* text) {
    *length = 1;
    if (capacity > 0) *text = 0;
    return XR_SUCCESS;
}

XrResult xrPollEvent(XrInstance, XrEventDataBuffer* event) {
    if (const XrResult result = stubRuntime().call(); XR_FAILED(result)) return result;
    return stubRuntime().takeEvent(*event) ? XR_SUCCESS : XR_EVENT_UNAVAILABLE;
}

XrResult xrEnumerateViewConfigurationViews(XrInstance, XrSystemId, XrViewConfigurationType, uint32_t capacity,
                                           uint32_t* count, XrViewConfigurationView* out) {
    XrViewConfigurationView view{XR_TYPE_VIEW_CONFIGURATION_VIEW};
    view.recommendedImageRectWidth = view.recommendedImageRectHeight = 64;
    view.maxImageRectWidth = view.maxImageRectHeight = 256;
    view.recommendedSwapchainSampleCount = view.maxSwapchainSampleCount = 1;
    return answerList(std::array{view, view}, capacity, count, out);
}

XrResult xrCreateSession(XrInstance, const XrSessionCreateInfo*, XrSession* session) {
    *session = newHandle<XrSession>();
    stubRuntime().changeState(XR_SESSION_STATE_IDLE);
    stubRuntime().changeState(XR_SESSION_STATE_READY);
    return XR_SUCCESS;
}

XrResult xrDestroySession(XrSession) {
    return XR_SUCCESS;
}

XrResult xrBeginSession(XrSession, const XrSessionBeginInfo*) {
    for (const XrSessionState state :
         {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED})
        stubRuntime().changeState(state);
    return XR_SUCCESS;
}

XrResult xrEndSession(XrSession) {
    stubRuntime().changeState(XR_SESSION_STATE_IDLE);
    stubRuntime().changeState(XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
}

XrResult xrRequestExitSession(XrSession) {
    stubRuntime().changeState(XR_SESSION_STATE_STOPPING);
    return XR_SUCCESS;
}

XrResult xrEnumerateReferenceSpaces(XrSession, uint32_t capacity, uint32_t* count, XrReferenceSpaceType* out) {
    return answerList(std::array{XR_REFERENCE_SPACE_TYPE_LOCAL, XR_REFERENCE_SPACE_TYPE_STAGE}, capacity, count, out);
}

XrResult xrCreateReferenceSpace(XrSession, const XrReferenceSpaceCreateInfo*, XrSpace* space) {
    *space = newHandle<XrSpace>();
    return XR_SUCCESS;
}

XrResult xrCreateActionSpace(XrSession, const XrActionSpaceCreateInfo*, XrSpace* space) {
    *space = newHandle<XrSpace>();
    return XR_SUCCESS;
}

XrResult xrDestroySpace(XrSpace) {
    return XR_SUCCESS;
}

XrResult xrLocateSpace(XrSpace, XrSpace, XrTime, XrSpaceLocation* location) {
    location->locationFlags = XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
                              XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
    location->pose = kIdentity;
    return stubRuntime().call();
}

XrResult xrLocateViews(XrSession, const XrViewLocateInfo*, XrViewState* state, uint32_t capacity, uint32_t* count,
                       XrView* out) {
    state->viewStateFlags = XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    XrView view{XR_TYPE_VIEW};
    view.pose = kIdentity;
    view.fov = {-0.7f, 0.7f, 0.7f, -0.7f};
    answerList(std::array{view, view}, capacity, count, out);
    return stubRuntime().call();
}

XrResult xrEnumerateSwapchainFormats(XrSession, uint32_t capacity, uint32_t* count, int64_t* out) {
    return answerList(std::array<int64_t, 2>{GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT32F}, capacity, count, out);
}

XrResult xrCreateSwapchain(XrSession, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
    auto* made = new StubImages;
    glCreateTextures(GL_TEXTURE_2D, GLsizei(made->textures.size()), made->textures.data());
    for (const GLuint texture : made->textures)
        glTextureStorage2D(texture, 1, GLenum(info->format), GLsizei(info->width), GLsizei(info->height));
    *swapchain = reinterpret_cast<XrSwapchain>(made);
    return XR_SUCCESS;
}

XrResult xrDestroySwapchain(XrSwapchain swapchain) {
    auto* images = reinterpret_cast<StubImages*>(swapchain);
    glDeleteTextures(GLsizei(images->textures.size()), images->textures.data());
    delete images;
    return XR_SUCCESS;
}

XrResult xrEnumerateSwapchainImages(XrSwapchain swapchain, uint32_t capacity, uint32_t* count,
                                    XrSwapchainImageBaseHeader* out) {
    const auto* images = reinterpret_cast<const StubImages*>(swapchain);
    *count = uint32_t(images->textures.size());
    for (uint32_t i = 0; i < capacity; ++i)
        reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out)[i].image = images->textures[i];
    return XR_SUCCESS;
}

XrResult xrAcquireSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo*, uint32_t* index) {
    auto* images = reinterpret_cast<StubImages*>(swapchain);
    *index = images->next;
    images->next = (images->next + 1) % uint32_t(images->textures.size());
    return stubRuntime().call();
}

XrResult xrWaitSwapchainImage(XrSwapchain, const XrSwapchainImageWaitInfo*) {
    return stubRuntime().call();
}

XrResult xrReleaseSwapchainImage(XrSwapchain, const XrSwapchainImageReleaseInfo*) {
    return stubRuntime().call();
}

XrResult xrWaitFrame(XrSession, const XrFrameWaitInfo*, XrFrameState* state) {
    std::this_thread::sleep_for(stubRuntime().slowFrames() > 0 ? kSlowPeriod : std::chrono::nanoseconds(kPeriod));
    state->predictedDisplayTime = Clock::now().time_since_epoch().count() + kPeriod;
    state->predictedDisplayPeriod = kPeriod;
    state->shouldRender = XR_TRUE;
    return stubRuntime().call();
}

XrResult xrBeginFrame(XrSession, const XrFrameBeginInfo*) {
    return stubRuntime().call();
}

XrResult xrEndFrame(XrSession, const XrFrameEndInfo* info) {
    const XrResult result = stubRuntime().call();
    if (XR_SUCCEEDED(result)) stubRuntime().onFrame(info->layerCount > 0);
    return result;
}

XrResult xrCreateActionSet(XrInstance, const XrActionSetCreateInfo*, XrActionSet* set) {
    *set = newHandle<XrActionSet>();
    return XR_SUCCESS;
}

XrResult xrDestroyActionSet(XrActionSet) {
    return XR_SUCCESS;
}

XrResult xrCreateAction(XrActionSet, const XrActionCreateInfo*, XrAction* action) {
    *action = newHandle<XrAction>();
    return XR_SUCCESS;
}

XrResult xrSuggestInteractionProfileBindings(XrInstance, const XrInteractionProfileSuggestedBinding*) {
    return XR_SUCCESS;
}

XrResult xrAttachSessionActionSets(XrSession, const XrSessionActionSetsAttachInfo*) {
    return XR_SUCCESS;
}

XrResult xrSyncActions(XrSession, const XrActionsSyncInfo*) {
    return stubRuntime().call();
}

XrResult xrGetActionStateBoolean(XrSession, const XrActionStateGetInfo*, XrActionStateBoolean* state) {
    state->isActive = XR_TRUE;
    return XR_SUCCESS;
}

XrResult xrGetActionStateFloat(XrSession, const XrActionStateGetInfo*, XrActionStateFloat* state) {
    state->isActive = XR_TRUE;
    state->currentState = 0.5f;
    return XR_SUCCESS;
}

XrResult xrGetActionStateVector2f(XrSession, const XrActionStateGetInfo*, XrActionStateVector2f* state) {
    state->isActive = XR_TRUE;
    return XR_SUCCESS;
}

XrResult xrGetActionStatePose(XrSession, const XrActionStateGetInfo*, XrActionStatePose* state) {
    state->isActive = XR_TRUE;
    return XR_SUCCESS;
}

XrResult xrGetCurrentInteractionProfile(XrSession, XrPath, XrInteractionProfileState* state) {
    state->interactionProfile = XR_NULL_PATH;
    return XR_SUCCESS;
}

XrResult xrApplyHapticFeedback(XrSession, const XrHapticActionInfo*, const XrHapticBaseHeader*) {
    return stubRuntime().call();
}

XrResult xrStopHapticFeedback(XrSession, const XrHapticActionInfo*) {
    return stubRuntime().call();
}

} // extern "C"
