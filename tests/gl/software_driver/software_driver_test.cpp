// The software driver: its name and version, and its number of threads.
#include "core/gl/software_driver/software_driver.hpp"
#include "tests/support/catch.hpp"

#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

using namespace meltpool;

TEST_CASE("the version of Mesa is read from OpenGL's version text", "[gl]") {
    CHECK(gl::mesaMajor("4.5 (Core Profile) Mesa 22.3.6") == 22);
    CHECK(gl::mesaMajor("4.6 (Compatibility Profile) Mesa 25.0.7-2+deb13u1") == 25);
    CHECK(gl::mesaMajor("4.6.0 NVIDIA 535.183.01") == 0);
    CHECK(gl::mesaMajor("4.5 Mesa devel") == 0);
    CHECK(gl::mesaMajor("") == 0);
}

TEST_CASE("a newer driver is advised where an old one draws on the processor, and only there", "[gl]") {
    const std::string old = "4.5 (Core Profile) Mesa 22.3.6", young = "4.5 (Core Profile) Mesa 25.0.7";
    const auto advice = gl::newerDriver("llvmpipe (LLVM 15.0.6, 256 bits)", old);
    REQUIRE(advice);
    CHECK(advice->found == "Mesa 22: a newer one is faster");
    CHECK(advice->remedy == "Mesa 25, as Debian 13 has it");
    CHECK_FALSE(gl::newerDriver("llvmpipe (LLVM 19.1.7, 256 bits)", young));
    CHECK_FALSE(gl::newerDriver("Mesa Intel(R) UHD Graphics 620", old));
    CHECK_FALSE(gl::newerDriver("SwiftShader Device", "4.5"));
}

TEST_CASE("the processor is told from a card by the extensions of its device", "[gl]") {
    CHECK(gl::isProcessorDevice("EGL_EXT_device_query EGL_MESA_device_software"));
    CHECK_FALSE(gl::isProcessorDevice("EGL_EXT_device_drm"));
    CHECK_FALSE(gl::isProcessorDevice(nullptr));
}

#ifdef __linux__

namespace {

/// Restores the environment variable at its end.
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
    CHECK_FALSE(gl::driverIsSingleThreaded());
    gl::runDriverSingleThreaded();
    CHECK(gl::driverIsSingleThreaded() == (std::thread::hardware_concurrency() <= 2));
}

TEST_CASE("a number of driver threads that a person chose stays", "[gl]") {
    const KeptThreads kept;
    setenv("LP_NUM_THREADS", "2", 1);
    gl::runDriverSingleThreaded();
    CHECK(std::string(std::getenv("LP_NUM_THREADS")) == "2");
    CHECK_FALSE(gl::driverIsSingleThreaded());
}

#endif
