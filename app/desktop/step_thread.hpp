// Makes the metal's steps on a thread while the window's thread draws, if the processor does both.
#pragma once

#include "app/desktop/step_context.hpp"
#include "core/base/work_meter.hpp"
#include "core/gl/context_thread.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace meltpool {

/// Runs work on a thread with its own context. Between begin() and wait() the two threads must not touch the same
/// memory. Memory written on either side before these two calls, or before run(), is visible after them.
class StepThread final : public gl::ContextThread {
  public:
    explicit StepThread(std::unique_ptr<StepContext> context);
    ~StepThread() override;
    StepThread(const StepThread&) = delete;
    StepThread& operator=(const StepThread&) = delete;

    /// Returns true if the thread has its context. Without it, nothing may be begun or run.
    bool usable() const { return usable_; }

    /// Starts `work` on the thread; wait() must follow.
    void begin(std::function<void()> work);
    /// Returns when the work is done; throws its exception. No-op without begun work.
    void wait();

    /// Runs `work` on the thread and returns after it; begun work goes first.
    void run(FunctionRef<void()> work) override;
    bool here() const override { return std::this_thread::get_id() == thread_.get_id(); }
    gl::ShaderLibrary& shaders() override { return context_->shaders(); }

    /// Waiting time of the last wait(), and the time from its begin() to its end, s.
    double waited() const { return waited_; }
    double seconds() const { return seconds_; }
    /// Returns the thread's work costs since the last call. Call only while no work is under way.
    WorkCosts takeCosts() { return std::exchange(costs_, {}); }

  private:
    void live();
    void serve(std::unique_lock<std::mutex>& lock, gl::BarrierFreeThread& barrierFree);

    std::unique_ptr<StepContext> context_;
    bool usable_ = false;
    bool begun_ = false; ///< begin() was called and wait() not yet
    std::chrono::steady_clock::time_point began_;
    double waited_ = 0;
    double seconds_ = 0;
    WorkCosts costs_;

    std::mutex mutex_; // guards all members below
    std::condition_variable changed_;
    std::function<void()> work_;
    std::exception_ptr fault_;
    bool ready_ = false;
    bool ending_ = false;
    std::thread thread_;
};

} // namespace meltpool
