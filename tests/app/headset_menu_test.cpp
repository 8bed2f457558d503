// The pages of the headset's panel: order and width of the buttons, and tooltips that leave the next rows free.
#include "app/headset/headset_menu.hpp"
#include "app/headset/headset_parameters.hpp"
#include "tests/app/seam_hand.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

/// A panel of this shape with its menu.
struct ShownPanel {
    explicit ShownPanel(const xr::PanelShape& shape) : panel(GL_RGBA8, shape) {}
    Image picture() const {
        return gl::readPixels(panel.framebuffer(), panel.shape().widthPixels, panel.shape().heightPixels);
    }

    xr::Panel panel;
    HeadsetMenu menu;
};

/// A lesson on the headset's panel, and on one that is wide enough for everything.
class PanelPage {
  public:
    Controls controls;
    LessonSession session{test::shaders(), test::smallBead(), [] { return 0.0; }}; // makes the context of the panels
    ShownPanel usual{{}};

    /// Draws the page until its sizes are settled, with the pointer at a place of the panel or beside it. `elapsed`: s
    /// of each of four frames.
    std::map<std::string, ui::Place> draw(ShownPanel& shown, std::optional<glm::vec2> pointer = {},
                                          double elapsed = 1.0 / 60) {
        for (int frame = 0; frame < 4; ++frame)
            drawOnce(shown, {pointer}, elapsed);
        return shown.menu.places();
    }
    /// Turns the stick by so many lines, up is positive.
    void scroll(ShownPanel& shown, float lines) { drawOnce(shown, {glm::vec2(450, 550), false, lines}, 1.0 / 60); }
    /// Checks that the page's buttons are as wide on the headset's panel as on the wide one, and inside it.
    void checkButtons() {
        const auto narrow = draw(usual), roomy = draw(wide_);
        const auto width = static_cast<float>(usual.panel.shape().widthPixels);
        int checked = 0;
        for (const auto& [name, place] : narrow) {
            const bool isButton =
                name.starts_with("headset.") || name.starts_with("demonstration.") || name.starts_with("result.");
            // A wide panel has wider sliders and headings; buttons have the width of their words.
            if (!isButton || !roomy.contains(name) || roomy.at(name).width > width) continue;
            ++checked;
            INFO(name);
            CHECK(place.width >= roomy.at(name).width - 1);
            CHECK(place.x + place.width <= width);
        }
        CHECK(checked >= 3);
    }

    /// Shows the list of lessons, or the lesson again.
    void goHome(bool home) { home_.open = home; }
    /// Welds the seam, and waits for the judgement.
    void weld() {
        session.begin(controls);
        hand_.lead(session, controls, 2, 1);
        hand_.lead(session, controls, 1.5, 0);
        REQUIRE(session.attempt().judged());
    }

  private:
    void drawOnce(ShownPanel& shown, const PointerOnPanel& pointer, double elapsed) {
        shown.menu.draw(shown.panel, pointer, elapsed, session,
                        {home_, section_, {}, {}, false, figures_, false, false, nullptr});
    }

    ShownPanel wide_{{3000, 1100, 2}};
    HeadsetParameters parameters_;
    ParameterSection section_{"headset", describe(parameters_)};
    Home home_{test::shippedLessons(), test::scratchFolder("headset-menu") / "best-scores.toml"};
    LessonFigures figures_;
    test::SeamHand hand_;
};

/// Returns the number of pixels that differ clearly in these rows of two pictures.
int differing(const Image& a, const Image& b, int fromRow, int toRow) {
    int count = 0;
    for (int y = std::max(fromRow, 0); y < std::min(toRow, a.height); ++y)
        for (int x = 0; x < a.width; ++x) {
            const size_t at = 3 * (static_cast<size_t>(y) * size_t(a.width) + size_t(x));
            count += std::abs(int(a.rgb[at]) - int(b.rgb[at])) > 16 ? 1 : 0;
        }
    return count;
}

} // namespace

TEST_CASE("a result's score is above its buttons, there is one Home, and no button is cut off", "[app]") {
    PanelPage page;
    page.weld();
    const auto places = page.draw(page.usual);
    REQUIRE(places.contains("result.score"));
    for (const char* button : {"headset.restart", "headset.home", "result.again", "result.judge"}) {
        INFO(button);
        REQUIRE(places.contains(button));
        CHECK(places.at("result.score").y + places.at("result.score").height <= places.at(button).y);
    }
    CHECK(std::count_if(places.begin(), places.end(),
                        [](const auto& place) { return place.first.ends_with(".home"); }) == 1);
    CHECK_FALSE(places.contains("headset.reset")); // the result has its own
    page.checkButtons();
}

TEST_CASE("a result is shown from its top, wherever the page before it was scrolled to", "[app]") {
    PanelPage page;
    page.session.begin(page.controls);
    page.draw(page.usual);
    page.scroll(page.usual, -20);
    const auto before = page.draw(page.usual);
    CHECK_FALSE(before.contains("headset.restart")); // scrolled out of sight
    page.weld();
    const auto result = page.draw(page.usual);
    CHECK(result.contains("headset.restart"));
}

TEST_CASE("the page of the machine has gas and a maker's chart, before the lesson and in it", "[app]") {
    PanelPage page;
    ShownPanel tall{{900, 4000, 2}}; // high enough for all of the page
    for (const bool running : {false, true}) {
        if (running) page.session.begin(page.controls);
        const auto places = page.draw(tall);
        INFO("running " << running);
        REQUIRE(places.contains("simulation.gas.ar_co2"));
        REQUIRE(places.contains("simulation.chart_take"));
        CHECK(places.at("simulation.gas.ar_co2").y < places.at("simulation.chart_take").y);
        const ui::Place take = places.at("simulation.chart_take");
        CHECK(take.x + take.width <= 900);
    }
}

TEST_CASE("no button of a lesson's page and a demonstration is cut off", "[app]") {
    PanelPage page;
    page.checkButtons();
    page.session.demonstrate(page.controls);
    CHECK(page.draw(page.usual).contains("demonstration.weld"));
    page.checkButtons();
}

TEST_CASE("a tooltip comes once the pointer rests, at the panel's far edge, and leaves the rows around its button free",
          "[app]") {
    PanelPage page;
    page.session.demonstrate(page.controls);
    const ui::Place button = page.draw(page.usual).at("demonstration.weld");
    const Image without = page.usual.picture();
    const glm::vec2 middle(button.x + button.width / 2, button.y + button.height / 2);
    page.draw(page.usual, middle);
    const Image passing = page.usual.picture();
    page.draw(page.usual, middle, 0.2);
    const Image with = page.usual.picture();
    const int top = static_cast<int>(button.y), bottom = static_cast<int>(button.y + button.height) + 2;
    constexpr int kRows = 160; // of pixels: three rows of buttons
    CHECK(differing(without, with, bottom, bottom + kRows) == 0);
    CHECK(differing(without, with, top - kRows, top - 2) == 0);
    CHECK(differing(without, passing, bottom + kRows, without.height) == 0);
    CHECK(differing(without, with, bottom + kRows, without.height) > 2000);
}

TEST_CASE("the first page says above its lessons how they are pressed; after a lesson it no longer does", "[app]") {
    PanelPage page;
    page.goHome(true);
    const auto first = page.draw(page.usual);
    page.goHome(false);
    page.draw(page.usual);
    page.goHome(true);
    const auto later = page.draw(page.usual);
    const auto topTile = [](const std::map<std::string, ui::Place>& places) {
        float top = 1e9f;
        for (const auto& [name, place] : places)
            if (name.starts_with("home.lesson.")) top = std::min(top, place.y);
        return top;
    };
    CHECK(topTile(first) > topTile(later) + 40); // two lines
    CHECK(topTile(first) < 250);                 // in sight without the stick
}
