#include "core/base/error.hpp"
#include "core/gl/context.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstring>
#include <vector>

namespace meltpool::gl {

namespace {

bool offers(const char* list, const char* extension) {
    return list != nullptr && std::strstr(list, extension) != nullptr;
}

/// The displays worth trying, best first: each EGL device that is a card, then the surfaceless platform.
std::vector<EGLDisplay> candidateDisplays() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto getDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto deviceString =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    std::vector<EGLDisplay> displays;
    if (getDisplay == nullptr) return {eglGetDisplay(EGL_DEFAULT_DISPLAY)};
    if (offers(client, "EGL_EXT_platform_device") && queryDevices != nullptr && deviceString != nullptr) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        queryDevices(EGLint(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            const EGLDeviceEXT device = devices[static_cast<size_t>(i)];
            if (isProcessorDevice(deviceString(device, EGL_EXTENSIONS))) continue;
            displays.push_back(getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        }
    }
    if (offers(client, "EGL_MESA_platform_surfaceless"))
        displays.push_back(
            getDisplay(EGL_PLATFORM_SURFACELESS_MESA, reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr));
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLContext makeContext(EGLDisplay display, bool debug) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) == EGL_FALSE) return EGL_NO_CONTEXT;
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &found) == EGL_FALSE || found == 0) config = nullptr;
    const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           4,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           5,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_CONTEXT_OPENGL_DEBUG,
                                           debug ? EGL_TRUE : EGL_FALSE,
                                           EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) return context;
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
}

} // namespace

struct HeadlessContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Handles() {
        if (context == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
};

ContextSystem contextSystem() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_VERSION);
    if (client == nullptr) client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return {"EGL", client == nullptr ? "too old to be asked" : std::string(client).substr(0, 60), kDriverRemedy};
}

HeadlessContext::HeadlessContext(bool debug) : handles_(std::make_unique<Handles>()) {
    for (const EGLDisplay display : candidateDisplays()) {
        handles_->context = makeContext(display, debug);
        handles_->display = display;
        if (handles_->context != EGL_NO_CONTEXT) break;
    }
    if (handles_->context == EGL_NO_CONTEXT)
        throw InputError(
            std::string("no OpenGL 4.5 core context could be made through EGL; expected a graphics driver (") +
            kDriverRemedy + ")");
    info_ = useCurrentContext(debug);
}

HeadlessContext::~HeadlessContext() = default;

void HeadlessContext::makeCurrent() const {
    eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context);
}

} // namespace meltpool::gl
