// What the driver is, whether it is enough, and a context of our own that needs no window.
#pragma once

#include "core/gl/gl.hpp"

#include <memory>

namespace meltpool::gl {

struct ContextInfo {
    std::string renderer;
    std::string vendor;
    std::string version;
    int major = 0;
    int minor = 0;
    bool software = false; ///< a driver that draws on the CPU
};

/// Loads the functions of the context that is current and reads who it is. Throws InputError naming what was found and
/// what is needed when it is less than OpenGL 4.5 core. `debug`: the driver's errors and warnings go to standard error
/// from here on.
ContextInfo useCurrentContext(bool debug);

/// The driver of the context that is current draws on the CPU.
bool drawnOnProcessor();

/// True in builds that want the driver's debug output.
constexpr bool debugBuild() {
#ifdef NDEBUG
    return false;
#else
    return true;
#endif
}

/// An OpenGL 4.5 core context on EGL without any display: a GPU where there is one, else Mesa's software driver.
class HeadlessContext {
  public:
    /// Makes it and makes it current. Throws InputError saying what is missing and how to get it.
    explicit HeadlessContext(bool debug = debugBuild());
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    const ContextInfo& info() const { return info_; }
    void makeCurrent() const;

  private:
    struct Egl;
    std::unique_ptr<Egl> egl_;
    ContextInfo info_;
};

} // namespace meltpool::gl
