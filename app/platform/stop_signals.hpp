// The request to stop, from Ctrl-C, the end of the session or a closed terminal, which a program grants in its own
// time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace meltpool {

/// Signals that ask to stop, during this object's lifetime: SIGINT, SIGTERM and SIGHUP. Ctrl-C (SIGINT) a while after
/// that ends the process at once with exit code 1; others may come twice on their own, from a terminal and from its
/// shell. A SIGHUP that the parent ignores (nohup) stays ignored. On Windows these are Ctrl-C, Ctrl-Break, and the end
/// of console, session or system, which the program delays by up to kFarewell. One at a time in a process.
class StopSignals {
  public:
    /// Delay of the end: Windows itself ends a program five seconds after it closed the console.
    static constexpr std::chrono::milliseconds kFarewell{4500};

    /// Starts. `answer`: a line for standard error when the first signal comes, such as the work that is still
    /// finished; it must live as long as this object. Null: prints nothing.
    explicit StopSignals(const char* answer = nullptr);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    static bool asked();

    /// Takes a signal; `interrupt`: Ctrl-C. Allocates nothing and waits for no lock.
    static void wish(bool interrupt);

    /// Ends a program that was asked to stop but does not reach grantStop() within `patience`, as in a step of minutes:
    /// calls `last` on a thread of its own, then ends the process with exit code 1.
    void endAfter(std::chrono::milliseconds patience, std::function<void()> last);

    /// Grants the stop; call it after a request and before ending in order. From now on endAfter() ends nothing; does
    /// not return if that has begun.
    void grantStop();

  private:
    void watch();
    void catchSignals(); ///< makes each signal call wish()
    void leaveSignals(); ///< restores the earlier handlers
    /// Writes to standard error; may be called in a signal handler.
    static void say(const char* sentence);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::chrono::milliseconds patience_{0};
    std::function<void()> last_;
    bool granted_ = false;
    std::thread watcher_;
    // Earlier handlers, on systems that have them.
    void (*interrupt_)(int) = nullptr;
    void (*terminate_)(int) = nullptr;
    void (*hangUp_)(int) = nullptr;
};

} // namespace meltpool
