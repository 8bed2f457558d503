// Finds the file by which the OpenXR loader finds the active runtime, and its faults.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool::xr {

struct RuntimeManifest {
    std::string file;     ///< empty: none is set
    std::string library;  ///< library of the runtime, as the file names it
    std::string fault;    ///< a sentence's end for the person, with file and fault; empty: the file is in order
    std::string unheeded; ///< value of XR_RUNTIME_JSON if the loader ignores it; else empty
};

/// Looks in the loader's places: $XR_RUNTIME_JSON, else openxr/1/active_runtime.json in $XDG_CONFIG_HOME (or
/// ~/.config), $XDG_CONFIG_DIRS (or /etc/xdg), /usr/local/etc and /etc; under Windows the registry's entry, and the
/// variable only without an administrator's rights. Loads no library. Throws nothing.
RuntimeManifest findRuntimeManifest();

/// Reads one file. The system searches for a library named without a folder; it is not checked here.
RuntimeManifest readRuntimeManifest(const std::filesystem::path& file);

/// The places of active_runtime.json, in the loader's order; empty under Windows.
std::vector<std::filesystem::path> activeRuntimePlaces();

/// True if the loader reads XR_RUNTIME_JSON in this process.
bool runtimeVariableHeeded();

/// The system's file of the active runtime, which need not exist; empty: the system names none.
std::filesystem::path activeRuntimeFile();

} // namespace meltpool::xr
