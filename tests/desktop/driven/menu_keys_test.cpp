// Tests the menus of a running lesson with keys and with a gamepad alone, the torch at rest meanwhile, and the space
// bar that starts and stops the heat.
#include "tests/desktop/driven/driver.hpp"
#include "tests/desktop/driven/scripted_gamepad.hpp"
#include "tests/support/catch.hpp"

#include <array>
#include <functional>
#include <string>

namespace meltpool::test {

using nlohmann::json;

namespace {

std::function<bool(const json&)> focusAt(const std::string& name) {
    return [name](const json& s) { return s.at("focus") == name; };
}

bool sourceBurns(const json& state) {
    return state.at("source").at("on") == true;
}

/// Repeats `step` until the control of that name is the chosen one.
void stepTo(TrainerWindow& window, const std::string& name, const std::function<void()>& step) {
    for (int i = 0; i < 40; ++i) {
        if (focusAt(name)(window.settle())) return;
        step();
    }
    FAIL("keys do not reach " << name << "; the last one was " << window.settle().at("focus"));
}

void startByKey(TrainerWindow& window) {
    window.key("Return");
    window.waitFor("the metal to run", [](const json& s) { return s.at("metal").at("steps") > 0; });
}

} // namespace

TEST_CASE(
    "Tab leads into the menus of a running lesson; keys change its values while the source stays; Escape leads out") {
    TrainerWindow window("menu-keys", {});
    startByKey(window);
    const json before = window.settle();
    CHECK(before.at("focus") == "");
    window.key("Tab");
    window.waitFor("the bar's first button", focusAt("bar.view"));
    window.takePicture("menu-keys-bar");
    window.key("Return");
    window.waitFor("the view menu", [](const json& s) { return s.at("panels").at("view") == true; });
    stepTo(window, "view.point_size", [&] { window.key("Down"); });
    const std::string size = parameterIn(window.settle(), "view", "point_size");
    window.key("Right");
    window.waitFor("larger points", [&](const json& s) { return parameterIn(s, "view", "point_size") != size; });
    window.key("Down"); // the sign that gives the value back is no stop
    CHECK(window.settle().at("focus") != "view.point_size.back");
    stepTo(window, "view.point_size", [&] { window.key("Up"); });
    window.key("BackSpace");
    window.waitFor("the first value", [&](const json& s) { return parameterIn(s, "view", "point_size") == size; });
    stepTo(window, "view.show_box", [&] { window.key("Down"); });
    const std::string box = parameterIn(window.settle(), "view", "show_box");
    window.key("space");
    window.waitFor("the switch", [&](const json& s) { return parameterIn(s, "view", "show_box") != box; });
    window.takePicture("menu-keys-view");
    window.key("Tab");
    window.waitFor("the machine menu",
                   [](const json& s) { return s.at("focus").get<std::string>().starts_with("simulation."); });
    window.key("Tab");
    window.waitFor("the bar again", focusAt("bar.view"));
    const json after = window.settle();
    CHECK(after.at("source") == before.at("source"));
    CHECK(after.at("camera") == before.at("camera"));
    CHECK(after.at("mode") == "interact");
    window.key("Escape");
    window.waitFor("no chosen control", focusAt(""));
    window.key("Next");
    window.waitFor("the source to move", [&](const json& s) { return s.at("source") != before.at("source"); });
    // The help opens and closes by keys, too.
    window.key("Tab");
    stepTo(window, "bar.help", [&] { window.key("Right"); });
    window.key("Return");
    window.waitFor("help", [](const json& s) { return s.at("panels").at("help") == true; });
    window.key("Escape");
    window.waitFor("no help", [](const json& s) { return s.at("panels").at("help") == false; });
}

TEST_CASE("keys that go up a lesson's page bring its first values into sight") {
    TrainerWindow window("keys-up", {.settings = "[window]\nwidth = 800\nheight = 600\n", .lesson = "tee-3f"});
    stepTo(window, "start.start", [&] { window.key("Tab"); });
    for (int i = 0; i < 40 && !focusAt("start.for_score")(window.settle()); ++i)
        window.key("Up");
    const json at = window.waitFor("the switch in sight", [](const json& s) {
        return s.at("focus") == "start.for_score" && s.at("places").contains("start.for_score");
    });
    window.takePicture("keys-up");
    const auto area = at.at("places").at("start.values").get<std::array<double, 4>>();
    const auto item = window.settle().at("places").at("start.for_score").get<std::array<double, 4>>();
    CHECK(item[1] >= area[1] - 1);
    CHECK(item[1] + item[3] <= area[1] + area[3] + 1);
}

TEST_CASE("a gamepad works source, pause, menus and list of lessons; help and bar name its buttons") {
    ScriptedGamepad pad("gamepad-menus");
    TrainerWindow window("gamepad-menus-window", {.environment = pad.environment()});
    pad.press(window, "a", "the running lesson", [](const json& s) { return s.at("page") == "running"; });
    window.waitFor("the metal to run", [](const json& s) { return s.at("metal").at("steps") > 0; });
    const json before = window.settle();
    pad.set(window, "-1 0 0 0 -1 1");
    window.waitFor("heat", sourceBurns);
    window.waitFor("the source to move",
                   [&](const json& s) { return s.at("source").at("position") != before.at("source").at("position"); });
    pad.rest(window);
    window.waitFor("no heat", [](const json& s) { return !sourceBurns(s); });
    pad.press(window, "menu", "the pause", [](const json& s) { return s.at("mode") == "view"; });
    pad.press(window, "menu", "the work", [](const json& s) { return s.at("mode") == "interact"; });
    const double azimuth = window.settle().at("camera").at("azimuth");
    pad.press(window, "right", "the camera to turn",
              [&](const json& s) { return s.at("camera").at("azimuth").get<double>() > azimuth + 0.02; });
    pad.press(window, "y", "the menus", focusAt("bar.view"));
    const json still = window.settle();
    pad.set(window, "1 0 0 0 -1 1"); // neither moves nor heats meanwhile
    CHECK(window.settle().at("source") == still.at("source"));
    pad.rest(window);
    stepTo(window, "bar.help", [&] {
        pad.set(window, "right");
        pad.rest(window);
    });
    pad.press(window, "a", "help", [](const json& s) { return s.at("panels").at("help") == true; });
    window.takePicture("gamepad-help");
    pad.press(window, "b", "no help", [](const json& s) { return s.at("panels").at("help") == false; });
    pad.press(window, "b", "the torch again", focusAt(""));
    window.takePicture("gamepad-bar");
    pad.press(window, "view", "the list", [](const json& s) { return s.at("page") == "home"; });
    window.takePicture("gamepad-home");
}

TEST_CASE("the space bar starts and stops the heat where that is set, and the menus stop it") {
    TrainerWindow window("space-latch", {.settings = std::string(kSmallSettings) + "[controls]\nspace_latch = true\n"});
    startByKey(window);
    window.settle();
    window.key("space");
    window.waitFor("heat", sourceBurns);
    CHECK(sourceBurns(window.settle())); // the key is released
    window.key("space");
    window.waitFor("no heat", [](const json& s) { return !sourceBurns(s); });
    window.key("space");
    window.waitFor("heat again", sourceBurns);
    window.key("Tab");
    window.waitFor("no heat while keys choose", [](const json& s) { return !sourceBurns(s); });
    window.key("Escape");
    window.settle();
    CHECK_FALSE(sourceBurns(window.settle()));
}

} // namespace meltpool::test
