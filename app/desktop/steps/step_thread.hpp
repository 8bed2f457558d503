// A thread that makes the metal's steps while the window's thread draws, where the processor does both.
#pragma once

#include "core/base/work_meter.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace meltpool {

/// An OpenGL context for another thread, which shares buffers, textures and programs with the one it was made in. Made
/// and destroyed on the thread of that one.
class SharingContext {
  public:
    virtual ~SharingContext() = default;
    /// Makes it the calling thread's context; false where that fails.
    virtual bool enter() = 0;
    /// The calling thread has no context any more.
    virtual void leave() = 0;
};

/// Between begin() and wait() the two threads must not touch the same objects of OpenGL. What was written on either
/// side before these two calls is seen after them.
class StepThread {
  public:
    /// For drivers of gl::dispatchesEndAtOnce() only. `context` may be null: then nothing may be begun.
    explicit StepThread(std::unique_ptr<SharingContext> context);
    ~StepThread();
    StepThread(const StepThread&) = delete;
    StepThread& operator=(const StepThread&) = delete;

    /// The thread has its context. Where not, nothing may be begun.
    bool usable() const { return usable_; }

    /// Starts `work` over there; wait() must follow.
    void begin(std::function<void()> work);
    /// Returns when the work is done; throws what it threw. Nothing where none was begun.
    void wait();

    /// How long the last wait() waited, and the time from the begin() before to its end, s.
    double waited() const { return waited_; }
    double seconds() const { return seconds_; }
    /// What the last work cost that thread.
    const WorkMeter& meter() const { return meter_; }

  private:
    void run();
    void serve(std::unique_lock<std::mutex>& lock);
    void freeDeleted();

    std::unique_ptr<SharingContext> context_;
    bool usable_ = false;
    bool begun_ = false; ///< begin() was called and wait() not yet
    std::chrono::steady_clock::time_point began_;
    double waited_ = 0;
    double seconds_ = 0;
    WorkMeter meter_;
    std::chrono::steady_clock::time_point flushed_; ///< on the thread

    std::mutex mutex_; // of all below
    std::condition_variable changed_;
    std::function<void()> work_;
    std::exception_ptr fault_;
    bool ready_ = false;
    bool ending_ = false;
    std::thread thread_;
};

} // namespace meltpool
