// The current OpenGL context: its driver and whether that suffices; and a context without a window.
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

/// Loads the functions of the current context and reads its names and version. Throws InputError with the version found
/// when it is less than OpenGL 4.5 core. `debug`: from now on the driver's errors and warnings go to standard error.
ContextInfo useCurrentContext(bool debug);

/// Whether the driver of the current context draws on the CPU.
bool drawnOnProcessor();

/// Whether this build asks for the driver's debug output.
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
    /// Creates the context and makes it current. Throws InputError that names the packages to install.
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
