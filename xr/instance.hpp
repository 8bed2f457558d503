// Connects to the active OpenXR runtime and its headset.
#pragma once

#include "xr/check.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace meltpool::xr {

/// Hides the loader's messages from the terminal unless XR_LOADER_DEBUG is set; the program reports failures itself.
/// Call it before other threads run.
void quietLoader();

/// Names of the extensions that the active runtime (and enabled layers) offer; empty if no runtime answers.
std::vector<std::string> offeredExtensions();

bool contains(const std::vector<std::string>& names, std::string_view name);

/// Names of runtime and headset.
struct RuntimeInfo {
    std::string runtime; ///< "Monado(XRT) ... 25.0.0"
    std::string system;  ///< the headset's name
    bool positionTracking = false;
    bool userPresence = false; ///< reports when the headset is put on and taken off
};

/// An XrInstance with a head-mounted system. Needs no OpenGL context, so another thread may make it.
class Instance {
  public:
    /// Connects to the runtime and enables every extension of ours that it offers. Throws XrFault: no runtime
    /// (XR_ERROR_RUNTIME_UNAVAILABLE), or no headset connected (XR_ERROR_FORM_FACTOR_UNAVAILABLE); InputError if the
    /// runtime has no OpenGL at all.
    Instance();
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    XrInstance handle() const { return instance_; }
    XrSystemId system() const { return system_; }
    const RuntimeInfo& info() const { return info_; }
    bool has(std::string_view extension) const { return contains(enabled_, extension); }
    const std::vector<std::string>& extensions() const { return enabled_; }

    XrPath path(const char* text) const;
    std::string text(XrPath path) const;

    /// A function of an extension, or nullptr.
    template <class Function>
    Function function(const char* name) const {
        PFN_xrVoidFunction found = nullptr;
        if (XR_FAILED(xrGetInstanceProcAddr(instance_, name, &found))) return nullptr;
        return reinterpret_cast<Function>(found);
    }

  private:
    void create();
    void findSystem();

    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    RuntimeInfo info_;
    std::vector<std::string> enabled_;
};

} // namespace meltpool::xr
