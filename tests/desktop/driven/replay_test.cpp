// Tests a saved attempt in the running window: it plays to its end, moves to another moment, and has equal bits again.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Runs the classic demonstration with few particles; the telemetry of a run is a record.
fs::path recordedAttempt() {
    const fs::path folder = scratchFolder("replay-record");
    REQUIRE(runCommand({MELTPOOL_PROGRAM, "run", "classic", "--out", folder.string(), "--seconds", "2", "--set",
                        "particles=1000", "--set", "cells=16", "--size", "64x48"},
                       {{"MELTPOOL_DATA", (test::buildFolder() / "share" / "meltpool").string()}}) == 0);
    return folder / "telemetry.csv";
}

} // namespace

TEST_CASE("a kept attempt plays in the window, goes to any moment, and ends in its own bits") {
    const fs::path file = recordedAttempt();
    TrainerWindow window("replay", {.lesson = "", .arguments = {"--replay", file.string()}});
    const auto shown = [](const json& s) { return s.at("replay"); };
    window.waitFor("the attempt", [&](const json& s) { return s.at("page") == "running" && !shown(s).is_null(); });
    window.waitFor("the attempt's end", [&](const json& s) { return shown(s).at("over") == true; });
    window.waitFor("its bits", [&](const json& s) { return shown(s).at("same") == true; });
    window.takePicture("replay");
    const json bar = window.settle();
    CHECK(bar.at("places").at("replay.time").at(1) > 0.5 * bar.at("window").at("size").at(1).get<double>());
    window.pull("replay.time", 0.4);
    window.waitFor("another moment", [&](const json& s) {
        return shown(s).at("seeking") == false && shown(s).at("over") == false &&
               shown(s).at("time").get<double>() < 0.6 * shown(s).at("duration").get<double>();
    });
    const json there = window.settle();
    CHECK(shown(there).at("playing") == false);
    CHECK(shown(there).at("same").is_null());
    CHECK(there.at("metal").at("steps") > 0);
    window.key("space");
    window.waitFor("its bits again", [&](const json& s) { return shown(s).at("same") == true; });
    window.click("replay.weld");
    window.waitFor("one's own attempt", [&](const json& s) { return shown(s).is_null() && s.at("page") == "running"; });
}

TEST_CASE("a demonstration is framed above its panel, one's own attempt again in the whole window") {
    TrainerWindow window("demonstration-frame", {.lesson = "gmaw-bead"});
    window.click("start.demonstration");
    window.waitFor("the demonstration", [](const json& s) { return !s.at("demonstration").is_null(); });
    const double far = window.settle().at("camera").at("distance");
    window.takePicture("demonstration-frame");
    window.key("F5");
    window.waitFor("one's own attempt", [](const json& s) { return s.at("demonstration").is_null(); });
    CHECK(window.settle().at("camera").at("distance") < far - 0.05);
}

TEST_CASE("a file that is no attempt ends the program with a sentence") {
    const fs::path folder = scratchFolder("replay-fault");
    writeTextFileAtomically(folder / "other.csv", "a,b\n1,2\n");
    Process::Options options;
    options.command = {MELTPOOL_PROGRAM, "--replay", (folder / "other.csv").string(), "--desktop"};
    options.environment = {{"DISPLAY", sharedDisplay().name()},
                           {"HOME", folder.string()},
                           {"XDG_CONFIG_HOME", folder.string()},
                           {"MELTPOOL_DATA", (test::buildFolder() / "share" / "meltpool").string()},
                           {"WAYLAND_DISPLAY", ""}};
    options.output = folder / "output.txt";
    Process process(options);
    CHECK(process.wait(60) == 2);
    CHECK_THAT(readTextFile(folder / "output.txt"), containsText("other.csv: names no lesson; expected"));
}

} // namespace meltpool::test
