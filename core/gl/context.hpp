// The current OpenGL context, its driver and the driver's fitness; and a context without a window.
#pragma once

#include "core/gl/gl.hpp"

#include <memory>
#include <string_view>

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
/// if it is less than OpenGL 4.5 core. `debug`: the driver's errors and warnings go to standard error from now on.
ContextInfo useCurrentContext(bool debug);

/// Sends errors and warnings of the current context to standard error from now on. Its functions must be loaded.
void reportFaults();

/// True if the driver of the current context draws on the CPU.
bool drawnOnProcessor();

/// True if this build asks for the driver's debug output.
constexpr bool debugBuild() {
#ifdef NDEBUG
    return false;
#else
    return true;
#endif
}

/// The system that makes contexts without a window.
struct ContextSystem {
    std::string name; ///< "EGL", "WGL"
    std::string version;
    std::string remedy; ///< how to get a driver if there is none
};

/// Asks the system; makes no context.
ContextSystem contextSystem();

/// An OpenGL 4.5 core context without a window on the screen: on a GPU if there is one, else on the processor. On Linux
/// it comes from EGL and needs no display; on Windows from WGL and a window that is never shown.
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
    struct Handles;
    std::unique_ptr<Handles> handles_;
    ContextInfo info_;
};

} // namespace meltpool::gl
