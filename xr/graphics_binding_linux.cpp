// Binds the OpenGL context of GLX and of EGL.
#include "xr/platform.hpp"

#include "core/base/error.hpp"
#include "xr/graphics_binding.hpp"

#include <array>
#include <cstdint>

namespace meltpool::xr {

namespace {

ContextGuard::Repairs counted;

template <class Struct>
std::shared_ptr<void> keep(const Struct& value) {
    return std::make_shared<Struct>(value);
}

EGLConfig configOf(EGLDisplay display, EGLContext context) {
    EGLint id = 0;
    eglQueryContext(display, context, EGL_CONFIG_ID, &id);
    const std::array<EGLint, 3> wanted{EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    eglChooseConfig(display, wanted.data(), &config, 1, &found);
    return config;
}

XrGraphicsBindingEGLMNDX eglBinding(EGLContext context) {
    XrGraphicsBindingEGLMNDX binding{XR_TYPE_GRAPHICS_BINDING_EGL_MNDX};
    binding.getProcAddress = eglGetProcAddress;
    binding.display = eglGetCurrentDisplay();
    binding.config = configOf(binding.display, context);
    binding.context = context;
    return binding;
}

XrGraphicsBindingOpenGLXlibKHR glxBinding(GLXContext context) {
    XrGraphicsBindingOpenGLXlibKHR binding{XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR};
    binding.xDisplay = glXGetCurrentDisplay();
    binding.glxContext = context;
    binding.glxDrawable = glXGetCurrentDrawable();
    int id = 0, screen = 0, visual = 0, found = 0;
    glXQueryContext(binding.xDisplay, context, GLX_FBCONFIG_ID, &id);
    glXQueryContext(binding.xDisplay, context, GLX_SCREEN, &screen);
    const std::array<int, 3> wanted{GLX_FBCONFIG_ID, id, 0};
    GLXFBConfig* configs = glXChooseFBConfig(binding.xDisplay, screen, wanted.data(), &found);
    if (configs != nullptr && found > 0) {
        binding.glxFBConfig = configs[0];
        glXGetFBConfigAttrib(binding.xDisplay, configs[0], GLX_VISUAL_ID, &visual);
    }
    if (configs != nullptr) XFree(configs);
    binding.visualid = static_cast<uint32_t>(visual);
    return binding;
}

} // namespace

GraphicsBinding GraphicsBinding::ofCurrentContext() {
    GraphicsBinding made;
    if (const GLXContext context = glXGetCurrentContext(); context != nullptr) {
        made.chain_ = keep(glxBinding(context));
        made.kind_ = "GLX";
        return made;
    }
    if (const EGLContext context = eglGetCurrentContext(); context != EGL_NO_CONTEXT) {
        made.chain_ = keep(eglBinding(context));
        made.extension_ = XR_MNDX_EGL_ENABLE_EXTENSION_NAME;
        made.kind_ = "EGL";
        return made;
    }
    throw InputError("no OpenGL context is current; expected one for the headset");
}

const char* GraphicsBinding::runtimesWithOpenGl() {
    return "SteamVR, Meta Link, Monado and WiVRn have it";
}

namespace {

[[noreturn]] void noSecondContext() {
    throw InputError("the graphics driver makes no second OpenGL context that shares with the window's; expected "
                     "one for the headset");
}

} // namespace

namespace {

GLXContext glxBeside(Display* display, GLXFBConfig config, GLXContext first) {
    const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    if (create == nullptr) noSecondContext();
    const std::array<int, 7> wanted{
        GLX_CONTEXT_MAJOR_VERSION_ARB,    4, GLX_CONTEXT_MINOR_VERSION_ARB, 5, GLX_CONTEXT_PROFILE_MASK_ARB,
        GLX_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
    const GLXContext made = create(display, config, first, 1, wanted.data());
    if (made == nullptr) noSecondContext();
    return made;
}

EGLContext eglBeside(EGLDisplay display, EGLContext first) {
    const std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext made = eglCreateContext(display, configOf(display, first), first, wanted.data());
    if (made == EGL_NO_CONTEXT) noSecondContext();
    return made;
}

} // namespace

struct SharedContext::Handles {
    void* display = nullptr;
    void* context = nullptr;
    unsigned long window = 0;    ///< GLX: a window of one pixel, never shown
    unsigned long colourmap = 0; ///< colour map of that window
    bool egl = false;

    void useGlx(GLXContext first);
    ~Handles();
};

void SharedContext::Handles::useGlx(GLXContext first) {
    const XrGraphicsBindingOpenGLXlibKHR binding = glxBinding(first);
    XVisualInfo* visual = glXGetVisualFromFBConfig(binding.xDisplay, binding.glxFBConfig);
    if (visual == nullptr) noSecondContext();
    context = glxBeside(binding.xDisplay, binding.glxFBConfig, first);
    display = binding.xDisplay;
    const Window root = RootWindow(binding.xDisplay, visual->screen);
    colourmap = XCreateColormap(binding.xDisplay, root, visual->visual, AllocNone);
    XSetWindowAttributes attributes{};
    attributes.colormap = colourmap;
    window = XCreateWindow(binding.xDisplay, root, 0, 0, 1, 1, 0, visual->depth, InputOutput, visual->visual,
                           CWColormap | CWBorderPixel, &attributes);
    XFree(visual);
    XSync(binding.xDisplay, 0);
}

SharedContext::Handles::~Handles() {
    if (context == nullptr) return;
    if (egl) {
        eglDestroyContext(display, context);
        return;
    }
    auto* server = static_cast<Display*>(display);
    glXDestroyContext(server, static_cast<GLXContext>(context));
    XDestroyWindow(server, window);
    XFreeColormap(server, colourmap);
}

SharedContext::SharedContext() : handles_(std::make_unique<Handles>()) {
    if (const GLXContext first = glXGetCurrentContext(); first != nullptr) {
        handles_->useGlx(first);
        return;
    }
    handles_->egl = true;
    const EGLContext first = eglGetCurrentContext();
    if (first == EGL_NO_CONTEXT) throw InputError("no OpenGL context is current; expected one for the headset");
    handles_->display = eglGetCurrentDisplay();
    handles_->context = eglBeside(handles_->display, first);
}

SharedContext::~SharedContext() = default;

void SharedContext::makeCurrent() {
    const Handles& h = *handles_;
    if (h.egl) {
        eglBindAPI(EGL_OPENGL_API); // a new thread starts bound to OpenGL ES
        if (eglMakeCurrent(h.display, EGL_NO_SURFACE, EGL_NO_SURFACE, h.context) == EGL_FALSE) noSecondContext();
        return;
    }
    if (glXMakeContextCurrent(static_cast<Display*>(h.display), h.window, h.window,
                              static_cast<GLXContext>(h.context)) == 0)
        noSecondContext();
}

void SharedContext::release() {
    const Handles& h = *handles_;
    if (h.egl)
        eglMakeCurrent(h.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    else
        glXMakeContextCurrent(static_cast<Display*>(h.display), 0, 0, nullptr);
}

namespace {

void* asPointer(GLXDrawable drawable) {
    return reinterpret_cast<void*>(static_cast<uintptr_t>(drawable));
}
GLXDrawable asDrawable(void* pointer) {
    return static_cast<GLXDrawable>(reinterpret_cast<uintptr_t>(pointer));
}

} // namespace

ContextGuard::ContextGuard() {
    if (const GLXContext context = glXGetCurrentContext(); context != nullptr) {
        display_ = glXGetCurrentDisplay();
        context_ = context;
        draw_ = asPointer(glXGetCurrentDrawable());
        read_ = asPointer(glXGetCurrentReadDrawable());
        return;
    }
    egl_ = true;
    context_ = eglGetCurrentContext();
    display_ = eglGetCurrentDisplay();
    draw_ = eglGetCurrentSurface(EGL_DRAW);
    read_ = eglGetCurrentSurface(EGL_READ);
}

ContextGuard::~ContextGuard() {
    if (context_ == nullptr) return;
    const bool same = egl_ ? eglGetCurrentContext() == context_ && eglGetCurrentSurface(EGL_DRAW) == draw_
                           : glXGetCurrentContext() == context_ && glXGetCurrentDrawable() == asDrawable(draw_);
    if (!same) {
        ++counted.contexts;
        if (egl_)
            eglMakeCurrent(display_, draw_, read_, context_);
        else
            glXMakeContextCurrent(static_cast<Display*>(display_), asDrawable(draw_), asDrawable(read_),
                                  static_cast<GLXContext>(context_));
    }
    for (int limit = 16; limit > 0 && glGetError() != GL_NO_ERROR; --limit)
        ++counted.errors;
}

const ContextGuard::Repairs& ContextGuard::repairs() {
    return counted;
}

} // namespace meltpool::xr
