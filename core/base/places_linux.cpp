#include "core/base/environment.hpp"
#include "core/base/places.hpp"

#include <pwd.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

/// Debian's home for users without one: nothing can be made there, and messages name it.
constexpr const char* kNoHome = "/nonexistent";

/// The home in the user database; empty if the database has none.
fs::path homeOfUser() {
    std::vector<char> room(1 << 14);
    passwd entry{};
    passwd* found = nullptr;
    if (getpwuid_r(getuid(), &entry, room.data(), room.size(), &found) != 0 || found == nullptr) return {};
    const fs::path home = found->pw_dir == nullptr ? fs::path() : fs::path(found->pw_dir);
    return home.is_absolute() ? home : fs::path();
}

/// The user's home; empty if there is none.
fs::path knownHome() {
    const fs::path home = environmentVariable("HOME");
    return home.is_absolute() ? home : homeOfUser();
}

/// The XDG base directory specification asks to ignore a relative path.
fs::path folderNamedBy(const char* variable) {
    const fs::path folder = environmentVariable(variable);
    return folder.is_absolute() ? folder : fs::path();
}

fs::path folderOr(const char* variable, const char* belowHome) {
    const fs::path folder = folderNamedBy(variable);
    if (!folder.empty()) return folder;
    const fs::path home = knownHome();
    return (home.empty() ? fs::path(kNoHome) : home) / belowHome;
}

/// The value of a line KEY="VALUE" of user-dirs.dirs: an absolute path, or one below $HOME; else empty.
fs::path userFolder(std::string_view line, std::string_view key) {
    const size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos || line.substr(begin, key.size()) != key) return {};
    std::string_view rest = line.substr(begin + key.size());
    if (!rest.starts_with("=\"")) return {};
    rest.remove_prefix(2);
    std::string value;
    size_t i = 0;
    for (; i < rest.size() && rest[i] != '"'; ++i)
        value += rest[i] == '\\' && i + 1 < rest.size() ? rest[++i] : rest[i];
    if (i == rest.size()) return {}; // no closing quote
    constexpr std::string_view kHome = "$HOME";
    if (!value.starts_with(kHome)) return value.starts_with('/') ? fs::path(value) : fs::path();
    const std::string below = value.substr(kHome.size());
    const fs::path home = knownHome();
    return home.empty() || (!below.empty() && below.front() != '/') ? fs::path() : fs::path(home.string() + below);
}

} // namespace

fs::path programFolder() {
    return fs::read_symlink("/proc/self/exe").parent_path();
}

fs::path filesOfProgram() {
    return (programFolder() / ".." / "share" / "meltpool").lexically_normal();
}

fs::path userSettings() {
    return folderOr("XDG_CONFIG_HOME", ".config");
}

fs::path userFiles() {
    return folderOr("XDG_DATA_HOME", ".local/share");
}

fs::path userDocuments() {
    return userFiles();
}

fs::path userCache() {
    const fs::path folder = folderNamedBy("XDG_CACHE_HOME");
    if (!folder.empty()) return folder;
    const fs::path home = knownHome();
    return home.empty() ? fs::path() : home / ".cache";
}

fs::path userPictures() {
    constexpr const char* kKey = "XDG_PICTURES_DIR";
    if (const fs::path folder = folderNamedBy(kKey); !folder.empty()) return folder;
    fs::path named;
    std::ifstream file(userSettings() / "user-dirs.dirs");
    for (std::string line; std::getline(file, line);)
        if (fs::path folder = userFolder(line, kKey); !folder.empty()) named = std::move(folder);
    if (!named.empty()) return named;
    const fs::path home = knownHome();
    return home.empty() ? fs::path() : home / "Pictures";
}

} // namespace meltpool
