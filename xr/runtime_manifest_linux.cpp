#include "core/base/environment.hpp"
#include "core/base/text.hpp"
#include "xr/runtime_manifest.hpp"

namespace meltpool::xr {

namespace fs = std::filesystem;

std::vector<fs::path> activeRuntimePlaces() {
    std::vector<fs::path> folders;
    if (const std::string config = environmentVariable("XDG_CONFIG_HOME"); !config.empty())
        folders.emplace_back(config);
    else if (const std::string home = environmentVariable("HOME"); !home.empty())
        folders.emplace_back(fs::path(home) / ".config");
    std::string shared = environmentVariable("XDG_CONFIG_DIRS");
    if (shared.empty()) shared = "/etc/xdg";
    for (const std::string_view folder : splitText(shared, ':'))
        if (!folder.empty()) folders.emplace_back(folder);
    folders.emplace_back("/usr/local/etc");
    folders.emplace_back("/etc");
    for (fs::path& folder : folders)
        folder = folder / "openxr" / "1" / "active_runtime.json";
    return folders;
}

bool runtimeVariableHeeded() {
    return true;
}

fs::path activeRuntimeFile() {
    for (const fs::path& place : activeRuntimePlaces()) {
        std::error_code ignored;
        // A link to a missing file cannot be opened, but it is the intended file.
        if (fs::exists(fs::symlink_status(place, ignored))) return place;
    }
    return {};
}

} // namespace meltpool::xr
