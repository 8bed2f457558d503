// The stub runtime as a library for Windows' OpenXR loader: it answers the loader's negotiation, and passes each
// ordered call through CallOrder. With MELTPOOL_TEST_RUNTIME_LOSE=N it loses its session at the Nth frame's end, and
// with MELTPOOL_TEST_RUNTIME_NO_OPENGL it refuses OpenGL.
#include "tests/windows/runtime/order.hpp"
#include "tests/xr/stub/stub_runtime.hpp"

#include <openxr/loader_interfaces.h>

#include <array>
#include <cstdlib>
#include <cstring>

namespace meltpool::test {

namespace {

CallOrder& order() {
    return CallOrder::only();
}

XrResult listExtensions(const char* layer, uint32_t capacity, uint32_t* count, XrExtensionProperties* out) {
    if (std::getenv("MELTPOOL_TEST_RUNTIME_NO_OPENGL") == nullptr)
        return xrEnumerateInstanceExtensionProperties(layer, capacity, count, out);
    *count = 1;
    if (capacity > 0) std::strcpy(out->extensionName, "XR_KHR_composition_layer_depth");
    return XR_SUCCESS;
}

XrResult askRequirements(XrInstance instance, XrSystemId system, XrGraphicsRequirementsOpenGLKHR* needed) {
    order().note("xrGetOpenGLGraphicsRequirementsKHR");
    order().requirementsAsked();
    PFN_xrVoidFunction function = nullptr;
    xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR", &function);
    return reinterpret_cast<PFN_xrGetOpenGLGraphicsRequirementsKHR>(function)(instance, system, needed);
}

XrResult makeSession(XrInstance instance, const XrSessionCreateInfo* info, XrSession* session) {
    order().note("xrCreateSession");
    order().sessionMade(*info);
    if (glewInit() != GLEW_OK) order().fault("OpenGL's functions cannot be loaded in the program's context");
    return xrCreateSession(instance, info, session);
}

XrResult destroySession(XrSession session) {
    order().note("xrDestroySession");
    order().sessionDestroyed();
    return xrDestroySession(session);
}

XrResult makeSwapchain(XrSession session, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
    order().note("xrCreateSwapchain");
    order().needsContext("xrCreateSwapchain");
    return xrCreateSwapchain(session, info, swapchain);
}

XrResult acquire(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo* info, uint32_t* index) {
    order().note("xrAcquireSwapchainImage");
    order().acquired(swapchain);
    return xrAcquireSwapchainImage(swapchain, info, index);
}

XrResult waitImage(XrSwapchain swapchain, const XrSwapchainImageWaitInfo* info) {
    order().note("xrWaitSwapchainImage");
    order().waited(swapchain);
    return xrWaitSwapchainImage(swapchain, info);
}

XrResult release(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo* info) {
    order().note("xrReleaseSwapchainImage");
    order().released(swapchain);
    return xrReleaseSwapchainImage(swapchain, info);
}

XrResult waitFrame(XrSession session, const XrFrameWaitInfo* info, XrFrameState* state) {
    order().note("xrWaitFrame");
    order().frameWaited();
    return xrWaitFrame(session, info, state);
}

XrResult beginFrame(XrSession session, const XrFrameBeginInfo* info) {
    order().note("xrBeginFrame");
    order().frameBegun();
    return xrBeginFrame(session, info);
}

XrResult endFrame(XrSession session, const XrFrameEndInfo* info) {
    order().note(info->layerCount > 0 ? "xrEndFrame with layers" : "xrEndFrame");
    order().frameEnded(*info);
    static const int losing = [] {
        const char* text = std::getenv("MELTPOOL_TEST_RUNTIME_LOSE");
        return text == nullptr ? 0 : std::atoi(text);
    }();
    static int frames = 0;
    if (++frames == losing) {
        order().note("the session is lost");
        return XR_ERROR_SESSION_LOST;
    }
    return xrEndFrame(session, info);
}

struct Entry {
    const char* name;
    PFN_xrVoidFunction function;
};

template <class Function>
Entry entry(const char* name, Function function) {
    return {name, reinterpret_cast<PFN_xrVoidFunction>(function)};
}

XrResult find(XrInstance, const char* name, PFN_xrVoidFunction* function) {
    static const std::array entries{
        entry("xrGetOpenGLGraphicsRequirementsKHR", askRequirements),
        entry("xrCreateSession", makeSession),
        entry("xrDestroySession", destroySession),
        entry("xrCreateSwapchain", makeSwapchain),
        entry("xrAcquireSwapchainImage", acquire),
        entry("xrWaitSwapchainImage", waitImage),
        entry("xrReleaseSwapchainImage", release),
        entry("xrWaitFrame", waitFrame),
        entry("xrBeginFrame", beginFrame),
        entry("xrEndFrame", endFrame),
        entry("xrGetInstanceProcAddr", find),
        entry("xrEnumerateInstanceExtensionProperties", listExtensions),
        entry("xrCreateInstance", xrCreateInstance),
        entry("xrDestroyInstance", xrDestroyInstance),
        entry("xrGetInstanceProperties", xrGetInstanceProperties),
        entry("xrGetSystem", xrGetSystem),
        entry("xrGetSystemProperties", xrGetSystemProperties),
        entry("xrStringToPath", xrStringToPath),
        entry("xrPathToString", xrPathToString),
        entry("xrPollEvent", xrPollEvent),
        entry("xrEnumerateViewConfigurationViews", xrEnumerateViewConfigurationViews),
        entry("xrBeginSession", xrBeginSession),
        entry("xrEndSession", xrEndSession),
        entry("xrRequestExitSession", xrRequestExitSession),
        entry("xrEnumerateReferenceSpaces", xrEnumerateReferenceSpaces),
        entry("xrCreateReferenceSpace", xrCreateReferenceSpace),
        entry("xrCreateActionSpace", xrCreateActionSpace),
        entry("xrDestroySpace", xrDestroySpace),
        entry("xrLocateSpace", xrLocateSpace),
        entry("xrLocateViews", xrLocateViews),
        entry("xrEnumerateSwapchainFormats", xrEnumerateSwapchainFormats),
        entry("xrDestroySwapchain", xrDestroySwapchain),
        entry("xrEnumerateSwapchainImages", xrEnumerateSwapchainImages),
        entry("xrCreateActionSet", xrCreateActionSet),
        entry("xrDestroyActionSet", xrDestroyActionSet),
        entry("xrCreateAction", xrCreateAction),
        entry("xrSuggestInteractionProfileBindings", xrSuggestInteractionProfileBindings),
        entry("xrAttachSessionActionSets", xrAttachSessionActionSets),
        entry("xrSyncActions", xrSyncActions),
        entry("xrGetActionStateBoolean", xrGetActionStateBoolean),
        entry("xrGetActionStateFloat", xrGetActionStateFloat),
        entry("xrGetActionStateVector2f", xrGetActionStateVector2f),
        entry("xrGetActionStatePose", xrGetActionStatePose),
        entry("xrGetCurrentInteractionProfile", xrGetCurrentInteractionProfile),
        entry("xrApplyHapticFeedback", xrApplyHapticFeedback),
        entry("xrStopHapticFeedback", xrStopHapticFeedback),
    };
    for (const Entry& each : entries)
        if (std::strcmp(each.name, name) == 0) {
            *function = each.function;
            return XR_SUCCESS;
        }
    *function = nullptr;
    return XR_ERROR_FUNCTION_UNSUPPORTED;
}

} // namespace

} // namespace meltpool::test

extern "C" __declspec(dllexport) XrResult
    xrNegotiateLoaderRuntimeInterface(const XrNegotiateLoaderInfo* loader, XrNegotiateRuntimeRequest* request) {
    meltpool::test::CallOrder::only().note("xrNegotiateLoaderRuntimeInterface");
    if (loader == nullptr || request == nullptr || loader->minInterfaceVersion > 1)
        return XR_ERROR_INITIALIZATION_FAILED;
    request->runtimeInterfaceVersion = XR_CURRENT_LOADER_RUNTIME_VERSION;
    request->runtimeApiVersion = XR_MAKE_VERSION(1, 0, 0);
    request->getInstanceProcAddr = meltpool::test::find;
    return XR_SUCCESS;
}
