// Tests the report of `meltpool doctor` on a real runtime, on a context without a window.
#include "core/gl/context.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/monado_run.hpp"
#include "xr/diagnosis.hpp"

#include <GLFW/glfw3.h>

#include <cstdlib>

using namespace meltpool;
using namespace meltpool::test;

namespace {

std::string valueOf(const xr::Diagnosis& told, const std::string& name) {
    for (const xr::Fact& fact : told.facts)
        if (fact.name == name) return fact.value;
    return "(not told)";
}

} // namespace

TEST_CASE("the doctor sees runtime, headset, formats, rate and controllers", "[runtime]") {
    RemoteDriver driver(driverPort());
    RemoteState state;
    state.hands[0].active = false;
    driver.send(state);
    glfwMakeContextCurrent(nullptr);
    const gl::HeadlessContext headless;
    // The validation layer does not know the EGL binding's struct and refuses the session.
    const std::string layers = std::getenv("XR_ENABLE_API_LAYERS");
    unsetenv("XR_ENABLE_API_LAYERS");
    // The doctor gives controllers a few seconds, and reports the rate of this machine's frames.
    xr::Diagnosis told;
    CHECK(waitUntil([&] {
        told = xr::diagnose(true);
        return valueOf(told, "right controller").find(", tracked") != std::string::npos &&
               valueOf(told, "refresh rate") == "60.0 Hz";
    }));
    setenv("XR_ENABLE_API_LAYERS", layers.c_str(), 1);
    for (const xr::Fact& fact : told.facts)
        UNSCOPED_INFO(fact.name << ": " << fact.value);
    CHECK(told.usable);
    CHECK(told.advice == "");
    CHECK(valueOf(told, "OpenGL binding") == "EGL");
    CHECK_THAT(valueOf(told, "OpenXR runtime"), containsText("Monado"));
    CHECK_THAT(valueOf(told, "picture formats"), containsText("SRGB8_ALPHA8"));
    CHECK(valueOf(told, "refresh rate") == "60.0 Hz");
    CHECK(valueOf(told, "floor") == "known (STAGE)");
    CHECK_THAT(valueOf(told, "right controller"), containsText("tracked"));
    CHECK_THAT(valueOf(told, "left controller"), containsText("off") || containsText("none"));
}

TEST_CASE("the doctor says what is missing where no runtime is set", "[runtime]") {
    const std::string manifest = std::getenv("XR_RUNTIME_JSON");
    setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
    const xr::Diagnosis told = xr::diagnose(false);
    setenv("XR_RUNTIME_JSON", manifest.c_str(), 1);
    CHECK_FALSE(told.usable);
    CHECK_THAT(told.advice, containsText("/nowhere/runtime.json does not exist"));
}
