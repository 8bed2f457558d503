// Measures where a frame's time goes on a thread: the program's own work, the graphics driver, the headset's runtime,
// or waiting. Code that calls a driver or runtime marks the call with InWork; without a meter that costs one test of a
// pointer.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace meltpool {

enum class WorkPlace { own, driver, runtime, waiting };
constexpr size_t kWorkPlaces = 4;

/// Work of another thread for the measured one.
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

/// begin() and end() are called on one thread, which has one meter at a time.
///
/// Only the system knows a thread's processor time, and asking takes longer than most driver calls. So the meter asks
/// once in a kWindow, and wherever the runtime's work or waiting begins or ends. In between it measures wall time for
/// each place; no place gets more than the processor time of that window. The result is never too small, and too large
/// by at most one window for each interruption by another program.
class WorkMeter {
  public:
    ~WorkMeter() { end(); }

    /// Starts measuring this thread, from zero.
    void begin();
    void end();
    bool running() const { return current_ == this; }
    /// Wall time since begin(), s; includes time that other programs took.
    double seconds(WorkPlace place) const { return spent_[static_cast<size_t>(place)]; }
    /// Processor time since begin(), s, without the cost of measuring. Wall time where the system does not tell a
    /// thread's processor time.
    double cpuSeconds(WorkPlace place) const;
    /// Requests to the heap since begin() by work of our own, not by drivers and runtimes; 0 where nothing counts them.
    std::uint64_t ownAllocations() const { return ownAllocations_; }
    /// Calls since begin() that made the thread wait for the GPU, and the name of the last one.
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

    /// From here on the thread's time belongs to `place`; what is called while waiting counts as waiting. Answers where
    /// it belonged before, for leave().
    WorkPlace enter(WorkPlace place) {
        const WorkPlace before = place_;
        if (before != WorkPlace::waiting) change(place);
        return before;
    }
    void leave(WorkPlace before) { change(before); }

    /// `count` answers how often the calling thread has asked the heap so far. For all meters that begin later; the
    /// program itself does not count.
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

/// While it exists, the thread's time counts for `place`; inside of waiting everything counts as waiting.
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
