// The file by which the OpenXR loader finds the active runtime, and what is wrong with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool::xr {

struct RuntimeManifest {
    std::string file;     ///< empty: none is set
    std::string library;  ///< of the runtime, as the file names it
    std::string fault;    ///< a sentence's end for the person, with file and what is wrong; empty: the file is in order
    std::string unheeded; ///< what XR_RUNTIME_JSON names where the loader does not look at it; else empty
};

/// Looks where the loader looks: $XR_RUNTIME_JSON, else openxr/1/active_runtime.json in $XDG_CONFIG_HOME (or
/// ~/.config), $XDG_CONFIG_DIRS (or /etc/xdg), /usr/local/etc and /etc; under Windows what the registry names, and the
/// variable only without an administrator's rights. Loads no library. Throws nothing.
RuntimeManifest findRuntimeManifest();

/// Reads one file. A library that is named without a folder is looked for by the system and not checked here.
RuntimeManifest readRuntimeManifest(const std::filesystem::path& file);

/// The places of active_runtime.json, in the loader's order; empty under Windows.
std::vector<std::filesystem::path> activeRuntimePlaces();

/// Whether the loader looks at XR_RUNTIME_JSON in this process.
bool runtimeVariableHeeded();

/// The file that the system names as the active runtime's, whether it exists or not; empty: it names none.
std::filesystem::path activeRuntimeFile();

} // namespace meltpool::xr
