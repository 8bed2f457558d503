#include "xr/runtime_manifest.hpp"

#include "core/base/environment.hpp"
#include "core/base/text.hpp"

#include <nlohmann/json.hpp>

namespace meltpool::xr {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kLargest = 1 << 20; // bytes; manifests have a few hundred

/// Fault of the file before it is read; empty: none.
std::string faultOfFile(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return "does not exist";
    if (!fs::is_regular_file(file, ignored)) return "is no file";
    if (fs::file_size(file, ignored) > kLargest) return "is larger than 1 MiB";
    return {};
}

/// The library's name may be relative to the manifest, or to the manifest's link target.
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
    RuntimeManifest found{file.string(), {}, {}, {}};
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

RuntimeManifest findRuntimeManifest() {
    const std::string variable = environmentVariable("XR_RUNTIME_JSON");
    if (!variable.empty() && runtimeVariableHeeded()) {
        RuntimeManifest named = readRuntimeManifest(variable);
        if (!named.fault.empty()) named.fault += " (the variable XR_RUNTIME_JSON names it)";
        return named;
    }
    const fs::path set = activeRuntimeFile();
    RuntimeManifest found = set.empty() ? RuntimeManifest{} : readRuntimeManifest(set);
    found.unheeded = variable;
    return found;
}

} // namespace meltpool::xr
