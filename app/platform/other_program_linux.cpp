#include "app/platform/other_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace meltpool {

std::filesystem::path findProgram(const std::string& name) {
    const char* variable = std::getenv("PATH");
    std::string_view path = variable == nullptr ? "" : variable;
    while (!path.empty()) {
        const size_t end = std::min(path.find(':'), path.size());
        const std::filesystem::path file = std::filesystem::path(path.substr(0, end)) / name;
        std::error_code missing;
        if (end > 0 && std::filesystem::is_regular_file(file, missing) && ::access(file.c_str(), X_OK) == 0)
            return file;
        path.remove_prefix(std::min(end + 1, path.size()));
    }
    return {};
}

int runToItsEnd(const std::filesystem::path& program, std::span<const std::string> words) {
    std::string name = program.string();
    std::vector<std::string> own(words.begin(), words.end());
    std::vector<char*> pointers{name.data()};
    for (std::string& word : own)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    pid_t child = 0;
    const bool begun = posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!begun) return -1;
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace meltpool
