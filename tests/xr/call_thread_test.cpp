// Tests that a call that hangs does not block its thread, and its object lives until the call is over.
#include "tests/support/catch.hpp"
#include "xr/call_thread.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <stdexcept>
#include <thread>

using namespace meltpool;
using namespace std::chrono_literals;

namespace {

/// Time limit far beyond any run, sanitizer and busy machine included.
constexpr auto kPatience = 300s;

/// Imitates a runtime that hangs until it is released.
struct Gate {
    std::mutex mutex;
    std::condition_variable changed;
    bool open = false;
    std::atomic<int> calls = 0;
    std::atomic<bool> destroyed = false;
    std::thread::id thread;

    void pass() {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return open; });
    }
    void release() {
        const std::lock_guard lock(mutex);
        open = true;
        changed.notify_all();
    }
};

struct Caller : xr::ThreadOwned {
    explicit Caller(Gate& theGate) : gate(theGate) {}
    ~Caller() override { gate.destroyed = true; }
    Gate& gate;
};

void count(xr::ThreadOwned& object) {
    Gate& gate = static_cast<Caller&>(object).gate;
    ++gate.calls;
    gate.thread = std::this_thread::get_id();
}

void hang(xr::ThreadOwned& object) {
    static_cast<Caller&>(object).gate.pass();
    ++static_cast<Caller&>(object).gate.calls;
}

void fail(xr::ThreadOwned&) {
    throw std::runtime_error("lost");
}

/// Loads the processor for 20 ms of its time, of which a driver and a wait have 5 each.
void work(xr::ThreadOwned&) {
    const auto keep = [](double seconds) {
        const auto now = [] {
            timespec time{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        };
        for (const double end = now() + seconds; now() < end;) {
        }
    };
    keep(0.004);
    {
        const InWork driver(WorkPlace::driver);
        keep(0.005);
    }
    {
        const InWork waiting(WorkPlace::waiting);
        keep(0.005);
    }
    const InWork runtime(WorkPlace::runtime);
    keep(0.006);
}

void sleep(xr::ThreadOwned&) {
    std::this_thread::sleep_for(30ms);
}

} // namespace

TEST_CASE("calls run one after the other on a thread of their own, and their faults come back once") {
    Gate gate;
    {
        xr::CallThread thread(std::make_unique<Caller>(gate));
        for (int i = 1; i <= 100; ++i) {
            thread.begin(count);
            REQUIRE(thread.wait(kPatience));
            REQUIRE(gate.calls == i);
        }
        CHECK(gate.thread != std::this_thread::get_id());
        thread.begin(fail);
        REQUIRE(thread.wait(kPatience));
        CHECK_THROWS_WITH(thread.rethrow(), "lost");
        CHECK_NOTHROW(thread.rethrow());
        CHECK_FALSE(gate.destroyed);
    }
    CHECK(gate.destroyed);
}

TEST_CASE("a call that hangs is given up, others are refused meanwhile, and all goes on when it comes back") {
    Gate gate;
    xr::CallThread thread(std::make_unique<Caller>(gate));
    thread.begin(hang);
    CHECK_FALSE(thread.wait(20ms));
    CHECK_FALSE(thread.over());
    CHECK_THROWS_AS(thread.begin(count), xr::Stalled);
    gate.release();
    CHECK(thread.wait(kPatience));
    CHECK(gate.calls == 1);
    thread.begin(count);
    CHECK(thread.wait(kPatience));
    CHECK(gate.calls == 2);
}

TEST_CASE("a call's work is told to who measures it: without drivers, without waiting, without sleep") {
    Gate gate;
    xr::CallThread thread(std::make_unique<Caller>(gate));
    const auto took = [&](xr::CallThread::Call call) {
        thread.begin(call);
        REQUIRE(thread.wait(kPatience));
        return thread.work().cpuSeconds;
    };
    /// The least of some calls counts: a host that takes the processor away, or a sanitizer at work, adds to single
    /// ones.
    const auto least = [&](xr::CallThread::Call call) {
        double seconds = took(call);
        for (int i = 1; i < 8; ++i)
            seconds = std::min(seconds, took(call));
        return seconds;
    };
    CHECK(took(work) == 0); // no meter runs
    WorkMeter meter;
    meter.begin();
    const double busy = least(work);
    CHECK(busy > 0.0095);
    CHECK(busy < 0.0145);
    const double asleep = least(sleep);
    CHECK(asleep > 0);
    CHECK(asleep < 0.005);
    meter.end();
    CHECK(took(work) == 0);
}

TEST_CASE("what a hanging call works on outlives its owner, and is gone soon after it comes back") {
    Gate gate;
    std::shared_ptr<const std::atomic<bool>> gone;
    {
        xr::CallThread thread(std::make_unique<Caller>(gate));
        thread.begin(hang);
        gone = thread.leave();
    }
    CHECK_FALSE(*gone);
    CHECK_FALSE(gate.destroyed);
    gate.release();
    for (int i = 0; i < 30000 && !*gone; ++i)
        std::this_thread::sleep_for(10ms);
    CHECK(*gone);
    CHECK(gate.destroyed);
    CHECK(gate.calls == 1);
}
