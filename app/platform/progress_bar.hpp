// A line on the terminal that says how far a long piece of work is.
#pragma once

#include <chrono>
#include <string>

namespace meltpool {

/// Draws only where standard error is a terminal, at most ten times a second; logs and pipes stay clean.
class ProgressBar {
  public:
    explicit ProgressBar(std::string what);
    /// Takes the line away.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `done` of `whole`, in any unit.
    void show(double done, double whole);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
};

/// The line's text: "classic  [#####.....]  50 %, 4 s left". `seconds`: passed since the start.
std::string progressLine(const std::string& what, double share, double seconds);

} // namespace meltpool
