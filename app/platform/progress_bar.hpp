// A line on the terminal with the progress of long work.
#pragma once

#include <chrono>
#include <string>

namespace meltpool {

/// Progress bar. It draws only if standard error is a terminal, at most ten times a second; logs and pipes stay clean.
class ProgressBar {
  public:
    explicit ProgressBar(std::string what);
    /// Erases the line.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Shows `done` of `whole`, in any unit.
    void show(double done, double whole);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
};

/// Text of the line: "classic  [#####.....]  50 %, 4 s left". `seconds`: passed since the start.
std::string progressLine(const std::string& what, double share, double seconds);

} // namespace meltpool
