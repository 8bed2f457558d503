// Where a frame's time goes on its threads: into our own work, the graphics driver, the headset's runtime, or waiting.
// Whoever calls into a driver or runtime says so; without a meter that costs one look at a pointer.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace meltpool {

enum class WorkPlace { own, driver, runtime, waiting };
constexpr size_t kWorkPlaces = 4;

/// What another thread did for the one that is measured.
struct WorkElsewhere {
    double cpuSeconds = 0; ///< the processor's time, without drivers and without waiting
    std::uint64_t allocations = 0;
};

/// Begun and ended on one thread; one at a time.
///
/// The processor's time is known only from the system, and asking it takes longer than most calls of a driver. So the
/// system is asked once in a kWindow and wherever runtime or waiting begin or end; in between the clock tells who had
/// the time, of which no place gets more than the processor spent in that window. A place is never told too little; too
/// much by at most one window each time another program interrupts.
class WorkMeter {
  public:
    ~WorkMeter() { end(); }

    /// From here on this thread's time is counted, from zero.
    void begin();
    void end();
    bool running() const { return current_ == this; }
    /// Time since begin(), s. Of the clock, so that what other programs took from us counts too.
    double seconds(WorkPlace place) const { return spent_[static_cast<size_t>(place)]; }
    /// The processor's time since begin(), s, less what measuring it took. Where the system does not tell a thread's
    /// time, as seconds().
    double cpuSeconds(WorkPlace place) const;
    /// Requests to the heap since begin() by work of our own, not by drivers and runtimes; 0 where nothing counts them.
    std::uint64_t ownAllocations() const { return ownAllocations_; }
    /// Calls since begin() after which the thread stood still until the GPU had got somewhere, and the last one's name.
    unsigned stalls() const { return stalls_; }
    const char* lastStall() const { return lastStall_; }

    WorkPlace place() const { return place_; }

    /// What this thread did since begin(), for the meter of the thread that it worked for.
    WorkElsewhere forAnother() const;
    /// Adds what another thread did for this one since begin().
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
    Shares window_{};                           ///< of the clock, in the window that is open
    std::array<unsigned, kWorkPlaces> looks_{}; ///< at the clock, each of which made its place's time longer
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

/// While it lives the thread's time belongs to `place`; what is called while waiting counts as waiting.
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
