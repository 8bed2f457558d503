#include "xr/call_thread.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace meltpool::xr {

/// Shared by the thread and its owner; destroyed with the last of them.
struct CallThread::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::unique_ptr<ThreadOwned> object;
    Call call = nullptr; ///< present call; nullptr: none
    std::exception_ptr fault;
    bool measured = false; ///< the call is part of a measured frame
    WorkElsewhere work;
    bool leaving = false;
    std::shared_ptr<std::atomic<bool>> gone = std::make_shared<std::atomic<bool>>(false);
};

CallThread::CallThread(std::unique_ptr<ThreadOwned> object) : shared_(std::make_shared<Shared>()) {
    shared_->object = std::move(object);
    std::thread(run, shared_).detach();
}

void CallThread::run(const std::shared_ptr<Shared>& shared) {
    std::unique_lock lock(shared->mutex);
    WorkMeter meter;
    while (true) {
        meter.begin(); // counted from here: sleeping costs no processor time, waking up does
        shared->changed.wait(lock, [&] { return shared->call != nullptr || shared->leaving; });
        if (shared->call == nullptr) break;
        const Call call = shared->call;
        if (!shared->measured) meter.end();
        lock.unlock();
        std::exception_ptr fault;
        try {
            call(*shared->object);
        } catch (...) {
            fault = std::current_exception();
        }
        meter.end();
        lock.lock();
        shared->work = shared->measured ? meter.forAnother() : WorkElsewhere{};
        shared->fault = fault;
        shared->call = nullptr;
        lock.unlock(); // otherwise the woken thread would wait for the lock
        shared->changed.notify_all();
        lock.lock();
    }
    meter.end();
    lock.unlock();
    shared->object.reset();
    lock.lock();
    *shared->gone = true;
    shared->changed.notify_all();
}

CallThread::~CallThread() {
    if (shared_ == nullptr) return;
    const std::shared_ptr<Shared> shared = shared_;
    leave();
    std::unique_lock lock(shared->mutex);
    shared->changed.wait_for(lock, kFarewell, [&] { return shared->gone->load(); });
}

std::shared_ptr<const std::atomic<bool>> CallThread::leave() {
    const std::shared_ptr<Shared> shared = std::exchange(shared_, nullptr);
    const std::lock_guard lock(shared->mutex);
    shared->leaving = true;
    shared->changed.notify_all();
    return shared->gone;
}

void CallThread::begin(Call call) {
    {
        const std::lock_guard lock(shared_->mutex);
        if (shared_->call != nullptr) throw Stalled();
        shared_->fault = nullptr;
        shared_->measured = WorkMeter::current() != nullptr;
        shared_->call = call;
    }
    shared_->changed.notify_all();
}

bool CallThread::over() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->call == nullptr;
}

bool CallThread::wait(std::chrono::milliseconds patience) const {
    std::unique_lock lock(shared_->mutex);
    return shared_->changed.wait_for(lock, patience, [&] { return shared_->call == nullptr; });
}

WorkElsewhere CallThread::work() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->work;
}

void CallThread::rethrow() {
    std::exception_ptr fault;
    {
        const std::lock_guard lock(shared_->mutex);
        std::swap(fault, shared_->fault);
    }
    if (fault) std::rethrow_exception(fault);
}

} // namespace meltpool::xr
