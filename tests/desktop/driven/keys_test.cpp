// Tests that every key and mouse action of the trainer has its effect in the telemetry.
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

namespace meltpool::test {

using nlohmann::json;

namespace {

double cameraValue(const json& state, const char* name) {
    return state.at("camera").at(name);
}

std::array<double, 3> sourceOf(const json& state) {
    return state.at("source").at("position").get<std::array<double, 3>>();
}

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

bool atHome(const json& state) {
    const auto p = difference(sourceOf(state), {0.9, 0.9, 0.9});
    return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]) < 1e-5;
}

/// Returns the horizontal part of the camera's direction, unit length.
std::array<double, 2> away(const json& state) {
    const auto f = state.at("camera").at("forward").get<std::array<double, 3>>();
    const double length = std::hypot(f[0], f[2]);
    return {f[0] / length, f[2] / length};
}

/// Waits until the source has moved; returns its way: away from the person, to the right and up.
std::array<double, 3> movedAfter(TrainerWindow& window, const json& before) {
    const json after =
        window.waitFor("the source to move", [&](const json& s) { return sourceOf(s) != sourceOf(before); });
    const auto way = difference(sourceOf(window.settle()), sourceOf(before));
    const auto a = away(after);
    return {way[0] * a[0] + way[2] * a[1], -way[0] * a[1] + way[2] * a[0], way[1]};
}

void mouseBy(const TrainerWindow& window, int x, int y) {
    window.xdotool({"mousemove_relative", "--", std::to_string(x), std::to_string(y)});
}

/// Checks the orbit keys in interact mode, with the mouse free.
void checkOrbitKeys(TrainerWindow& window) {
    json s = window.state();
    const double azimuth = cameraValue(s, "azimuth");
    window.holdKey("d", "D to go around", [&](const json& t) { return cameraValue(t, "azimuth") > azimuth + 0.05; });
    window.holdKey("a", "A to go back around",
                   [&](const json& t) { return cameraValue(t, "azimuth") < azimuth - 0.05; });
    const double elevation = cameraValue(s, "elevation");
    window.holdKey("w", "W to go over", [&](const json& t) { return cameraValue(t, "elevation") > elevation + 0.05; });
    window.holdKey("s", "S to go under", [&](const json& t) { return cameraValue(t, "elevation") < elevation - 0.05; });
    window.holdKey("s", "the pole to hold", [&](const json& t) { return cameraValue(t, "elevation") < -1.55; });
    CHECK(cameraValue(window.settle(), "elevation") > -1.5708);
    window.holdKey("w", "the way back up", [&](const json& t) { return cameraValue(t, "elevation") > 0.3; });
    const double distance = cameraValue(s, "distance");
    window.holdKey("e", "E to go farther", [&](const json& t) { return cameraValue(t, "distance") > distance + 0.1; });
    window.holdKey("q", "Q to come nearer", [&](const json& t) { return cameraValue(t, "distance") < distance - 0.1; });
    window.moveMouse(300, 300);
    s = window.settle();
    window.xdotool({"click", "5"});
    window.waitFor("the wheel to go farther",
                   [&](const json& t) { return cameraValue(t, "distance") > cameraValue(s, "distance") * 1.05; });
}

/// Checks the fly keys; changes to view mode.
void checkFlyKeys(TrainerWindow& window) {
    window.key("v");
    const json s = window.waitFor("view mode", [](const json& t) { return t.at("mode") == "view"; });
    const auto steps = window.settle().at("metal").at("steps");
    const auto eye = s.at("camera").at("eye").get<std::array<double, 3>>();
    const auto forward = s.at("camera").at("forward").get<std::array<double, 3>>();
    const auto along = [&](const json& t) {
        const auto way = difference(t.at("camera").at("eye").get<std::array<double, 3>>(), eye);
        return way[0] * forward[0] + way[1] * forward[1] + way[2] * forward[2];
    };
    window.holdKey("w", "W to fly forwards", [&](const json& t) { return along(t) > 0.1; });
    window.holdKey("s", "S to fly back", [&](const json& t) { return along(t) < -0.1; });
    const auto aside = [&](const json& t) {
        const auto way = difference(t.at("camera").at("eye").get<std::array<double, 3>>(), eye);
        return -way[0] * forward[2] + way[2] * forward[0];
    };
    window.holdKey("d", "D to fly to the right", [&](const json& t) { return aside(t) > 0.1; });
    window.holdKey("a", "A to fly to the left", [&](const json& t) { return aside(t) < -0.1; });
    const auto height = [](const json& t) { return t.at("camera").at("eye").at(1).get<double>(); };
    window.holdKey("e", "E to rise", [&](const json& t) { return height(t) > eye[1] + 0.1; });
    window.holdKey("q", "Q to sink", [&](const json& t) { return height(t) < eye[1] - 0.1; });
    CHECK(window.settle().at("metal").at("steps") == steps);
}

/// Checks looking around in view mode; captures the mouse.
void checkCapturedLook(TrainerWindow& window) {
    window.key("c");
    const json s = window.waitFor("the mouse to be captured", [](const json& t) { return t.at("captured") == true; });
    window.settle();
    mouseBy(window, 60, 0);
    window.waitFor("the mouse to look right",
                   [&](const json& t) { return cameraValue(t, "yaw") < cameraValue(s, "yaw") - 0.05; });
    mouseBy(window, 0, 60);
    window.waitFor("the mouse to look down",
                   [&](const json& t) { return cameraValue(t, "pitch") < cameraValue(s, "pitch") - 0.05; });
    window.xdotool({"mousedown", "1"});
    CHECK(window.settle().at("source").at("on") == false);
    window.xdotool({"mouseup", "1"});
    CHECK(atHome(window.settle()));
}

/// Checks the capture keys; starts with the mouse captured.
void checkCaptureKeys(TrainerWindow& window) {
    window.key("c");
    window.waitFor("the mouse to be free", [](const json& t) { return t.at("captured") == false; });
    window.key("c");
    window.waitFor("the mouse to be captured", [](const json& t) { return t.at("captured") == true; });
    window.key("Escape");
    window.waitFor("Escape to free the mouse", [](const json& t) { return t.at("captured") == false; });
}

void checkPanelKeys(TrainerWindow& window) {
    const std::array<std::pair<const char*, const char*>, 5> panels{
        {{"F1", "help"}, {"F2", "view"}, {"F3", "simulation"}, {"F4", "timings"}, {"F9", "hidden"}}};
    for (const auto& [name, panel] : panels) {
        const bool open = window.settle().at("panels").at(panel);
        window.key(name);
        window.waitFor(std::string(name) + " to switch " + panel,
                       [&, p = panel](const json& t) { return t.at("panels").at(p) != open; });
        window.key(name);
        window.waitFor(std::string(name) + " to switch " + panel + " back",
                       [&, p = panel](const json& t) { return t.at("panels").at(p) == open; });
    }
}

/// Checks the source's keys from the start, with the source in a corner of the box.
void checkSourceKeys(TrainerWindow& window) {
    json s = window.state();
    // The source leaves the corner first, so that a step in every direction is possible.
    const double step = std::stod(parameterIn(s, "controls", "source_step"));
    for (int i = 0; i < 12; ++i)
        window.key("Next");
    for (int i = 0; i < 12; ++i)
        window.key("Up");
    s = window.settle();
    const std::array<std::pair<const char*, std::array<double, 3>>, 6> keys{{{"Up", {step, 0, 0}},
                                                                             {"Down", {-step, 0, 0}},
                                                                             {"Right", {0, step, 0}},
                                                                             {"Left", {0, -step, 0}},
                                                                             {"Prior", {0, 0, step}},
                                                                             {"Next", {0, 0, -step}}}};
    for (const auto& [name, expected] : keys) {
        s = window.settle();
        window.key(name);
        const auto way = movedAfter(window, s);
        INFO(name);
        for (size_t i = 0; i < 3; ++i)
            CHECK(way[i] == Approx(expected[i]).margin(1e-4));
    }
}

/// Checks the captured mouse; captures it.
void checkCapturedMouse(TrainerWindow& window) {
    window.moveMouse(300, 320);
    window.key("c");
    window.waitFor("the mouse to be captured", [](const json& t) { return t.at("captured") == true; });
    json s = window.settle();
    mouseBy(window, 50, 0);
    auto way = movedAfter(window, s);
    CHECK(way[1] == Approx(0.1).margin(0.01));
    CHECK(std::abs(way[2]) < 1e-4);
    s = window.settle();
    mouseBy(window, 0, -50);
    way = movedAfter(window, s);
    CHECK(way[2] == Approx(0.1).margin(0.01));
    window.xdotool({"mousedown", "3"});
    s = window.settle();
    mouseBy(window, 0, -50);
    way = movedAfter(window, s);
    CHECK(way[0] == Approx(0.1).margin(0.01));
    CHECK(std::abs(way[2]) < 1e-4);
    window.xdotool({"mouseup", "3"});
    for (const auto& [x, y] : {std::pair{4000, 0}, {0, -4000}, {-9000, 9000}})
        mouseBy(window, x, y);
    for (const double c : sourceOf(window.settle()))
        CHECK(std::abs(c) <= 1);
}

/// Checks heat and cold with the mouse captured; frees it.
void checkHeatAndCold(TrainerWindow& window) {
    // The reset key puts the source at its first place; from there it goes to the metal's corner, which melts.
    window.key("F5");
    window.waitFor("reset", [](const json& t) { return atHome(t) && t.at("metal").at("time") < 2; });
    for (int i = 0; i < 8; ++i)
        window.key("Next");
    for (int i = 0; i < 10; ++i)
        window.key("Up");
    CHECK(window.settle().at("source").at("on") == false);
    CHECK(window.state().at("metal").at("molten") == 0);
    window.xdotool({"mousedown", "1"});
    window.waitFor("the source to burn and the metal to melt", [](const json& t) {
        return t.at("source").at("on") == true && t.at("metal").at("molten") > 5 && t.at("metal").at("hottest") > 0.5;
    });
    window.xdotool({"mouseup", "1"});
    window.waitFor("the source to go out", [](const json& t) { return t.at("source").at("on") == false; });

    window.key("f");
    window.waitFor("the cold source", [](const json& t) { return t.at("source").at("cold") == true; });
    window.xdotool({"mousedown", "1"});
    window.waitFor("everything to freeze", [](const json& t) { return t.at("metal").at("molten") == 0; });
    window.xdotool({"mouseup", "1"});
    window.key("f");
    window.waitFor("the hot source", [](const json& t) { return t.at("source").at("cold") == false; });
    window.key("Escape");
    window.waitFor("a free mouse", [](const json& t) { return t.at("captured") == false; });
}

/// Checks that a free mouse moves the source and heats by a drag on the picture only, not by a click on a panel.
void checkFreeMouse(TrainerWindow& window) {
    json s = window.settle();
    window.moveMouse(320, 340);
    CHECK(sourceOf(window.settle()) == sourceOf(s));
    window.xdotool({"mousedown", "1"});
    window.waitFor("the source to burn", [](const json& t) { return t.at("source").at("on") == true; });
    mouseBy(window, -50, 0);
    const auto way = movedAfter(window, s);
    CHECK(way[1] < -0.05);
    window.xdotool({"mouseup", "1"});
    s = window.settle();
    window.click("simulation.cold");
    CHECK(window.settle().at("source").at("on") == false);
    CHECK(sourceOf(window.state()) == sourceOf(s));
    CHECK(window.state().at("source").at("cold") == true);
    window.click("bar.reset");
    window.waitFor("reset", [](const json& t) {
        return atHome(t) && t.at("metal").at("molten") == 0 && t.at("metal").at("time") < 2;
    });
}

} // namespace

TEST_CASE("camera keys, modes, mouse capture and the shortcuts of panels") {
    TrainerWindow window("camera-keys", {});
    window.start();
    CHECK(window.state().at("mode") == "interact");
    CHECK(window.state().at("captured") == false);
    checkOrbitKeys(window);
    checkFlyKeys(window);
    const auto steps = window.settle().at("metal").at("steps");
    checkCapturedLook(window);
    CHECK(window.state().at("metal").at("steps") == steps); // nothing runs in view mode
    checkCaptureKeys(window);
    window.key("v");
    window.waitFor("the metal to go on",
                   [&](const json& t) { return t.at("mode") == "interact" && t.at("metal").at("steps") > steps; });
    checkPanelKeys(window);
}

TEST_CASE("keys and mouse move the source, the button heats, the cold source freezes, reset puts all back") {
    TrainerWindow window("source", {});
    window.start();
    CHECK(atHome(window.state()));
    checkSourceKeys(window);
    checkCapturedMouse(window);
    checkHeatAndCold(window);
    checkFreeMouse(window);
}

TEST_CASE("simulated time never outruns real time") {
    TrainerWindow window("pace", {});
    window.start();
    struct Moment {
        double real, metal; ///< s
    };
    std::vector<Moment> rows;
    const json begin = window.settle();
    window.waitFor("three seconds, in which the metal goes on", [&](const json& s) {
        rows.push_back({s.at("seconds").get<double>(), s.at("metal").at("time").get<double>()});
        return rows.back().real > begin.at("seconds").get<double>() + 3 &&
               rows.back().metal > begin.at("metal").at("time").get<double>() + 0.5;
    });
    // A row's metal is as old as its frame's begin, its clock is read at the frame's end: between two rows the metal
    // advances no farther than the clock since the row before the first of them, which was written before that frame
    // began.
    constexpr double kOwed = 1.0 / 60; // s, a step
    double ahead = -1;
    for (size_t i = 1; i < rows.size(); ++i)
        for (size_t j = i + 1; j < rows.size(); ++j)
            ahead = std::max(ahead, rows[j].metal - rows[i].metal - (rows[j].real - rows[i - 1].real));
    CHECK(ahead <= kOwed + 1e-3);
}

TEST_CASE("the keys have the names of the keyboard that is there, and do the same at their place") {
    VirtualDisplay display(96);
    const auto layout = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "setxkbmap");
        REQUIRE(runCommand(words, {{"DISPLAY", display.name()}}) == 0);
    };
    const auto named = [](const std::string& key, const std::string& name) {
        return [=](const json& s) { return s.at("keys").at(key) == name; };
    };
    layout({"fr"});
    TrainerWindow window("french-keyboard", {.display = &display});
    CHECK(named("W", "Z")(window.state()));
    CHECK(named("A", "Q")(window.state()));
    CHECK(named("Q", "A")(window.state()));
    CHECK(named("H", "H")(window.state()));
    window.start();
    window.takePicture("french-keyboard");
    const double before = cameraValue(window.settle(), "elevation");
    window.holdKey("z", "the key above S to turn the camera",
                   [&](const json& t) { return cameraValue(t, "elevation") > before + 0.05; });
    window.key("F1");
    window.waitFor("help", [](const json& t) { return t.at("panels").at("help") == true; });
    window.takePicture("french-keyboard-help");
    window.key("F1");

    layout({"us", "-variant", "dvorak"});
    window.key("F2"); // the program reads the layout again with a key
    window.waitFor("names of a Dvorak keyboard", named("W", ","));
    CHECK(named("H", "D")(window.state()));
    layout({"ru"});
    window.key("F2");
    window.waitFor("names of a Russian keyboard", named("W", "\u0426"));
    window.takePicture("russian-keyboard");
}

TEST_CASE("a letter with Ctrl, Alt or the system's key is not that letter") {
    TrainerWindow window("modifiers", {});
    window.start();
    for (const char* modifier : {"ctrl", "alt", "super"}) {
        INFO(modifier);
        window.key(std::string(modifier) + "+v");
        window.key(std::string(modifier) + "+h");
        const json s = window.settle();
        CHECK(s.at("mode") == "interact");
        CHECK(s.at("page") == "running");
    }
    window.key("v");
    window.waitFor("view mode", [](const json& s) { return s.at("mode") == "view"; });
    window.key("h");
    window.waitFor("the list", [](const json& s) { return s.at("page") == "home"; });
}

} // namespace meltpool::test
