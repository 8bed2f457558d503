#include "core/gl/driver_threads.hpp"

#include <cstdlib>
#include <string_view>
#include <thread>

namespace meltpool::gl {

namespace {

constexpr const char* kThreadsKey = "LP_NUM_THREADS";

} // namespace

void spareDriverThreads() {
#ifdef __linux__
    if (std::thread::hardware_concurrency() <= 2) setenv(kThreadsKey, "0", 0);
#endif
}

bool driverThreadsSpared() {
    const char* threads = std::getenv(kThreadsKey);
    return threads != nullptr && std::string_view(threads) == "0";
}

} // namespace meltpool::gl
