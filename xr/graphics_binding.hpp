// The current OpenGL context as OpenXR wants it, and a guard that restores the context after calls of the runtime.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace meltpool::xr {

/// The OpenGL context that is current now, in the form that xrCreateSession wants: GLX or EGL on Linux, WGL on Windows.
/// It comes from the context itself, so it does not matter who made it (a window, or core/gl's headless context).
class GraphicsBinding {
  public:
    /// Throws InputError when no context is current.
    static GraphicsBinding ofCurrentContext();

    /// For XrSessionCreateInfo::next.
    const void* next() const { return chain_.get(); }
    /// The extension that this binding needs, or nullptr where XR_KHR_opengl_enable is enough.
    const char* extension() const { return extension_; }
    /// "GLX", "EGL" or "WGL".
    const char* kind() const { return kind_; }

    /// Which runtimes take an OpenGL context on this system, and how one of them is made the active one.
    static const char* runtimesWithOpenGl();

  private:
    std::shared_ptr<void> chain_;
    const char* extension_ = nullptr;
    const char* kind_ = "";
};

/// A context of its own beside the one that is current when it is made: textures and buffers are the same in both. For
/// another thread, which makes it current.
class SharedContext {
  public:
    /// Throws InputError when no context is current, or the driver makes none beside it.
    SharedContext();
    ~SharedContext();
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

    /// On the thread that is to use it, once.
    void makeCurrent();
    /// On that same thread, before this is destroyed.
    void release();

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

/// Remembers the current context and drawables. Its destructor makes them current again where the runtime changed them,
/// and clears the GL errors that the runtime left.
class ContextGuard {
  public:
    ContextGuard();
    ~ContextGuard();
    ContextGuard(const ContextGuard&) = delete;
    ContextGuard& operator=(const ContextGuard&) = delete;

    /// How often guards of this process restored a context, and how many GL errors they cleared.
    struct Repairs {
        unsigned contexts = 0;
        unsigned errors = 0;
    };
    static const Repairs& repairs();

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
    // Of GLX and EGL; WGL's context has one drawable, its device context.
    [[maybe_unused]] void* draw_ = nullptr;
    [[maybe_unused]] void* read_ = nullptr;
    [[maybe_unused]] bool egl_ = false;
};

} // namespace meltpool::xr
