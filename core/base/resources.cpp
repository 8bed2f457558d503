#include "core/base/resources.hpp"

#include "core/base/error.hpp"

#include <cstdlib>
#include <string>

#ifdef _WIN32
#include <windows.h>
#endif

namespace meltpool {

namespace {

/// The variable's value; empty when it is not set or empty.
std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

} // namespace

std::filesystem::path programFolder() {
#ifdef _WIN32
    wchar_t name[32768];
    const DWORD length = GetModuleFileNameW(nullptr, name, 32768);
    return std::filesystem::path(name, name + length).parent_path();
#else
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
#endif
}

std::filesystem::path resourceFolder() {
    const std::string chosen = environment("MELTPOOL_DATA");
    const std::filesystem::path folder = chosen.empty()
                                             ? (programFolder() / ".." / "share" / "meltpool").lexically_normal()
                                             : std::filesystem::path(chosen);
    if (!std::filesystem::is_directory(folder / "shaders"))
        throw InputError(folder, 0,
                         "the program's own files are not here; expected the folders shaders and data "
                         "(set MELTPOOL_DATA to the folder that holds them)");
    return folder;
}

std::filesystem::path settingsFolder() {
#ifdef _WIN32
    return std::filesystem::path(environment("APPDATA")) / "meltpool";
#else
    const std::string base = environment("XDG_CONFIG_HOME");
    if (!base.empty()) return std::filesystem::path(base) / "meltpool";
    return std::filesystem::path(environment("HOME")) / ".config" / "meltpool";
#endif
}

std::filesystem::path keptFolder() {
#ifdef _WIN32
    return std::filesystem::path(environment("LOCALAPPDATA")) / "meltpool";
#else
    const std::string base = environment("XDG_DATA_HOME");
    if (!base.empty()) return std::filesystem::path(base) / "meltpool";
    return std::filesystem::path(environment("HOME")) / ".local" / "share" / "meltpool";
#endif
}

} // namespace meltpool
