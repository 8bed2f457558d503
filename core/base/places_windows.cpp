#include "core/base/environment.hpp"
#include "core/base/places.hpp"

#include <windows.h>

#include <vector>

namespace meltpool {

namespace fs = std::filesystem;

fs::path programFolder() {
    std::vector<wchar_t> name(32768); // the longest path
    const DWORD length = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
    return fs::path(name.data(), name.data() + length).parent_path();
}

fs::path filesOfProgram() {
    // An installed program's files are in its own folder; those of a fresh build are in the layout of Linux.
    std::error_code unreadable;
    const fs::path folder = programFolder();
    if (fs::is_directory(folder / "shaders", unreadable)) return folder;
    return (folder / ".." / "share" / "meltpool").lexically_normal();
}

fs::path userSettings() {
    return environmentVariable("APPDATA");
}

fs::path userFiles() {
    return environmentVariable("LOCALAPPDATA");
}

fs::path userDocuments() {
    return userSettings();
}

fs::path userCache() {
    return userFiles();
}

fs::path userPictures() {
    const std::string home = environmentVariable("USERPROFILE");
    return home.empty() ? fs::path() : fs::path(home) / "Pictures";
}

} // namespace meltpool
