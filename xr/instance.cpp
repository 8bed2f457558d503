// Makes the instance, chooses its extensions and finds the headset.
#include "xr/instance.hpp"

#include "core/base/environment.hpp"
#include "xr/graphics_binding.hpp"
#include "xr/newer_openxr.hpp"
#include "xr/profiles.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace meltpool::xr {

namespace {

constexpr const char* kOpenGl = "XR_KHR_opengl_enable";
constexpr const char* kUserPresence = "XR_EXT_user_presence";

/// Extensions that are enabled if the runtime offers them; interaction profiles name further ones.
constexpr std::array kOptional{
    "XR_MNDX_egl_enable",
    "XR_KHR_composition_layer_depth",
    "XR_HTCX_vive_tracker_interaction",
    "XR_FB_haptic_pcm",
    "XR_FB_display_refresh_rate",
    kUserPresence,
    "XR_KHR_visibility_mask",
    "XR_EXT_local_floor",
    "XR_EXT_performance_settings",
    "XR_FB_composition_layer_depth_test",
};

std::vector<std::string> wantedExtensions(const std::vector<std::string>& offered) {
    std::vector<std::string> wanted{kOpenGl};
    const auto want = [&](const char* name) {
        if (name != nullptr && contains(offered, name) && !contains(wanted, name)) wanted.emplace_back(name);
    };
    for (const char* name : kOptional)
        want(name);
    for (const InteractionProfile& profile : interactionProfiles())
        want(profile.extension);
    return wanted;
}

} // namespace

void quietLoader() {
    setEnvironmentDefault("XR_LOADER_DEBUG", "none");
}

std::vector<std::string> offeredExtensions() {
    uint32_t count = 0;
    if (XR_FAILED(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr))) return {};
    std::vector<XrExtensionProperties> properties(count, {XR_TYPE_EXTENSION_PROPERTIES});
    if (XR_FAILED(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, properties.data()))) return {};
    std::vector<std::string> names;
    for (const XrExtensionProperties& property : properties)
        names.emplace_back(property.extensionName);
    return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Instance::Instance() {
    create();
    try {
        findSystem();
    } catch (...) {
        xrDestroyInstance(instance_);
        throw;
    }
}

Instance::~Instance() {
    xrDestroyInstance(instance_);
}

void Instance::create() {
    const std::vector<std::string> offered = offeredExtensions();
    if (offered.empty())
        throw XrFault("no OpenXR runtime answers (xrEnumerateInstanceExtensionProperties)",
                      XR_ERROR_RUNTIME_UNAVAILABLE);
    if (!contains(offered, kOpenGl))
        throw InputError(
            std::string(
                "the active OpenXR runtime does not work with OpenGL; expected the extension XR_KHR_opengl_enable (") +
            GraphicsBinding::runtimesWithOpenGl() + ")");
    enabled_ = wantedExtensions(offered);
    std::vector<const char*> names;
    for (const std::string& name : enabled_)
        names.push_back(name.c_str());

    XrInstanceCreateInfo create{XR_TYPE_INSTANCE_CREATE_INFO};
    std::strncpy(create.applicationInfo.applicationName, "Meltpool", XR_MAX_APPLICATION_NAME_SIZE - 1);
    create.applicationInfo.applicationVersion = 1;
    // Every loader and runtime takes 1.0, older ones nothing newer, and 1.1 brings nothing that its extensions do not
    // bring to 1.0: those (local_floor, the interaction profiles) are asked for by their names.
    create.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    create.enabledExtensionCount = static_cast<uint32_t>(names.size());
    create.enabledExtensionNames = names.data();
    MELTPOOL_XR(xrCreateInstance(&create, &instance_));
}

void Instance::findSystem() {
    XrInstanceProperties runtime{XR_TYPE_INSTANCE_PROPERTIES};
    MELTPOOL_XR(xrGetInstanceProperties(instance_, &runtime));
    info_.runtime = std::string(runtime.runtimeName) + " " + std::to_string(XR_VERSION_MAJOR(runtime.runtimeVersion)) +
                    "." + std::to_string(XR_VERSION_MINOR(runtime.runtimeVersion)) + "." +
                    std::to_string(XR_VERSION_PATCH(runtime.runtimeVersion));

    XrSystemGetInfo get{XR_TYPE_SYSTEM_GET_INFO};
    get.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    MELTPOOL_XR(xrGetSystem(instance_, &get, &system_));
    XrSystemProperties system{XR_TYPE_SYSTEM_PROPERTIES};
    XrSystemUserPresencePropertiesEXT presence{XR_TYPE_SYSTEM_USER_PRESENCE_PROPERTIES_EXT, nullptr, XR_FALSE};
    if (has(kUserPresence)) system.next = &presence;
    MELTPOOL_XR(xrGetSystemProperties(instance_, system_, &system));
    info_.system = system.systemName;
    info_.positionTracking = system.trackingProperties.positionTracking == XR_TRUE;
    info_.userPresence = presence.supportsUserPresence == XR_TRUE;
}

XrPath Instance::path(const char* text) const {
    XrPath path = XR_NULL_PATH;
    MELTPOOL_XR(xrStringToPath(instance_, text, &path));
    return path;
}

std::string Instance::text(XrPath path) const {
    if (path == XR_NULL_PATH) return {};
    std::array<char, XR_MAX_PATH_LENGTH> buffer{};
    uint32_t length = 0;
    MELTPOOL_XR(xrPathToString(instance_, path, static_cast<uint32_t>(buffer.size()), &length, buffer.data()));
    return buffer.data();
}

} // namespace meltpool::xr
