// A thread for calls that may never return: the thread that began a call can give it up and go on.
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
    /// Has the thread destroy the object and waits for that at most `kFarewell`. A thread that still hangs then ends by
    /// itself when its call returns.
    ~CallThread();
    CallThread(const CallThread&) = delete;
    CallThread& operator=(const CallThread&) = delete;

    static constexpr std::chrono::milliseconds kFarewell{3000};

    using Call = void (*)(ThreadOwned&);
    /// Begins a call. Throws Stalled while the last one is not over.
    void begin(Call call);
    /// The call is over, or there was none.
    bool over() const;
    /// Waits at most `patience` for the end of the call; answers over().
    bool wait(std::chrono::milliseconds patience) const;
    /// Throws the exception of the finished call, once.
    void rethrow();
    /// Processor time and allocations of the finished call, counted from when the thread woke up for it. Zero where the
    /// beginning thread has no WorkMeter.
    WorkElsewhere work() const;

    /// Gives up thread and object without waiting; afterwards only the destructor may be called. The answer becomes
    /// true when both are gone.
    std::shared_ptr<const std::atomic<bool>> leave();

  private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);
    std::shared_ptr<Shared> shared_;
};

} // namespace meltpool::xr
