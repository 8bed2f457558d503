// Tests start menu, settings over restarts, broken settings, ends of the program, and drivers that are too old.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <csignal>

namespace meltpool::test {

using nlohmann::json;

namespace {

int wholeNumber(const json& state, const std::string& section, const std::string& key) {
    return std::stoi(parameterIn(state, section, key));
}

bool showsMessage(const json& state, const std::string& part) {
    for (const std::string text : state.at("messages"))
        if (text.find(part) != std::string::npos) return true;
    return false;
}

} // namespace

TEST_CASE("the start menu sets particles, arrangement, influence and grid; start, restart and defaults work") {
    TrainerWindow window("start-menu", {});
    json s = window.state();
    CHECK(s.at("page") == "start");
    CHECK(parameterIn(s, "start", "particles") == "1000");
    CHECK_FALSE(s.at("places").contains("start.particles")); // only in the expert drawer
    window.click("start.group.Expert");
    window.change("start", "particles", [&] { window.pull("start.particles", 0.3); });
    window.change("start", "arrangement", [&] { window.click("start.arrangement.random"); });
    window.change("start", "cells", [&] { window.pull("start.cells", 0.2); });
    window.change("start", "influence", [&] { window.pull("start.influence", 0.3); });
    s = window.settle();
    const int particles = wholeNumber(s, "start", "particles");
    CHECK(particles != 1000);
    CHECK(parameterIn(s, "start", "arrangement") == "random");
    CHECK(wholeNumber(s, "start", "cells") > 16);
    CHECK(wholeNumber(s, "start", "influence") == 3);

    window.start();
    CHECK(window.state().at("metal").at("particles") == particles);
    window.click("bar.restart");
    s = window.waitFor("the start menu", [](const json& t) { return t.at("page") == "start"; });
    CHECK(wholeNumber(s, "start", "particles") == particles);

    window.click("start.defaults");
    s = window.waitFor("the metal to run", [](const json& t) { return t.at("metal").at("particles") == 20032; });
    CHECK(parameterIn(s, "start", "arrangement") == "ordered");
    CHECK(parameterIn(s, "start", "cells") == "64");
    CHECK(parameterIn(s, "start", "influence") == "2");
}

TEST_CASE("a slider takes a typed number and gives its first value back") {
    TrainerWindow window("typing", {});
    window.click("start.group.Expert");
    const auto [x, y, width, height] = window.place("start.particles");
    window.moveMouse(x + width / 2, y + height / 2);
    window.xdotool({"keydown", "ctrl"});
    window.settle();
    window.xdotool({"click", "1"});
    window.settle();
    window.xdotool({"keyup", "ctrl"});
    window.settle();
    window.xdotool({"type", "1235"});
    window.settle();
    window.xdotool({"keydown", "Return"});
    window.waitFor("1235 particles", [](const json& s) { return parameterIn(s, "start", "particles") == "1235"; });
    window.xdotool({"keyup", "Return"});
    window.click("start.particles.back");
    window.waitFor("the first value", [](const json& s) { return parameterIn(s, "start", "particles") == "20032"; });
}

TEST_CASE("closing the window ends the program well and keeps the settings") {
    const auto folder = [] {
        TrainerWindow window("closing", {});
        window.click("start.group.Expert");
        window.change("start", "arrangement", [&] { window.click("start.arrangement.random"); });
        window.start();
        window.click("bar.view");
        window.click("view.material.gold");
        window.waitFor("gold", [](const json& s) { return parameterIn(s, "view", "material") == "gold"; });
        window.closeWindow();
        CHECK(window.finish() == 0);
        CHECK(window.output().empty());
        return readTextFile(window.settingsFile());
    }();
    CHECK_THAT(folder, containsText("arrangement = \"random\""));
    CHECK_THAT(folder, containsText("material = \"gold\""));
    CHECK_THAT(folder, containsText("particles = 1000"));
    TrainerWindow again("closing-again", {.settings = folder});
    const json s = again.state();
    CHECK(parameterIn(s, "view", "material") == "gold");
    CHECK(parameterIn(s, "start", "arrangement") == "random");
    CHECK(s.at("panels").at("view") == true);
    CHECK(s.at("messages").empty());
}

TEST_CASE("SIGINT and SIGTERM end the program as the window's cross does") {
    for (const int number : {SIGINT, SIGTERM}) {
        TrainerWindow window("signal", {});
        window.click("start.group.Expert");
        window.change("start", "arrangement", [&] { window.click("start.arrangement.random"); });
        window.process().signal(number);
        CHECK(window.finish() == 0);
        CHECK_THAT(readTextFile(window.settingsFile()), containsText("arrangement = \"random\""));
    }
}

TEST_CASE("broken settings are told on the screen and set aside, never a crash") {
    TrainerWindow window("broken", {.settings = "[start\nparticles = "});
    const json s = window.state();
    CHECK(s.at("page") == "start");
    CHECK(parameterIn(s, "start", "particles") == "20032");
    // A warning disappears after a while.
    window.waitFor("the fault and the name of the copy", [](const json& row) {
        return showsMessage(row, "settings.toml:1") && showsMessage(row, "settings.broken-1.toml");
    });
    CHECK(std::filesystem::exists(window.settingsFile().parent_path() / "settings.broken-1.toml"));
    window.takePicture("broken-settings");

    TrainerWindow other("wrong-values", {.settings = "[start]\nparticles = -5\ncells = 16\nparticels = 3\n"});
    const json t = other.state();
    CHECK(parameterIn(t, "start", "particles") == "20032");
    CHECK(parameterIn(t, "start", "cells") == "16");
    other.waitFor("both faults", [](const json& row) {
        return showsMessage(row, "settings.toml:2") && showsMessage(row, "settings.toml:4: unknown key 'particels'");
    });
}

TEST_CASE("a lesson whose torch path is of another program or cannot weld it says so when it opens") {
    const auto folder = scratchFolder("robot-lesson");
    writeTextFileAtomically(folder / "robot.csv", "time_s;x_mm;y_mm;z_mm;qx;qy;qz;qw;trigger\n"
                                                  "0;1250;400;800;-0.7071;0;0;0.7071;1\n"
                                                  "1;1260;400;800;-0.7071;0;0;0.7071;0\n");
    writeTextFileAtomically(folder / "robot.toml", "title = 'Robot'\nmodel = 'weld'\ntorch = 'robot.csv'\n");
    TrainerWindow window("robot", {.lesson = (folder / "robot.toml").string()});
    window.waitFor("how the table is read, and the warning", [](const json& row) {
        return showsMessage(row, "robot.csv is read as UTF-8, columns separated by semicolons") &&
               showsMessage(row, "The torch path robot.csv is wholly outside the workpiece");
    });
}

TEST_CASE("too little OpenGL is refused in one sentence, a telemetry file that cannot be written too") {
    const auto folder = scratchFolder("refused");
    const auto refuse = [&](std::vector<std::string> arguments, std::map<std::string, std::string> environment) {
        arguments.insert(arguments.begin(), MELTPOOL_PROGRAM);
        environment["DISPLAY"] = sharedDisplay().name();
        environment["WAYLAND_DISPLAY"] = "";
        environment["XDG_CONFIG_HOME"] = folder.string();
        environment["XDG_DATA_HOME"] = folder.string();
        Process process(
            {.command = arguments, .environment = environment, .output = folder / "output.txt", .folder = folder});
        CHECK(process.wait(300) == 2);
        return readTextFile(folder / "output.txt");
    };
    const std::string old = refuse({}, {{"MESA_GL_VERSION_OVERRIDE", "3.1"}, {"LIBGL_ALWAYS_SOFTWARE", ""}});
    CHECK_THAT(old, containsText("OpenGL 4.5 core"));
    CHECK_THAT(old, containsText("3.1"));
    CHECK_THAT(old, containsText("LIBGL_ALWAYS_SOFTWARE=1"));
    CHECK(splitText(trimText(old), '\n').size() == 1);
    CHECK_THAT(refuse({}, {{"MESA_GL_VERSION_OVERRIDE", "3.1"}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}),
               !containsText("set LIBGL_ALWAYS_SOFTWARE=1"));
    const std::string blocked = refuse({"--telemetry", (folder / "none" / "t.jsonl").string()}, {});
    CHECK_THAT(blocked, containsText("t.jsonl"));
    const std::string unknown = refuse({"--lesson", "knitting"}, {});
    CHECK_THAT(unknown, containsText("knitting"));
}

} // namespace meltpool::test
