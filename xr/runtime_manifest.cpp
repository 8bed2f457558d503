#include "xr/runtime_manifest.hpp"

#include "core/base/text.hpp"
#include "xr/session/platform.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdlib>

namespace meltpool::xr {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kLargest = 1 << 20; // bytes; manifests have a few hundred

std::string fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// What is wrong with the file before anybody reads it; empty: nothing.
std::string faultOfFile(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return "does not exist";
    if (!fs::is_regular_file(file, ignored)) return "is no file";
    if (fs::file_size(file, ignored) > kLargest) return "is larger than a runtime's manifest ever is";
    return {};
}

/// The library may be named relative to the manifest, or to what the manifest links to.
bool libraryExists(const fs::path& manifest, const fs::path& library) {
    std::error_code ignored;
    if (fs::exists(manifest.parent_path() / library, ignored)) return true;
    const fs::path real = fs::canonical(manifest, ignored);
    return !real.empty() && fs::exists(real.parent_path() / library, ignored);
}

std::string faultOfContents(const fs::path& file, std::string& library) {
    const json manifest = json::parse(readTextFile(file));
    if (!manifest.is_object() || !manifest.contains("runtime") || !manifest["runtime"].is_object())
        return "has no object \"runtime\"";
    const json& runtime = manifest["runtime"];
    if (!runtime.contains("library_path") || !runtime["library_path"].is_string())
        return "has no text \"library_path\" in its object \"runtime\"";
    library = runtime["library_path"];
    if (library.empty()) return "has an empty \"library_path\"";
    if (library.find('/') == std::string::npos && library.find('\\') == std::string::npos) return {};
    return libraryExists(file, library) ? std::string() : "names the library " + library + ", which does not exist";
}

} // namespace

RuntimeManifest readRuntimeManifest(const fs::path& file) {
    RuntimeManifest found{file.string(), {}, {}};
    std::string wrong = faultOfFile(file);
    try {
        if (wrong.empty()) wrong = faultOfContents(file, found.library);
    } catch (const json::parse_error& fault) {
        wrong = "is no JSON (byte " + std::to_string(fault.byte) + ")";
    } catch (const std::exception&) {
        wrong = "cannot be read";
    }
    if (!wrong.empty())
        found.fault = "the OpenXR runtime's manifest " + found.file + " " + wrong +
                      "; expected a JSON file with runtime.library_path, as the runtime installs it";
    return found;
}

std::vector<fs::path> activeRuntimePlaces() {
#ifdef _WIN32
    return {};
#else
    std::vector<fs::path> folders;
    if (const std::string config = fromEnvironment("XDG_CONFIG_HOME"); !config.empty())
        folders.emplace_back(config);
    else if (const std::string home = fromEnvironment("HOME"); !home.empty())
        folders.emplace_back(fs::path(home) / ".config");
    std::string shared = fromEnvironment("XDG_CONFIG_DIRS");
    if (shared.empty()) shared = "/etc/xdg";
    for (const std::string_view folder : splitText(shared, ':'))
        if (!folder.empty()) folders.emplace_back(folder);
    folders.emplace_back("/usr/local/etc");
    folders.emplace_back("/etc");
    for (fs::path& folder : folders)
        folder = folder / "openxr" / "1" / "active_runtime.json";
    return folders;
#endif
}

RuntimeManifest findRuntimeManifest() {
    if (const std::string file = fromEnvironment("XR_RUNTIME_JSON"); !file.empty()) {
        RuntimeManifest named = readRuntimeManifest(file);
        if (!named.fault.empty()) named.fault += " (the variable XR_RUNTIME_JSON names it)";
        return named;
    }
#ifdef _WIN32
    std::array<char, 1024> value{};
    DWORD size = DWORD(value.size());
    if (RegGetValueA(HKEY_LOCAL_MACHINE, "SOFTWARE\\Khronos\\OpenXR\\1", "ActiveRuntime", RRF_RT_REG_SZ, nullptr,
                     value.data(), &size) == ERROR_SUCCESS)
        return readRuntimeManifest(value.data());
#else
    for (const fs::path& place : activeRuntimePlaces()) {
        std::error_code ignored;
        // A link that leads nowhere is found by nobody, but was meant.
        if (fs::exists(fs::symlink_status(place, ignored))) return readRuntimeManifest(place);
    }
#endif
    return {};
}

} // namespace meltpool::xr
