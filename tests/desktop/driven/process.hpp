// A child process that dies with the test.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace meltpool::test {

class Process {
  public:
    struct Options {
        std::vector<std::string> command = {};
        std::map<std::string, std::string> environment = {}; ///< on top of this process's own; an empty value removes
        std::filesystem::path output = {};                   ///< standard output and error go here; empty: nowhere
        std::filesystem::path folder = {};                   ///< it runs there; empty: here
        int passedPipe = -1;                                 ///< a file descriptor the child keeps, as number 3
    };

    explicit Process(const Options& options);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running();
    int pid() const { return pid_; }
    void signal(int number) const;
    /// Waits for the end, at most `seconds`; its exit code, 128 + N when signal N ended it, -1 when it still runs.
    int wait(double seconds);

  private:
    int pid_ = -1;
    int status_ = -1;
    bool ended_ = false;
};

/// Runs a command to its end; its exit code (127: not found).
int runCommand(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment = {});

} // namespace meltpool::test
