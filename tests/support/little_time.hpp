// A machine with little time for a program: the program is stopped for a part of every moment.
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace meltpool::test {

/// While it lives, a process is stopped for `stopped` of every `period` seconds. `signal(number)` sends the process a
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

} // namespace meltpool::test
