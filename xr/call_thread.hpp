// A thread for calls that may never come back: whoever asked goes on without the answer.
#pragma once

#include "core/base/error.hpp"
#include "core/base/work_meter.hpp"

#include <atomic>
#include <chrono>
#include <memory>

namespace meltpool::xr {

/// The runtime has not answered for as long as anyone can wait.
class Stalled : public RuntimeFault {
  public:
    Stalled() : RuntimeFault("the OpenXR runtime does not answer") {}
};

/// What a CallThread's calls work on. Belongs to the thread from then on: it is destroyed there, after the last call.
class Callee {
  public:
    virtual ~Callee() = default;
};

/// Runs one call at a time. All calls come from one other thread.
class CallThread {
  public:
    explicit CallThread(std::unique_ptr<Callee> callee);
    /// Has the callee destroyed and waits for that at most `kFarewell`; a thread that hangs by then is left behind and
    /// ends itself when its call returns.
    ~CallThread();
    CallThread(const CallThread&) = delete;
    CallThread& operator=(const CallThread&) = delete;

    static constexpr std::chrono::milliseconds kFarewell{3000};

    using Call = void (*)(Callee&);
    /// Begins a call; the last one must be over.
    void begin(Call call);
    /// The call is over, or there was none.
    bool over() const;
    /// Waits for its end at most so long; then as over().
    bool wait(std::chrono::milliseconds patience) const;
    /// Throws what the call that is over has thrown; once.
    void rethrow();
    /// What the call that is over took, from waking up for it on, where the thread that began it has a WorkMeter.
    WorkElsewhere work() const;

    /// Lets go of thread and callee without waiting; only destroying is left. True from when both are gone.
    std::shared_ptr<const std::atomic<bool>> leave();

  private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);
    std::shared_ptr<Shared> shared_;
};

} // namespace meltpool::xr
