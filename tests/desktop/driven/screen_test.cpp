// Tests the window on small, large and dense screens: it fits, and every page is usable at each size of its text.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <string>

namespace meltpool::test {

using nlohmann::json;

namespace {

struct Screen {
    int width, height, dotsPerInch;
    const char* textSize;
};

std::string settingsFor(const Screen& screen) {
    return std::string("[start]\nparticles = 1000\ncells = 16\n[view]\nmode = \"points\"\nshow_sky = false\n"
                       "[window]\ninterface_size = ") +
           screen.textSize + "\n";
}

/// Requires that the control is whole inside the window, without scrolling.
void requireInSight(const json& state, const std::string& name) {
    INFO(name);
    REQUIRE(state.at("places").contains(name));
    const auto [x, y, width, height] = state.at("places").at(name).get<std::array<double, 4>>();
    const auto size = state.at("window").at("size").get<std::array<double, 2>>();
    CHECK(x >= 0);
    CHECK(y >= 0);
    CHECK(x + width <= size[0] + 0.5);
    CHECK(y + height <= size[1] + 0.5);
}

void usePages(TrainerWindow& window, const std::string& name) {
    json s = window.settle();
    for (const char* control : {"start.start", "start.defaults", "start.home"})
        requireInSight(s, control);
    window.click("start.group.Expert"); // scrolling reaches its content
    window.takePicture(name + "-start");
    window.click("start.home");
    s = window.waitFor("the list", [](const json& t) { return t.at("page") == "home"; });
    s = window.settle();
    requireInSight(s, "home.help");
    requireInSight(s, "home.settings");
    requireInSight(s, "home.attempts");
    window.takePicture(name + "-home");
    window.key("F1");
    window.waitFor("help", [](const json& t) { return t.at("panels").at("help") == true; });
    window.settle();
    window.takePicture(name + "-help");
    window.key("F1");
    window.waitFor("no help", [](const json& t) { return t.at("panels").at("help") == false; });
    window.key("F2");
    window.waitFor("settings", [](const json& t) { return t.at("panels").at("settings") == true; });
    s = window.settle();
    requireInSight(s, "settings.close");
    requireInSight(s, "window.interface_size");
    window.takePicture(name + "-settings");
    window.key("Escape");
    window.waitFor("no settings", [](const json& t) { return t.at("panels").at("settings") == false; });
    window.place("home.lesson.classic");
    window.key("Return"); // the message of the last picture may cover the lesson
    window.waitFor("the lesson's page", [](const json& t) { return t.at("page") == "start"; });
    window.start();
    s = window.settle();
    requireInSight(s, "bar.reset");
    requireInSight(s, "bar.help");
    window.key("F2");
    window.waitFor("the view menu", [](const json& t) { return t.at("panels").at("view") == true; });
    window.settle();
    window.takePicture(name + "-lesson");
}

} // namespace

TEST_CASE("every page can be used on small, large and dense screens at text sizes 1 and 2") {
    for (const Screen& screen : {Screen{800, 600, 96, "1"}, Screen{800, 600, 96, "2"}, Screen{1024, 600, 96, "1"},
                                 Screen{1024, 600, 96, "2"}, Screen{1920, 1080, 192, "1"}, Screen{1920, 1080, 192, "2"},
                                 Screen{3840, 2160, 288, "1"}, Screen{3840, 2160, 288, "2"}}) {
        const std::string name = "screen-" + std::to_string(screen.width) + "x" + std::to_string(screen.height) + "-" +
                                 std::to_string(screen.dotsPerInch) + "-text" + screen.textSize;
        INFO(name);
        VirtualDisplay display(screen.dotsPerInch, screen.width, screen.height);
        TrainerWindow window(name, {.settings = settingsFor(screen), .display = &display});
        const auto size = window.state().at("window").at("size").get<std::array<int, 2>>();
        const int scale = screen.dotsPerInch / 96;
        CHECK(size[0] == std::min(1280 * scale, screen.width));
        CHECK(size[1] == std::min(720 * scale, screen.height));
        usePages(window, name);
    }
}

TEST_CASE("a size that a small screen could not give is kept for the next start, one that the person chose too") {
    const auto sizeIn = [](const TrainerWindow& window, const char* key) {
        const std::string text = readTextFile(window.settingsFile());
        const size_t at = text.find(std::string("\n") + key + " = ");
        REQUIRE(at != std::string::npos);
        return std::stoi(text.substr(text.find('=', at) + 1));
    };
    const std::string settings = "[start]\nparticles = 1000\ncells = 16\n[window]\nwidth = 1500\nheight = 900\n";
    VirtualDisplay dense(192, 1200, 1000);
    TrainerWindow window("kept-size", {.settings = settings, .display = &dense});
    CHECK(window.state().at("window").at("size") == json({1200, 1000}));
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);
    CHECK(sizeIn(window, "width") == 1500);
    CHECK(sizeIn(window, "height") == 900);

    TrainerWindow other("kept-size-chosen", {.settings = settings, .display = &dense});
    other.xdotool({"search", "--name", "^Meltpool$", "windowsize", "1400", "980"});
    other.waitFor("the new size", [](const json& s) { return s.at("window").at("size") == json({1400, 980}); });
    other.process().signal(SIGTERM);
    CHECK(other.finish() == 0);
    CHECK(sizeIn(other, "width") == 700); // equal to 700 points at an ordinary density
    CHECK(sizeIn(other, "height") == 490);
}

} // namespace meltpool::test
