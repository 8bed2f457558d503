// Ctrl-C, an end of the session and a closed terminal as a wish to stop, which a program grants in its own time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace meltpool {

/// While it lives SIGINT, SIGTERM and SIGHUP ask to stop. Ctrl-C (SIGINT) a while after that ends the process at once
/// with exit code 1; others may come twice on their own, from a terminal and from its shell. A SIGHUP that the parent
/// ignores (nohup) stays ignored. Under Windows these are Ctrl-C, Ctrl-Break, and the end of console, session or
/// system, which the program delays by up to kFarewell. One at a time in a process.
class StopSignals {
  public:
    /// Windows itself ends a program five seconds after it closed the console.
    static constexpr std::chrono::milliseconds kFarewell{4500};

    /// `answer`: a line for standard error when the first signal comes, such as what is still finished; it must live as
    /// long as this object. None: nothing is said.
    explicit StopSignals(const char* answer = nullptr);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    static bool asked();

    /// A signal came; `interrupt`: Ctrl-C. Allocates nothing and waits for no lock.
    static void wish(bool interrupt);

    /// Who was asked and does not come to grantStop() within `patience`, as in a step of minutes, is ended: `last` is
    /// called on a thread of its own, then the process ends with exit code 1.
    void endAfter(std::chrono::milliseconds patience, std::function<void()> last);

    /// To be called by who was asked before it ends in order. From now on endAfter() ends nothing; does not return
    /// where that has begun.
    void grantStop();

  private:
    void watch();
    void catchSignals(); ///< from now on each calls wish()
    void leaveSignals(); ///< as it was before
    /// Writes to standard error; may be called in a signal handler.
    static void say(const char* sentence);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::chrono::milliseconds patience_{0};
    std::function<void()> last_;
    bool granted_ = false;
    std::thread watcher_;
    // Handlers that were there before, where the system has such.
    void (*interrupt_)(int) = nullptr;
    void (*terminate_)(int) = nullptr;
    void (*hangUp_)(int) = nullptr;
};

} // namespace meltpool
