// How many threads a driver on the processor is given.
#ifdef __linux__

#include "core/gl/driver_threads.hpp"
#include "tests/support/catch.hpp"

#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

using namespace meltpool;

namespace {

/// Puts the variable back as it was.
class KeptThreads {
  public:
    KeptThreads() {
        if (const char* threads = std::getenv("LP_NUM_THREADS")) before_ = threads;
    }
    ~KeptThreads() {
        if (before_)
            setenv("LP_NUM_THREADS", before_->c_str(), 1);
        else
            unsetenv("LP_NUM_THREADS");
    }

  private:
    std::optional<std::string> before_;
};

} // namespace

TEST_CASE("the driver's threads are spared where there are two processors at most", "[gl]") {
    const KeptThreads kept;
    unsetenv("LP_NUM_THREADS");
    CHECK_FALSE(gl::driverThreadsSpared());
    gl::spareDriverThreads();
    CHECK(gl::driverThreadsSpared() == (std::thread::hardware_concurrency() <= 2));
}

TEST_CASE("a number of driver threads that a person chose stays", "[gl]") {
    const KeptThreads kept;
    setenv("LP_NUM_THREADS", "2", 1);
    gl::spareDriverThreads();
    CHECK(std::string(std::getenv("LP_NUM_THREADS")) == "2");
    CHECK_FALSE(gl::driverThreadsSpared());
}

#endif
