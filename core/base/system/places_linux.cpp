#include "core/base/system/environment.hpp"
#include "core/base/system/places.hpp"

namespace meltpool {

namespace fs = std::filesystem;

fs::path programFolder() {
    return fs::read_symlink("/proc/self/exe").parent_path();
}

fs::path filesOfProgram() {
    return (programFolder() / ".." / "share" / "meltpool").lexically_normal();
}

fs::path userSettings() {
    const std::string base = environmentVariable("XDG_CONFIG_HOME");
    return base.empty() ? fs::path(environmentVariable("HOME")) / ".config" : fs::path(base);
}

fs::path userFiles() {
    const std::string base = environmentVariable("XDG_DATA_HOME");
    return base.empty() ? fs::path(environmentVariable("HOME")) / ".local" / "share" : fs::path(base);
}

fs::path userCache() {
    const std::string base = environmentVariable("XDG_CACHE_HOME");
    if (!base.empty()) return base;
    const std::string home = environmentVariable("HOME");
    return home.empty() ? fs::path() : fs::path(home) / ".cache";
}

} // namespace meltpool
