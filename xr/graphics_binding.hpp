// Describes the current OpenGL context to OpenXR, and guards it against changes by the runtime.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace meltpool::xr {

/// The current OpenGL context in the form of xrCreateSession: GLX or EGL on Linux, WGL on Windows. It comes from the
/// context itself, so any maker of the context will do (a window, or core/gl's headless context).
class GraphicsBinding {
  public:
    /// Throws InputError if no context is current.
    static GraphicsBinding ofCurrentContext();

    /// Chain for XrSessionCreateInfo::next.
    const void* next() const { return chain_.get(); }
    /// The extension that this binding needs, or nullptr if XR_KHR_opengl_enable is enough.
    const char* extension() const { return extension_; }
    /// "GLX", "EGL" or "WGL".
    const char* kind() const { return kind_; }

    /// Advice: the runtimes that take an OpenGL context on this system, and the way to make one the active one.
    static const char* runtimesWithOpenGl();

  private:
    std::shared_ptr<void> chain_;
    const char* extension_ = nullptr;
    const char* kind_ = "";
};

/// A second context that shares textures and buffers with the context that is current at its making. For another
/// thread, which makes it current.
class SharedContext {
  public:
    /// Throws InputError if no context is current, or the driver makes no second one.
    SharedContext();
    ~SharedContext();
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

    /// Call it once, on the thread that uses the context.
    void makeCurrent();
    /// Call it on that thread, before this is destroyed.
    void release();

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

/// Remembers the current context and drawables. Its destructor makes them current again if the runtime changed them,
/// and clears the GL errors that the runtime left.
class ContextGuard {
  public:
    ContextGuard();
    ~ContextGuard();
    ContextGuard(const ContextGuard&) = delete;
    ContextGuard& operator=(const ContextGuard&) = delete;

    /// Counts of restored contexts and of cleared GL errors, over all guards of this process.
    struct Repairs {
        unsigned contexts = 0;
        unsigned errors = 0;
    };
    static const Repairs& repairs();

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
    // Drawables of GLX and EGL; WGL's context has one drawable, its device context.
    [[maybe_unused]] void* draw_ = nullptr;
    [[maybe_unused]] void* read_ = nullptr;
    [[maybe_unused]] bool egl_ = false;
};

} // namespace meltpool::xr
