// The current OpenGL context: its driver and whether that suffices; and a context without a window.
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
/// when it is less than OpenGL 4.5 core. `debug`: from now on the driver's errors and warnings go to standard error.
ContextInfo useCurrentContext(bool debug);

/// From now on the errors and warnings of the current context, whose functions are loaded, go to standard error.
void reportFaults();

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

/// What contexts without a window are made with.
struct ContextSystem {
    std::string name; ///< "EGL", "WGL"
    std::string version;
    std::string remedy; ///< how to get a driver where there is none
};

/// Asks the system; makes no context.
ContextSystem contextSystem();

/// An OpenGL 4.5 core context without a window on the screen: a GPU where there is one, else the processor. On
/// Linux it comes from EGL and needs no display; on Windows from WGL and a window that is never shown.
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
