// Measures the places where a thread spends a frame's time: the program's own work, the graphics driver, the headset's
// runtime, or waiting. Code that calls a driver or runtime marks the call with InWork; without a meter that costs one
// test of a pointer.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace meltpool {

enum class WorkPlace { own, driver, runtime, waiting };
constexpr size_t kWorkPlaces = 4;

/// Work that another thread did for the measured one.
struct WorkElsewhere {
    double cpuSeconds = 0; ///< processor time, without drivers and waiting
    std::uint64_t allocations = 0;
};

/// A thread's own work.
struct WorkCosts {
    double cpuSeconds = 0; ///< processor time, without drivers, runtimes and waiting
    std::uint64_t allocations = 0;
    unsigned stalls = 0; ///< see WorkMeter::stalls()
    const char* lastStall = "";

    WorkCosts& operator+=(const WorkCosts& other);
};

/// Call begin() and end() on one thread, which has one meter at a time.
///
/// Only the system knows a thread's processor time, and asking takes longer than most driver calls. The meter therefore
/// asks once in a kWindow, and wherever the runtime's work or waiting begins or ends. In between it measures wall time
/// for each place; no place gets more than the processor time of that window. The result is never too small, and too
/// large by at most one window for each interruption by another program.
class WorkMeter {
  public:
    ~WorkMeter() { end(); }

    /// Starts measuring this thread, from zero.
    void begin();
    void end();
    bool running() const { return current_ == this; }
    /// Wall time since begin(), s; includes the time of other programs.
    double seconds(WorkPlace place) const { return spent_[static_cast<size_t>(place)]; }
    /// Processor time since begin(), s, without the cost of measuring. Wall time if the system does not report a
    /// thread's processor time.
    double cpuSeconds(WorkPlace place) const;
    /// Heap requests of our own work since begin(), without drivers and runtimes; 0 if no counter is set.
    std::uint64_t ownAllocations() const { return ownAllocations_; }
    /// Calls since begin() that made the thread wait for the GPU; costs() also names the last one.
    unsigned stalls() const { return stalls_; }
    const char* lastStall() const { return lastStall_; }

    /// The thread's own work since begin().
    WorkCosts costs() const { return {cpuSeconds(WorkPlace::own), ownAllocations_, stalls_, lastStall_}; }

    WorkPlace place() const { return place_; }

    /// Work of this thread since begin(), for the meter of the thread that it works for.
    WorkElsewhere forAnother() const;
    /// Adds work that another thread did for this one since begin().
    void add(const WorkElsewhere& other);
    const WorkElsewhere& elsewhere() const { return elsewhere_; }

    /// The thread's meter, or nullptr.
    static WorkMeter* current() { return current_; }

    /// Counts the thread's time for `place` from here on; calls made while waiting count as waiting. Returns the
    /// previous place, for leave().
    WorkPlace enter(WorkPlace place) {
        const WorkPlace before = place_;
        if (before != WorkPlace::waiting) change(place);
        return before;
    }
    void leave(WorkPlace before) { change(before); }

    /// Sets the counter of heap requests, `count`: the number of requests of the calling thread so far. Applies to all
    /// meters that begin later; the program itself does not count.
    static void countAllocationsBy(std::uint64_t (*count)()) { countAllocations_ = count; }
    void stalled(const char* call) {
        ++stalls_;
        lastStall_ = call;
    }

    static constexpr std::chrono::microseconds kWindow{100};

  private:
    using Clock = std::chrono::steady_clock;
    using Shares = std::array<double, kWorkPlaces>;

    void change(WorkPlace next);
    void closeWindow();

    static inline thread_local WorkMeter* current_ = nullptr;
    static inline std::uint64_t (*countAllocations_)() = [] { return std::uint64_t{0}; };
    Shares spent_{};
    Shares cpu_{};
    Shares window_{};                           ///< wall time in the current window
    std::array<unsigned, kWorkPlaces> looks_{}; ///< readings of the clock, whose cost is subtracted
    WorkPlace place_ = WorkPlace::own;
    Clock::time_point since_;
    Clock::time_point windowSince_;
    double windowCpuSince_ = 0;
    std::uint64_t allocationsBefore_ = 0;
    std::uint64_t ownAllocations_ = 0;
    WorkElsewhere elsewhere_;
    unsigned stalls_ = 0;
    const char* lastStall_ = "";
};

/// Counts the thread's time for `place` during its lifetime; inside waiting everything counts as waiting.
class InWork {
  public:
    explicit InWork(WorkPlace place) : meter_(WorkMeter::current()) {
        if (meter_ != nullptr) before_ = meter_->enter(place);
    }
    ~InWork() {
        if (meter_ != nullptr) meter_->leave(before_);
    }
    InWork(const InWork&) = delete;
    InWork& operator=(const InWork&) = delete;

  private:
    WorkMeter* meter_;
    WorkPlace before_ = WorkPlace::own;
};

} // namespace meltpool
