#include "app/desktop/step_thread.hpp"

#include <utility>

namespace meltpool {

StepThread::StepThread(std::unique_ptr<StepContext> context) : context_(std::move(context)) {
    thread_ = std::thread([this] { live(); });
    // The window's thread makes no OpenGL call while the other thread takes its context.
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ready_; });
}

StepThread::~StepThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void StepThread::live() {
    usable_ = context_->enter();
    gl::BarrierFreeThread barrierFree;
    std::unique_lock lock(mutex_);
    ready_ = true;
    changed_.notify_all();
    while (true) {
        changed_.wait(lock, [this] { return work_ != nullptr || ending_; });
        if (work_ == nullptr) break;
        serve(lock, barrierFree);
        changed_.notify_all();
    }
    lock.unlock();
    if (usable_) context_->leave();
}

/// Does the waiting work, without the lock.
void StepThread::serve(std::unique_lock<std::mutex>& lock, gl::BarrierFreeThread& barrierFree) {
    lock.unlock();
    std::exception_ptr fault;
    WorkMeter meter;
    meter.begin();
    try {
        work_();
    } catch (...) {
        fault = std::current_exception();
    }
    barrierFree.freeDeleted();
    meter.end();
    lock.lock();
    costs_ += meter.costs();
    fault_ = fault;
    work_ = nullptr;
}

void StepThread::begin(std::function<void()> work) {
    began_ = std::chrono::steady_clock::now();
    {
        const std::lock_guard lock(mutex_);
        work_ = std::move(work);
        begun_ = true;
    }
    changed_.notify_all();
}

void StepThread::wait() {
    if (!begun_) return;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return work_ == nullptr; });
    begun_ = false;
    const Clock::time_point end = Clock::now();
    waited_ = std::chrono::duration<double>(end - start).count();
    seconds_ = std::chrono::duration<double>(end - began_).count();
    if (fault_ != nullptr) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void StepThread::run(FunctionRef<void()> work) {
    if (here()) return work();
    std::exception_ptr fault;
    const auto guarded = [&] {
        try {
            work();
        } catch (...) {
            fault = std::current_exception();
        }
    };
    {
        const InWork waiting(WorkPlace::waiting);
        const auto idle = [this] { return work_ == nullptr; };
        std::unique_lock lock(mutex_);
        changed_.wait(lock, idle);
        const std::exception_ptr before = fault_; // fault of the begun work: wait() throws it
        work_ = FunctionRef<void()>(guarded);
        changed_.notify_all();
        changed_.wait(lock, idle);
        fault_ = before;
    }
    if (fault != nullptr) std::rethrow_exception(fault);
}

} // namespace meltpool
