// The commands that only print: help, lessons, doctor, and the program without a display.
#include "app/commands/headless_runner.hpp"
#include "app/platform/progress_bar.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

TEST_CASE("every command explains itself", "[app]") {
    for (const char* command :
         {"", "run ", "replay ", "compare ", "demonstration ", "bench ", "doctor ", "lessons ", "recordings ", "check ",
          "report ", "validate ", "history ", "completion ", "manual "}) {
        INFO(command);
        const test::Outcome outcome = runMeltpool(std::string(command) + "--help");
        CHECK(outcome.code == 0);
        CHECK_THAT(outcome.output, containsText("--help"));
    }
    CHECK_THAT(runMeltpool("--version").output, containsText("meltpool "));
}

TEST_CASE("lessons and their values are listed", "[app]") {
    CHECK_THAT(runMeltpool("lessons").output, containsText("classic"));
    const test::Outcome values = runMeltpool("lessons classic");
    CHECK(values.code == 0);
    for (const char* key : {"particles", "viscosity", "solidify_rate", "cells", "material", "azimuth", "source"})
        CHECK_THAT(values.output, containsText(std::string("\n") + key + " "));
}

TEST_CASE("the doctor finds driver and files, and says when the files are gone", "[app]") {
    const test::Outcome well = runMeltpool("doctor", "env -u DISPLAY -u WAYLAND_DISPLAY");
    INFO(well.output);
    CHECK(well.code == 0);
    for (const char* word : {"EGL", "OpenGL", "display", "lessons", "storage buffer"})
        CHECK_THAT(well.output, containsText(word));
    const test::Outcome ill = runMeltpool("doctor", "env MELTPOOL_DATA=/nowhere");
    CHECK(ill.code == 1);
    CHECK_THAT(ill.output, containsText("MISSING"));
    CHECK_THAT(ill.output, containsText("/nowhere"));
}

TEST_CASE("the doctor says that a newer software driver is faster, where the driver is an old one", "[app]") {
    const test::Outcome outcome = runMeltpool("doctor");
    INFO(outcome.output);
    const size_t version = outcome.output.find("Mesa ");
    const bool old = version != std::string::npos && outcome.output.find("llvmpipe") != std::string::npos &&
                     std::stoi(outcome.output.substr(version + 5)) < 25;
    CHECK((outcome.output.find("a newer one is faster") != std::string::npos) == old);
}

TEST_CASE("the doctor says how both eyes are drawn, and what the driver lacks for the best way", "[app]") {
    // Only Mesa reads this variable.
    const test::Outcome poor = runMeltpool("doctor", "env MESA_EXTENSION_OVERRIDE=-GL_ARB_shader_viewport_layer_array");
    INFO(poor.output);
    CHECK(poor.code == 0);
    CHECK_THAT(poor.output, containsText("both eyes"));
    if (poor.output.find("Mesa") != std::string::npos)
        CHECK_THAT(poor.output, containsText("between clip distances; the graphics driver has no GL_ARB"));
}

TEST_CASE("numbers of steps and names of pictures follow the time", "[app]") {
    CHECK(stepsFor(1, static_cast<double>(1.0f / 60)) == 60);
    CHECK(stepsFor(10, static_cast<double>(1.0f / 60)) == 600);
    CHECK(stepsFor(0.5, 0.2) == 3);
    CHECK(stepsFor(0, 0.2) == 0);
    CHECK(runPictureName(1.5, "metal") == "001.500s-metal.png");
    CHECK(progressLine("classic", 0.5, 4) == "classic  [###############...............]  50 %, 4 s left");
}
