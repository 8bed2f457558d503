#include "app/platform/open_file.hpp"

#include "app/platform/other_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <thread>

namespace meltpool {

namespace {

bool set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

} // namespace

bool openForPerson(const std::filesystem::path& file) {
    if (!set("DISPLAY") && !set("WAYLAND_DISPLAY")) return false;
    const std::filesystem::path program = findProgram("xdg-open");
    if (program.empty()) return false;
    std::error_code failed;
    std::string whole = std::filesystem::absolute(file, failed).string(); // cannot begin with '-'
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
