// Tests whole lessons, from the list to the result and the next lesson, with the keyboard alone and with a gamepad
// alone.
#include "core/base/words.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/desktop/driven/scripted_gamepad.hpp"
#include "tests/support/catch.hpp"

#include <cmath>
#include <functional>
#include <string>

namespace meltpool::test {

using nlohmann::json;

namespace {

const char* const kQuickPicture = "[window]\nwidth = 960\nheight = 640\n[view]\nmode = \"points\"\nshow_sky = false\n";

double tipAlong(const json& state) {
    return state.at("torch").at("tip_mm").at(0);
}

bool onPage(const json& state, const char* page) {
    return state.at("page") == page;
}

std::string focusOf(const json& state) {
    return state.at("focus");
}

/// Repeats `step` until the control of that name is the chosen one.
void chooseControl(TrainerWindow& window, const std::string& name, const std::function<void()>& step) {
    for (int i = 0; i < 60; ++i) {
        if (focusOf(window.settle()) == name) return;
        step();
    }
    FAIL("keys do not reach " << name << "; the last one was " << focusOf(window.settle()));
}

/// Waits until the metal runs.
void waitForMetal(TrainerWindow& window) {
    window.waitFor("the metal to run", [](const json& s) {
        return onPage(s, "running") && s.at("metal").at("steps") > 0 && s.at("metal").at("particles") > 0;
    });
}

/// Waits for the result and checks that the weld is accepted.
json waitForAccepted(TrainerWindow& window) {
    const json judged = window.waitFor("the result", [](const json& s) {
        return !s.at("judgement").is_null() && s.at("panels").at("result") == true;
    });
    const json& judgement = judged.at("judgement");
    WARN(judgement.dump());
    CHECK(judgement.at("score").get<std::string>().starts_with("Score "));
    CHECK(judgement.at("verdict").get<std::string>().starts_with("Accepted"));
    return judged;
}

/// Travel speed between two rows, mm for a second of the metal's time.
double speedBetween(const json& from, const json& to) {
    return (tipAlong(to) - tipAlong(from)) /
           (to.at("metal").at("time").get<double>() - from.at("metal").at("time").get<double>());
}

/// Opens a lesson from the list and starts it, welds it past `end` (mm along the seam) with Space and Shift + right
/// arrow, and goes on to the next lesson. `speed`: mm/s, that which the lesson asks for.
void weldByKeys(const std::string& lesson, double end, double speed) {
    TrainerWindow window("keys-alone-" + lesson, {.settings = kQuickPicture, .lesson = ""});
    chooseControl(window, "home.lesson." + lesson, [&] { window.key("Right"); });
    window.key("Return");
    window.waitFor("the lesson's page", [](const json& s) { return onPage(s, "start"); });
    window.key("Return");
    waitForMetal(window);
    window.xdotool({"keydown", "space", "keydown", "Shift_L", "keydown", "Right"});
    const json begun = window.waitFor("a pool", [](const json& s) { return s.at("metal").at("molten") > 50; });
    const json over = window.waitFor("the end of the weld", [&](const json& s) { return tipAlong(s) > end; });
    window.xdotool({"keyup", "Right", "keyup", "Shift_L", "keyup", "space"});
    CHECK(speedBetween(begun, over) == Approx(speed).epsilon(0.03)); // of the metal's time, however slow it runs
    CHECK_THAT(waitForAccepted(window).at("judgement").at("note").get<std::string>(),
               containsText(phrase("judgement.score.all_held")));
    window.takePicture("keys-alone-" + lesson);
    window.key("Return");
    window.waitFor("the next lesson's page", [](const json& s) { return onPage(s, "start"); });
    window.closeWindow();
    CHECK(window.finish() == 0);
}

/// Does the same with a gamepad. `stick`: push of the left stick, right and towards the person.
void weldByGamepad(const std::string& lesson, double end, const std::string& stick) {
    ScriptedGamepad pad("gamepad-" + lesson);
    TrainerWindow window("gamepad-alone-" + lesson,
                         {.settings = kQuickPicture, .lesson = "", .environment = pad.environment()});
    chooseControl(window, "home.lesson." + lesson, [&] {
        pad.set(window, "right");
        pad.rest(window);
    });
    pad.press(window, "a", "the lesson's page", [](const json& s) { return onPage(s, "start"); });
    pad.press(window, "a", "the running lesson", [](const json& s) { return onPage(s, "running"); });
    waitForMetal(window);
    CHECK(window.state().at("by_gamepad") == true);
    pad.set(window, stick + " 0 0 -1 1");
    window.waitFor("the end of the weld", [&](const json& s) { return tipAlong(s) > end; });
    window.takePicture("gamepad-welding-" + lesson);
    pad.rest(window);
    waitForAccepted(window);
    pad.press(window, "a", "the next lesson's page", [](const json& s) { return onPage(s, "start"); });
    pad.press(window, "b", "the list", [](const json& s) { return onPage(s, "home"); });
    window.closeWindow();
    CHECK(window.finish() == 0);
}

} // namespace

TEST_CASE("a bead is welded from the list to an accepted result with the keyboard alone") {
    weldByKeys("gmaw-bead", 38, 8);
}

TEST_CASE("a bead is welded from the list to an accepted result with a gamepad alone") {
    weldByGamepad("gmaw-bead", 38, "0.603 0");
}

TEST_CASE("a fillet is welded from the list to an accepted result with the keyboard alone", "[long]") {
    weldByKeys("tee-fillet", 25, 7.5);
}

TEST_CASE("a fillet is welded from the list to an accepted result with a gamepad alone", "[long]") {
    weldByGamepad("tee-fillet", 25, "0.366 0.366");
}

} // namespace meltpool::test
