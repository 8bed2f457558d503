// Takes a picture of every page of the window at a large text, on a small and on a dense screen, into the build
// folder's desktop-pictures. Not among the ordinary tests: look at the pictures.
//   build/release/bin/test_desktop "[pages]"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"

#include <string>

namespace meltpool::test {

using nlohmann::json;

namespace {

std::string settings() {
    return "[view]\nmode = \"points\"\nshow_sky = false\n[window]\ninterface_size = 2\n";
}

bool onPage(const json& state, const char* page) {
    return state.at("page") == page;
}

/// The window and the prefix of its pictures' names.
class Pages {
  public:
    Pages(const std::string& name, VirtualDisplay& display)
        : name_(name), window_("pages-" + name, {.settings = settings(), .lesson = "", .display = &display}) {}

    void take(const std::string& page) {
        window_.settle();
        window_.takePicture("pages-" + name_ + "-" + page);
    }
    void open(const char* key, const std::string& panel, const std::string& page) {
        window_.key(key);
        window_.waitFor(panel, [&](const json& s) { return s.at("panels").at(panel) == true; });
        take(page);
        window_.key("Escape");
        window_.waitFor("no " + panel, [&](const json& s) { return s.at("panels").at(panel) == false; });
    }
    /// Welds by keys for some seconds of the metal's time, and has the weld judged.
    void weld(double seconds, const std::string& page) {
        window_.xdotool({"keydown", "space", "keydown", "Shift_L", "keydown", "Right"});
        const double begin = window_.settle().at("metal").at("time");
        const auto after = [begin](double s) {
            return [until = begin + s](const json& row) { return row.at("metal").at("time").get<double>() > until; };
        };
        window_.waitFor("half a weld", after(0.6 * seconds));
        if (!page.empty()) take(page);
        window_.waitFor("a weld", after(seconds));
        window_.xdotool({"keyup", "Right", "keyup", "Shift_L", "keyup", "space"});
        window_.key("j");
        window_.waitFor("the result", [](const json& s) {
            return !s.at("judgement").is_null() && s.at("panels").at("result") == true;
        });
    }
    TrainerWindow& window() { return window_; }

  private:
    std::string name_;
    TrainerWindow window_;
};

void takeBeforeLesson(Pages& pages) {
    TrainerWindow& window = pages.window();
    window.waitFor("the list", [](const json& s) { return onPage(s, "home"); });
    pages.take("home");
    pages.open("F1", "help", "home-help");
    pages.open("F2", "settings", "settings");
    window.key("n");
    pages.take("who-welds");
    window.click("persons.back");
    window.place("home.lesson.gmaw-bead");
    window.key("Return"); // the message of the last picture may cover the lesson
    window.waitFor("the lesson's page", [](const json& s) { return onPage(s, "start"); });
    pages.take("page");
}

void takeLesson(Pages& pages) {
    TrainerWindow& window = pages.window();
    window.key("Return");
    window.waitFor("the metal", [](const json& s) { return s.at("metal").at("steps") > 0; });
    pages.take("lesson");
    pages.open("F1", "help", "lesson-help");
    if (window.settle().at("panels").at("simulation") != true) window.key("F3");
    pages.take("machine");
    window.key("F3");
    window.key("F2");
    pages.take("view");
    window.key("F2");
    pages.weld(3, "weld");
    pages.take("result");
    window.key("x");
    pages.take("cut");
    CHECK_FALSE(window.settle().at("places").contains("result.again")); // it would hide the cut
    window.key("x");
    window.key("F5");
    window.waitFor("fresh metal", [](const json& s) { return s.at("metal").at("time") < 0.5; });
    pages.weld(2, "");
}

void takeAttempts(Pages& pages) {
    TrainerWindow& window = pages.window();
    window.key("h");
    window.waitFor("the list", [](const json& s) { return onPage(s, "home"); });
    window.settle();
    window.click("home.attempts");
    pages.take("attempts");
    window.waitFor("no message over the rows", [](const json& s) { return s.at("messages").empty(); });
    window.click("home.attempt.0");
    pages.take("attempt");
    window.waitFor("no message over the rows", [](const json& s) { return s.at("messages").empty(); });
    window.click("home.attempts.compare");
    window.click("home.attempt.1");
    window.click("home.attempts.compare");
    window.waitFor("the comparison", [](const json& s) { return s.at("places").contains("comparison.words"); });
    pages.take("comparison");
    window.waitFor("no message over the button", [](const json& s) { return s.at("messages").empty(); });
    window.click("comparison.back");
    window.click("home.attempt.1");
    window.click("home.attempts.play");
    window.waitFor("the attempt's end",
                   [](const json& s) { return !s.at("replay").is_null() && s.at("replay").at("over") == true; });
    pages.take("replay");
}

void takeAll(const std::string& name, VirtualDisplay& display) {
    Pages pages(name, display);
    takeBeforeLesson(pages);
    takeLesson(pages);
    takeAttempts(pages);
}

} // namespace

TEST_CASE("pictures of every page at text size 2 in a small window", "[long][pages]") {
    VirtualDisplay display(96, 800, 600);
    takeAll("800x600", display);
}

TEST_CASE("pictures of every page at text size 2 on a dense screen", "[long][pages]") {
    VirtualDisplay display(288, 3840, 2160);
    takeAll("3840x2160", display);
}

} // namespace meltpool::test
