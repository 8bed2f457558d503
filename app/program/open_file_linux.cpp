#include "app/program/open_file.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

namespace meltpool {

namespace {

bool set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

/// Where the program is; empty where it is not.
std::string programIn(std::string_view path, const char* name) {
    while (!path.empty()) {
        const size_t end = std::min(path.find(':'), path.size());
        const std::string file = std::string(path.substr(0, end)) + "/" + name;
        if (end > 0 && ::access(file.c_str(), X_OK) == 0) return file;
        path.remove_prefix(std::min(end + 1, path.size()));
    }
    return {};
}

} // namespace

bool openForPerson(const std::filesystem::path& file) {
    if (!set("PATH") || !(set("DISPLAY") || set("WAYLAND_DISPLAY"))) return false;
    const std::string program = programIn(std::getenv("PATH"), "xdg-open");
    if (program.empty()) return false;
    std::error_code failed;
    std::string whole = std::filesystem::absolute(file, failed).string(); // no word that begins with '-'
    std::string name = "xdg-open";
    char* const words[] = {name.data(), whole.data(), nullptr};
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const bool begun = posix_spawn(&child, program.c_str(), &quiet, nullptr, words, environ) == 0;
    posix_spawn_file_actions_destroy(&quiet);
    if (begun) std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
    return begun;
}

} // namespace meltpool
