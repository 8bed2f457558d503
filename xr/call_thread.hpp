// Runs calls that may never return on a thread of their own, so that the thread that started a call can abandon it and
// go on.
#pragma once

#include "core/base/error.hpp"
#include "core/base/work_meter.hpp"

#include <atomic>
#include <chrono>
#include <memory>

namespace meltpool::xr {

/// The runtime did not answer within the time that a frame allows.
class Stalled : public RuntimeFault {
  public:
    Stalled() : RuntimeFault("the OpenXR runtime does not answer") {}
};

/// The object that a CallThread's calls work on. The thread owns it and destroys it after the last call.
class ThreadOwned {
  public:
    virtual ~ThreadOwned() = default;
};

/// Runs one call at a time. Only one other thread may begin calls.
class CallThread {
  public:
    explicit CallThread(std::unique_ptr<ThreadOwned> object);
    /// Has the thread destroy the object and waits for that at most `kFarewell`. A thread that still hangs ends by
    /// itself when its call returns.
    ~CallThread();
    CallThread(const CallThread&) = delete;
    CallThread& operator=(const CallThread&) = delete;

    static constexpr std::chrono::milliseconds kFarewell{3000};

    using Call = void (*)(ThreadOwned&);
    /// Begins a call. Throws Stalled while the last one is in progress.
    void begin(Call call);
    /// True if no call is in progress.
    bool over() const;
    /// Waits at most `patience` for the end of the call; returns over().
    bool wait(std::chrono::milliseconds patience) const;
    /// Throws the exception of the finished call, once.
    void rethrow();
    /// Processor time and allocations of the finished call, counted from the thread's wake-up. Zero if the starting
    /// thread has no WorkMeter.
    WorkElsewhere work() const;

    /// Abandons thread and object without waiting; afterwards only the destructor may be called. The returned flag
    /// becomes true when both are gone.
    std::shared_ptr<const std::atomic<bool>> leave();

  private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);
    std::shared_ptr<Shared> shared_;
};

} // namespace meltpool::xr
