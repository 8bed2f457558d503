#include "tests/desktop/driven/process.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace meltpool::test {

namespace {

[[noreturn]] void becomeChild(const Process::Options& options) {
    signal(SIGHUP, SIG_DFL); // the tests may run under nohup, which children inherit
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    for (const auto& [name, value] : options.environment) {
        if (value.empty())
            unsetenv(name.c_str());
        else
            setenv(name.c_str(), value.c_str(), 1);
    }
    if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
    const char* output = options.output.empty() ? "/dev/null" : options.output.c_str();
    const int file = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (options.passedPipe >= 0) dup2(options.passedPipe, 3);
    std::vector<char*> words;
    for (const std::string& word : options.command)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
    _exit(127);
}

} // namespace

Process::Process(const Options& options) {
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process can be started");
    if (pid_ == 0) becomeChild(options);
}

Process::~Process() {
    if (!running()) return;
    signal(SIGKILL);
    wait(10);
}

bool Process::running() {
    return wait(0) == -1;
}

void Process::signal(int number) const {
    if (!ended_) kill(pid_, number);
}

int Process::wait(double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!ended_) {
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_) {
            ended_ = true;
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        } else if (std::chrono::steady_clock::now() >= end) {
            return -1;
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    return status_;
}

int runCommand(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment) {
    Process process({.command = command, .environment = environment});
    return process.wait(300);
}

} // namespace meltpool::test
