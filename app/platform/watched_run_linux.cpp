#include "app/platform/watched_run.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace meltpool {

namespace {

constexpr size_t kMostBytes = 2000;

/// Becomes the program, in the child. Does not return.
[[noreturn]] void become(std::vector<char*>& words, int errors, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1); // the parent ended before
    ::dup2(errors, STDERR_FILENO);
    ::close(errors);
    ::execv("/proc/self/exe", words.data());
    ::_exit(127);
}

/// Reads to the end, and writes all of it to standard error.
std::string readToEnd(int errors) {
    std::string said;
    std::array<char, 4096> part{};
    for (;;) {
        const ssize_t bytes = ::read(errors, part.data(), part.size());
        if (bytes < 0 && errno == EINTR) continue;
        if (bytes <= 0) return said;
        // A failing standard error is no reason to lose the rest.
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, part.data(), static_cast<size_t>(bytes));
        said.append(part.data(), static_cast<size_t>(bytes));
        if (said.size() > kMostBytes) said.erase(0, said.size() - kMostBytes);
    }
}

} // namespace

WatchedEnd runWatched(std::span<const std::string> words) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        throw RuntimeFault(std::string("no pipe for the program's words: ") + std::strerror(errno));
    std::vector<std::string> own{"meltpool"};
    own.insert(own.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : own)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t self = ::getpid(), child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        become(pointers, ends[1], self);
    }
    ::close(ends[1]);
    if (child < 0) {
        ::close(ends[0]);
        throw RuntimeFault(std::string("the program cannot be started: ") + std::strerror(errno));
    }
    WatchedEnd end;
    end.complaint = readToEnd(ends[0]);
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw RuntimeFault(std::string("the program's end is not known: ") + std::strerror(errno));
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return end;
}

std::string endSentence(const WatchedEnd& end) {
    if (end.code == 0) return {};
    std::string text;
    for (std::string_view line : splitText(trimText(end.complaint), '\n')) {
        constexpr std::string_view kName = "meltpool: ";
        if (line.substr(0, kName.size()) == kName) line.remove_prefix(kName.size());
        if (!text.empty()) text += '\n';
        text += line;
    }
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 32);
    const bool crashed = end.code > 128;
    if (!text.empty() && !crashed) return text;
    if (!text.empty()) text += '\n';
    if (crashed)
        return text + "The program was ended by the signal " + std::to_string(end.code - 128) + " (" +
               ::strsignal(end.code - 128) + "). Attempts are recorded up to their last second.";
    return text + "The program ended with the code " + std::to_string(end.code) + ".";
}

std::optional<std::vector<std::string>> withoutOption(int argc, const char* const* argv, const std::string& option) {
    std::vector<std::string> words;
    bool found = false;
    for (int i = 1; i < argc; ++i)
        if (argv[i] == option)
            found = true;
        else
            words.emplace_back(argv[i]);
    if (!found) return std::nullopt;
    return words;
}

} // namespace meltpool
