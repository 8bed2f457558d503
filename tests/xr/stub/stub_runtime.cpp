// Implements the functions of the OpenXR API that the program calls.
#include "tests/xr/stub/stub_runtime.hpp"

#include "xr/headset.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
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

namespace {

StubLayer noteLayer(const XrCompositionLayerBaseHeader& layer) {
    StubLayer noted{layer.type};
    for (const auto* next = static_cast<const XrBaseInStructure*>(layer.next); next != nullptr; next = next->next) {
        if (next->type != XR_TYPE_COMPOSITION_LAYER_DEPTH_TEST_FB) continue;
        const auto& test = *reinterpret_cast<const XrCompositionLayerDepthTestFB*>(next);
        noted.tested = true;
        noted.writesDepth = test.depthMask == XR_TRUE;
        noted.compare = test.compareOp;
    }
    return noted;
}

} // namespace

void StubRuntime::onFrame(const XrFrameEndInfo& frame) {
    ++frames_;
    if (frame.layerCount == 0) return;
    if (slowFrames_ > 0) --slowFrames_;
    const std::lock_guard lock(mutex_);
    layers_.clear();
    for (uint32_t i = 0; i < frame.layerCount; ++i)
        layers_.push_back(noteLayer(*frame.layers[i]));
}

StubDevice StubRuntime::device() const {
    const std::lock_guard lock(mutex_);
    return device_;
}

void StubRuntime::setDevice(const StubDevice& device) {
    const std::lock_guard lock(mutex_);
    device_ = device;
}

template <class Event>
void StubRuntime::send(const Event& event) {
    static_assert(sizeof event <= sizeof(XrEventDataBuffer));
    const std::lock_guard lock(mutex_);
    XrEventDataBuffer& buffer = events_.emplace_back();
    std::memcpy(&buffer, &event, sizeof event);
}

void StubRuntime::changeState(XrSessionState state) {
    XrEventDataSessionStateChanged event{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
    event.state = state;
    send(event);
}

void StubRuntime::moveSpace(XrReferenceSpaceType type, XrTime at) {
    XrEventDataReferenceSpaceChangePending event{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING};
    event.referenceSpaceType = type;
    event.changeTime = at;
    send(event);
}

void StubRuntime::wear(bool worn) {
    if (!enabled("XR_EXT_user_presence")) return;
    XrEventDataUserPresenceChangedEXT event{XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT};
    event.isUserPresent = worn ? XR_TRUE : XR_FALSE;
    send(event);
}

void StubRuntime::changeController(float lean) {
    {
        const std::lock_guard lock(mutex_);
        device_.lean = lean;
    }
    send(XrEventDataInteractionProfileChanged{XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED});
}

void StubRuntime::changeMask(float hidden) {
    {
        const std::lock_guard lock(mutex_);
        device_.hidden = hidden;
    }
    send(XrEventDataVisibilityMaskChangedKHR{XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR});
}

bool StubRuntime::takeEvent(XrEventDataBuffer& event) {
    const std::lock_guard lock(mutex_);
    if (events_.empty()) return false;
    event = events_.front();
    events_.pop_front();
    return true;
}

void StubRuntime::onEnabled(std::vector<std::string> extensions) {
    const std::lock_guard lock(mutex_);
    enabled_ = std::move(extensions);
    requestedRate_ = 0;
    sustained_ = 0;
}

bool StubRuntime::enabled(const std::string& extension) const {
    const std::lock_guard lock(mutex_);
    return std::find(enabled_.begin(), enabled_.end(), extension) != enabled_.end();
}

void StubRuntime::onAction(XrAction action, const char* name) {
    const std::lock_guard lock(mutex_);
    actions_[action] = name;
}

void StubRuntime::onActionSpace(XrSpace space, XrAction action) {
    const std::lock_guard lock(mutex_);
    actionSpaces_[space] = actions_[action];
}

XrPosef StubRuntime::pose(XrSpace space) const {
    XrPosef pose{{0, 0, 0, 1}, {0, 0, 0}};
    const std::lock_guard lock(mutex_);
    const auto found = actionSpaces_.find(space);
    if (found == actionSpaces_.end() || found->second != "aim") return pose;
    pose.orientation.x = std::sin(device_.lean / 2);
    pose.orientation.w = std::cos(device_.lean / 2);
    return pose;
}

void StubRuntime::onRate(float rate) {
    const std::lock_guard lock(mutex_);
    requestedRate_ = rate;
}

float StubRuntime::requestedRate() const {
    const std::lock_guard lock(mutex_);
    return requestedRate_;
}

void StubRuntime::onSustained() {
    const std::lock_guard lock(mutex_);
    ++sustained_;
}

int StubRuntime::sustainedProcessors() const {
    const std::lock_guard lock(mutex_);
    return sustained_;
}

std::vector<StubLayer> StubRuntime::layers() const {
    const std::lock_guard lock(mutex_);
    return layers_;
}

void StubRuntime::onInstance(int change) {
    const std::lock_guard lock(mutex_);
    instances_ += change;
    events_.clear();
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

XrResult enumerateRates(XrSession, uint32_t capacity, uint32_t* count, float* out) {
    const std::vector<float> rates = stubRuntime().device().rates;
    *count = uint32_t(rates.size());
    for (uint32_t i = 0; i < capacity; ++i)
        out[i] = rates[i];
    return XR_SUCCESS;
}

XrResult requestRate(XrSession, float rate) {
    const std::vector<float> rates = stubRuntime().device().rates;
    if (std::find(rates.begin(), rates.end(), rate) == rates.end()) return XR_ERROR_DISPLAY_REFRESH_RATE_UNSUPPORTED_FB;
    stubRuntime().onRate(rate);
    return XR_SUCCESS;
}

XrResult getMask(XrSession, XrViewConfigurationType, uint32_t, XrVisibilityMaskTypeKHR, XrVisibilityMaskKHR* mask) {
    const float hidden = stubRuntime().device().hidden;
    constexpr std::array<uint32_t, 6> kIndices{0, 1, 2, 2, 1, 3};
    constexpr uint32_t kVertices = 4;
    const bool none = hidden <= 0;
    mask->vertexCountOutput = none ? 0 : kVertices;
    mask->indexCountOutput = none ? 0 : uint32_t(kIndices.size());
    if (none || mask->vertexCapacityInput < kVertices) return XR_SUCCESS;
    for (uint32_t i = 0; i < kVertices; ++i)
        mask->vertices[i] = {i % 2 == 0 ? -1.0f : -1.0f + hidden, i < 2 ? -1.0f : 1.0f};
    std::copy(kIndices.begin(), kIndices.end(), mask->indices);
    return XR_SUCCESS;
}

XrResult setPerformanceLevel(XrSession, XrPerfSettingsDomainEXT, XrPerfSettingsLevelEXT level) {
    if (level == XR_PERF_SETTINGS_LEVEL_SUSTAINED_HIGH_EXT) stubRuntime().onSustained();
    return XR_SUCCESS;
}

/// A function of an extension.
struct StubFunction {
    const char* name;
    const char* extension;
    PFN_xrVoidFunction function;
};

template <class Function>
StubFunction stubFunction(const char* name, const char* extension, Function* function) {
    return {name, extension, reinterpret_cast<PFN_xrVoidFunction>(function)};
}

constexpr std::array kExtensions{"XR_KHR_opengl_enable",
                                 "XR_MNDX_egl_enable",
                                 "XR_KHR_composition_layer_depth",
                                 "XR_EXT_user_presence",
                                 "XR_EXT_local_floor",
                                 "XR_EXT_performance_settings",
                                 "XR_FB_display_refresh_rate",
                                 "XR_FB_composition_layer_depth_test",
                                 "XR_KHR_visibility_mask"};

std::vector<std::string> offeredByStub() {
    const std::vector<std::string> withheld = stubRuntime().device().withheld;
    std::vector<std::string> offered;
    for (const char* name : kExtensions)
        if (std::find(withheld.begin(), withheld.end(), name) == withheld.end()) offered.emplace_back(name);
    return offered;
}

std::vector<XrReferenceSpaceType> spacesOfStub() {
    std::vector<XrReferenceSpaceType> types{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
    if (stubRuntime().device().stage) types.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
    if (stubRuntime().enabled("XR_EXT_local_floor")) types.push_back(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT);
    return types;
}

} // namespace

} // namespace meltpool::test

using namespace meltpool::test;

extern "C" {

XrResult xrEnumerateInstanceExtensionProperties(const char*, uint32_t capacity, uint32_t* count,
                                                XrExtensionProperties* out) {
    const std::vector<std::string> names = offeredByStub();
    *count = uint32_t(names.size());
    for (uint32_t i = 0; i < capacity; ++i)
        std::strncpy(out[i].extensionName, names[i].c_str(), XR_MAX_EXTENSION_NAME_SIZE - 1);
    return XR_SUCCESS;
}

XrResult xrCreateInstance(const XrInstanceCreateInfo* info, XrInstance* instance) {
    // A runtime of 1.0, as older ones are.
    if (info->applicationInfo.apiVersion >= XR_MAKE_VERSION(1, 1, 0)) return XR_ERROR_API_VERSION_UNSUPPORTED;
    const std::vector<std::string> offered = offeredByStub();
    std::vector<std::string> asked(info->enabledExtensionNames,
                                   info->enabledExtensionNames + info->enabledExtensionCount);
    for (const std::string& name : asked)
        if (std::find(offered.begin(), offered.end(), name) == offered.end()) return XR_ERROR_EXTENSION_NOT_PRESENT;
    stubRuntime().onEnabled(std::move(asked));
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
    const std::array functions{
        stubFunction("xrGetOpenGLGraphicsRequirementsKHR", "XR_KHR_opengl_enable", openGlRequirements),
        stubFunction("xrEnumerateDisplayRefreshRatesFB", "XR_FB_display_refresh_rate", enumerateRates),
        stubFunction("xrRequestDisplayRefreshRateFB", "XR_FB_display_refresh_rate", requestRate),
        stubFunction("xrGetVisibilityMaskKHR", "XR_KHR_visibility_mask", getMask),
        stubFunction("xrPerfSettingsSetPerformanceLevelEXT", "XR_EXT_performance_settings", setPerformanceLevel),
    };
    for (const StubFunction& known : functions) {
        if (std::strcmp(name, known.name) != 0 || !stubRuntime().enabled(known.extension)) continue;
        *function = known.function;
        return XR_SUCCESS;
    }
    return XR_ERROR_FUNCTION_UNSUPPORTED;
}

XrResult xrGetSystem(XrInstance, const XrSystemGetInfo*, XrSystemId* system) {
    *system = 1;
    return XR_SUCCESS;
}

XrResult xrGetSystemProperties(XrInstance, XrSystemId, XrSystemProperties* properties) {
    std::strcpy(properties->systemName, "stub headset");
    properties->trackingProperties.positionTracking = XR_TRUE;
    for (auto* next = static_cast<XrBaseOutStructure*>(properties->next); next != nullptr; next = next->next)
        if (next->type == XR_TYPE_SYSTEM_USER_PRESENCE_PROPERTIES_EXT)
            reinterpret_cast<XrSystemUserPresencePropertiesEXT*>(next)->supportsUserPresence =
                stubRuntime().device().presence ? XR_TRUE : XR_FALSE;
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
    stubRuntime().wear(true); // reported at each begin
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
    const std::vector<XrReferenceSpaceType> types = spacesOfStub();
    *count = uint32_t(types.size());
    for (uint32_t i = 0; i < capacity; ++i)
        out[i] = types[i];
    return XR_SUCCESS;
}

XrResult xrCreateReferenceSpace(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
    const std::vector<XrReferenceSpaceType> types = spacesOfStub();
    if (std::find(types.begin(), types.end(), info->referenceSpaceType) == types.end())
        return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
    *space = newHandle<XrSpace>();
    return XR_SUCCESS;
}

XrResult xrCreateActionSpace(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* space) {
    *space = newHandle<XrSpace>();
    stubRuntime().onActionSpace(*space, info->action);
    return XR_SUCCESS;
}

XrResult xrDestroySpace(XrSpace) {
    return XR_SUCCESS;
}

XrResult xrLocateSpace(XrSpace space, XrSpace, XrTime, XrSpaceLocation* location) {
    location->locationFlags = XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
                              XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
    location->pose = stubRuntime().pose(space);
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
    if (XR_SUCCEEDED(result)) stubRuntime().onFrame(*info);
    return result;
}

XrResult xrCreateActionSet(XrInstance, const XrActionSetCreateInfo*, XrActionSet* set) {
    *set = newHandle<XrActionSet>();
    return XR_SUCCESS;
}

XrResult xrDestroyActionSet(XrActionSet) {
    return XR_SUCCESS;
}

XrResult xrCreateAction(XrActionSet, const XrActionCreateInfo* info, XrAction* action) {
    *action = newHandle<XrAction>();
    stubRuntime().onAction(*action, info->actionName);
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
