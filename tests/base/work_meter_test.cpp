// The meter of a thread's work: it assigns processor time to the right place and does not count sleep.
#include "core/base/work_meter.hpp"
#include "tests/support/catch.hpp"

#include <ctime>
#include <thread>

using namespace meltpool;
using namespace std::chrono_literals;

#if defined(CLOCK_THREAD_CPUTIME_ID)

namespace {

// Windows counts a thread's processor time by ticks of up to 16 ms.
#ifdef _WIN32
constexpr double kUnit = 0.1;   // s
constexpr int kCalls = 20;      // each call takes a tick
constexpr double kTick = 0.016; // s; a tick may end between the two readings, this test's and the meter's
#else
constexpr double kUnit = 0.01;
constexpr int kCalls = 1000;
constexpr double kTick = 0;
#endif

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Uses this amount of processor time, however long it takes by the clock.
void work(double seconds) {
    for (const double end = threadSeconds() + seconds; threadSeconds() < end;) {
    }
}

} // namespace

TEST_CASE("work is counted where it is done, by the processor's time") {
    WorkMeter meter;
    const double before = threadSeconds();
    meter.begin();
    work(2 * kUnit);
    {
        const InWork runtime(WorkPlace::runtime);
        work(kUnit);
        const InWork driver(WorkPlace::driver);
        work(0.5 * kUnit);
    }
    meter.end();
    // A busy machine gives a thread more processor time than requested: each place has at most the time that the others
    // leave.
    const double spent = threadSeconds() - before;
    CHECK(meter.cpuSeconds(WorkPlace::own) > 1.95 * kUnit);
    CHECK(meter.cpuSeconds(WorkPlace::own) < spent - 1.4 * kUnit);
    CHECK(meter.cpuSeconds(WorkPlace::runtime) > 0.95 * kUnit);
    CHECK(meter.cpuSeconds(WorkPlace::runtime) < spent - 2.4 * kUnit);
    CHECK(meter.cpuSeconds(WorkPlace::driver) > 0.45 * kUnit);
    CHECK(meter.cpuSeconds(WorkPlace::waiting) == 0);
    CHECK(meter.forAnother().cpuSeconds ==
          Approx(meter.cpuSeconds(WorkPlace::own) + meter.cpuSeconds(WorkPlace::runtime)));
}

TEST_CASE("sleep takes the clock's time, not the processor's") {
    WorkMeter meter;
    meter.begin();
    std::this_thread::sleep_for(30ms);
    {
        const InWork runtime(WorkPlace::runtime);
        std::this_thread::sleep_for(30ms);
    }
    meter.end();
    for (const WorkPlace place : {WorkPlace::own, WorkPlace::runtime}) {
        CHECK(meter.seconds(place) > 0.029);
        CHECK(meter.cpuSeconds(place) < kUnit);
    }
}

TEST_CASE("work between many short calls of a driver is counted, and the calls are not") {
    WorkMeter meter;
    double own = 0, driver = 0;
    const auto timed = [](double& sum, double seconds) {
        const double start = threadSeconds();
        work(seconds);
        sum += threadSeconds() - start;
    };
    meter.begin();
    for (int i = 0; i < kCalls; ++i) {
        timed(own, 10e-6);
        const InWork call(WorkPlace::driver);
        timed(driver, 20e-6);
    }
    meter.end();
    CHECK(meter.cpuSeconds(WorkPlace::own) > 0.95 * own - kTick);
    CHECK(meter.cpuSeconds(WorkPlace::own) < own + 0.4 * driver);
}

#endif

TEST_CASE("work of another thread is reported separately, from zero after every begin") {
    WorkMeter meter;
    meter.begin();
    meter.add({0.5, 3});
    meter.add({0.25, 1});
    CHECK(meter.elsewhere().cpuSeconds == 0.75);
    CHECK(meter.elsewhere().allocations == 4);
    CHECK(meter.seconds(WorkPlace::runtime) == 0);
    meter.begin();
    CHECK(meter.elsewhere().cpuSeconds == 0);
    CHECK(meter.elsewhere().allocations == 0);
}
