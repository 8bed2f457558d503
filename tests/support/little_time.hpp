// Imitates a machine with little time for a program: it stops the program for a part of every moment.
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <functional>
#include <thread>

namespace meltpool::test {

/// Stops a process for `stopped` of every `period` seconds during its lifetime. `signal(number)` sends the process a
/// signal.
class LittleTime {
  public:
    LittleTime(std::function<void(int)> signal, double period, double stopped)
        : signal_(std::move(signal)), thread_([=, this] { work(period, stopped); }) {}
    ~LittleTime() {
        done_ = true;
        thread_.join();
    }
    LittleTime(const LittleTime&) = delete;
    LittleTime& operator=(const LittleTime&) = delete;

  private:
    void work(double period, double stopped) {
        const auto nap = [](double s) { std::this_thread::sleep_for(std::chrono::duration<double>(s)); };
        while (!done_) {
            signal_(SIGSTOP);
            nap(stopped);
            signal_(SIGCONT);
            nap(period - stopped);
        }
    }

    std::function<void(int)> signal_;
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

/// Returns the share of a processor that this machine gives a thread with full load, measured by working for a second:
/// 1 on a quiet machine.
inline double shareOfProcessor() {
    const auto seconds = [](clockid_t clock) {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double begin = seconds(CLOCK_MONOTONIC), worked = seconds(CLOCK_THREAD_CPUTIME_ID);
    while (seconds(CLOCK_MONOTONIC) < begin + 1) {
    }
    return (seconds(CLOCK_THREAD_CPUTIME_ID) - worked) / (seconds(CLOCK_MONOTONIC) - begin);
}

/// Excuses a program that fails to keep pace with the clock: after half a minute of that, on a machine whose other
/// programs leave it too little. A program that is too slow by itself gets no excuse.
class BusyMachine {
  public:
    bool excuses() {
        const auto now = Clock::now();
        if (now < next_) return false;
        next_ = now + std::chrono::seconds(10);
        share_ = shareOfProcessor();
        return share_ < 0.7;
    }
    /// Share of the last measurement.
    double share() const { return share_; }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point next_ = Clock::now() + std::chrono::seconds(30);
    double share_ = 1;
};

} // namespace meltpool::test
