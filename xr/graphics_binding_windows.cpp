// Binds the OpenGL context of WGL.
#include "xr/platform.hpp"

#include "core/base/error.hpp"
#include "core/gl/hidden_window.hpp"
#include "xr/graphics_binding.hpp"

namespace meltpool::xr {

namespace {

ContextGuard::Repairs counted;

[[noreturn]] void noSecondContext() {
    throw InputError("the graphics driver makes no second OpenGL context that shares with the window's; expected "
                     "one for the headset");
}

} // namespace

GraphicsBinding GraphicsBinding::ofCurrentContext() {
    XrGraphicsBindingOpenGLWin32KHR binding{};
    binding.type = XR_TYPE_GRAPHICS_BINDING_OPENGL_WIN32_KHR;
    binding.hDC = wglGetCurrentDC();
    binding.hGLRC = wglGetCurrentContext();
    if (binding.hGLRC == nullptr) throw InputError("no OpenGL context is current; expected one for the headset");
    GraphicsBinding made;
    made.chain_ = std::make_shared<XrGraphicsBindingOpenGLWin32KHR>(binding);
    made.kind_ = "WGL";
    return made;
}

const char* GraphicsBinding::runtimesWithOpenGl() {
    return "SteamVR has it: make it the active runtime in its settings under OpenXR; Meta Quest Link has it too, in "
           "its settings under General";
}

/// A device context may be current on one thread only, and a context needs its own pixel format; so the second context
/// has its own window with the first one's format.
struct SharedContext::Handles {
    explicit Handles(HDC first) : window(GetPixelFormat(first)) {}
    ~Handles() {
        if (context != nullptr) wglDeleteContext(context);
    }
    gl::HiddenWindow window;
    HGLRC context = nullptr;
};

SharedContext::SharedContext() {
    const HDC first = wglGetCurrentDC();
    if (first == nullptr) throw InputError("no OpenGL context is current; expected one for the headset");
    handles_ = std::make_unique<Handles>(first);
    handles_->context = static_cast<HGLRC>(handles_->window.makeContext(false, wglGetCurrentContext()));
    if (handles_->context == nullptr) noSecondContext();
}

SharedContext::~SharedContext() = default;

void SharedContext::makeCurrent() {
    if (wglMakeCurrent(static_cast<HDC>(handles_->window.deviceContext()), handles_->context) == FALSE)
        noSecondContext();
}

void SharedContext::release() {
    wglMakeCurrent(nullptr, nullptr);
}

ContextGuard::ContextGuard() : display_(wglGetCurrentDC()), context_(wglGetCurrentContext()) {}

ContextGuard::~ContextGuard() {
    if (context_ == nullptr) return;
    if (wglGetCurrentContext() != context_ || wglGetCurrentDC() != display_) {
        wglMakeCurrent(static_cast<HDC>(display_), static_cast<HGLRC>(context_));
        ++counted.contexts;
    }
    for (int limit = 16; limit > 0 && glGetError() != GL_NO_ERROR; --limit)
        ++counted.errors;
}

const ContextGuard::Repairs& ContextGuard::repairs() {
    return counted;
}

} // namespace meltpool::xr
