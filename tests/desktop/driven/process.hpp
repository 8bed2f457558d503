// Runs a child process that ends with the test.
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
        std::map<std::string, std::string> environment = {}; ///< changes to this process's own; an empty value removes
        std::filesystem::path output = {};                   ///< file for standard output and error; empty: none
        std::filesystem::path folder = {};                   ///< working folder; empty: this process's
        int passedPipe = -1;                                 ///< file descriptor that the child gets, as number 3
    };

    explicit Process(const Options& options);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running();
    int pid() const { return pid_; }
    void signal(int number) const;
    /// Waits for the end, at most `seconds`; returns the exit code, 128 + N if signal N ended it, -1 if it still runs.
    int wait(double seconds);

  private:
    int pid_ = -1;
    int status_ = -1;
    bool ended_ = false;
};

/// Runs a command to its end; returns its exit code (127: not found).
int runCommand(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment = {});

} // namespace meltpool::test
