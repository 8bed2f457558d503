// Takes the handbook's pictures of the window again, into the folder $MELTPOOL_HANDBOOK_PICTURES. Not among the
// ordinary tests: look at the pictures before you copy them to app/handbook.
//   MELTPOOL_HANDBOOK_PICTURES=FOLDER build/release/bin/test_desktop "[pictures]"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <cstdlib>

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string settingsWith(const std::string& more) {
    return "[window]\nwidth = 1280\nheight = 720\npicture = \"full\"\n" + more;
}

/// Scales the window's picture to the handbook's width.
void keep(TrainerWindow& window, const std::string& name) {
    const char* folder = std::getenv("MELTPOOL_HANDBOOK_PICTURES");
    REQUIRE(folder != nullptr);
    fs::create_directories(folder);
    if (window.settle().at("captured") == false) window.moveMouse(640, 715); // no tooltip in the picture
    window.settle();
    const fs::path taken = window.takePicture("handbook-" + name);
    INFO("scaling needs the package imagemagick");
    REQUIRE(runCommand({"convert", taken.string(), "-resize", "960x540", (fs::path(folder) / (name + ".png")).string()},
                       {}) == 0);
}

void waitForPage(TrainerWindow& window, const std::string& page) {
    window.waitFor("the page " + page, [&page](const json& s) { return s.at("page") == page; });
}

auto metalAfter(double seconds) {
    return [seconds](const json& s) { return s.at("metal").at("time").get<double>() > seconds; };
}

/// Leads the torch along a seam in x with the captured mouse, at an even speed of the metal's time.
class EvenHand {
  public:
    EvenHand(TrainerWindow& window, double mmPerSecond) : window_(window), speed_(mmPerSecond) {
        window_.key("c");
        window_.waitFor("a captured mouse", [](const json& s) { return s.at("captured") == true; });
        const glm::dvec2 right = movedBy({kTrialPixels, 0}), down = movedBy({0, kTrialPixels});
        pixelsPerMm_ = glm::inverse(glm::dmat2(right, down) / double(kTrialPixels));
        movedBy({-kTrialPixels, -kTrialPixels});
        window_.xdotool({"mousedown", "1"});
        const json now = window_.waitFor("the arc", [](const json& s) { return s.at("torch").at("trigger") > 0.5; });
        from_ = placeOf(now).x;
        begin_ = now.at("metal").at("time");
    }

    /// Welds until the metal's time is `seconds` after the first pull.
    void weld(double seconds) {
        for (json now = window_.settle(); timeOf(now) < seconds; now = window_.settle()) {
            // Across the seam the hand rests: the torch itself rises with the pool, there too.
            const double off = from_ + speed_ * timeOf(now) - placeOf(now).x;
            move(glm::ivec2(glm::round(pixelsPerMm_ * glm::dvec2(glm::clamp(off, -2.0, 2.0), 0))));
        }
    }

    /// Lets go of the trigger and frees the mouse.
    void end() {
        window_.xdotool({"mouseup", "1"});
        window_.key("Escape");
        window_.waitFor("a free mouse", [](const json& s) { return s.at("captured") == false; });
    }

  private:
    static constexpr int kTrialPixels = 20;

    /// Place along and across the seam, mm.
    static glm::dvec2 placeOf(const json& row) {
        const json tip = row.at("torch").at("tip_mm");
        return {tip.at(0).get<double>(), tip.at(2).get<double>()};
    }
    double timeOf(const json& row) const { return row.at("metal").at("time").get<double>() - begin_; }

    void move(const glm::ivec2& pixels) {
        if (pixels == glm::ivec2(0)) return;
        window_.xdotool({"mousemove_relative", "--", std::to_string(pixels.x), std::to_string(pixels.y)});
    }

    /// Moves the mouse and returns the way of the torch, mm, once it rests: it follows as a hand does.
    glm::dvec2 movedBy(const glm::ivec2& pixels) {
        const glm::dvec2 before = placeOf(window_.settle());
        move(pixels);
        glm::dvec2 last = before, now = placeOf(window_.settle());
        for (int row = 0; row < 100 && (now == before || glm::distance(now, last) > 0.01); ++row) {
            last = now;
            now = placeOf(window_.settle());
        }
        return now - before;
    }

    TrainerWindow& window_;
    double speed_, begin_ = 0, from_ = 0;
    glm::dmat2 pixelsPerMm_{1};
};

} // namespace

TEST_CASE("pictures of home, a lesson's page, a demonstration and the view menu", "[by_hand][pictures]") {
    VirtualDisplay display(96, 1280, 720);
    TrainerWindow window("handbook-home", {.settings = settingsWith(""), .lesson = "", .display = &display});
    waitForPage(window, "home");
    keep(window, "home");
    window.click("home.lesson.gmaw-bead");
    waitForPage(window, "start");
    window.settle();
    keep(window, "lesson-page");
    window.click("start.demonstration");
    window.waitFor("a bead", metalAfter(4));
    window.key("space");
    keep(window, "demonstration");
    window.key("h");
    waitForPage(window, "home");
    window.click("home.lesson.classic");
    waitForPage(window, "start");
    window.start();
    window.key("c");
    window.waitFor("a captured mouse", [](const json& t) { return t.at("captured") == true; });
    for (const char* way : {"Next", "Up"}) // from its first place into the cube's corner
        for (int i = 0; i < 9; ++i)
            window.key(way);
    window.xdotool({"mousedown", "1"});
    window.waitFor("molten metal", [](const json& s) { return s.at("metal").at("molten") > 200; });
    window.xdotool({"mouseup", "1"});
    window.key("Escape");
    window.waitFor("a free mouse", [](const json& t) { return t.at("captured") == false; });
    window.key("F3");
    window.click("bar.view");
    window.click("view.material.gold");
    keep(window, "view-menu");
}

TEST_CASE("pictures of a weld: machine, cues, ghost, result, cut, replay and comparison", "[by_hand][pictures]") {
    VirtualDisplay display(96, 1280, 720);
    TrainerWindow window("handbook-weld", {.settings = settingsWith(""), .lesson = "tee-fillet", .display = &display});
    window.start();
    {
        EvenHand hand(window, 6.5);
        hand.weld(3);
        keep(window, "machine-menu");
        window.key("F3");
        hand.weld(5);
        keep(window, "cues");
        hand.weld(9);
        hand.end();
    }
    window.waitFor("the result", [](const json& s) { return s.at("places").contains("result.again"); });
    keep(window, "result");
    window.key("x");
    window.settle();
    keep(window, "cut");
    window.key("x");
    window.key("F5");
    window.settle();
    window.click("bar.view");
    window.click("ghost.group.Ghost torch");
    window.click("ghost.ghost.expert");
    window.click("ghost.ghost_pace.time");
    window.key("F2");
    {
        EvenHand hand(window, 9);
        hand.weld(3);
        keep(window, "ghost");
        hand.weld(5);
        hand.end();
    }
    window.waitFor("the result", [](const json& s) { return s.at("places").contains("result.again"); });
    window.key("h");
    waitForPage(window, "home");
    window.click("home.attempts");
    window.click("home.attempt.0");
    window.click("home.attempts.compare");
    window.click("home.attempt.1");
    window.click("home.attempts.compare");
    window.waitFor("the comparison", [](const json& s) { return s.at("places").contains("comparison.words"); });
    keep(window, "comparison");
    window.click("comparison.back");
    window.click("home.attempt.1");
    window.click("home.attempts.play");
    window.waitFor("the attempt's end",
                   [](const json& s) { return !s.at("replay").is_null() && s.at("replay").at("over") == true; });
    window.pull("replay.time", 0.6);
    window.waitFor("that moment", [](const json& s) { return s.at("replay").at("seeking") == false; });
    keep(window, "replay");
}

} // namespace meltpool::test
