// Tests the list of saved attempts and the panel of two of them, drawn without a window.
#include "app/ui/panels.hpp"
#include "core/base/resources.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

namespace {

/// Shows the home page with these attempts in its list.
class Listed {
  public:
    Listed(const std::string& name, std::vector<ReplayEntry> entries)
        : home(resourceFolder() / "data" / "lessons", test::scratchFolder(name) / "best-scores.toml") {
        home.attempts.show(std::move(entries));
    }

    Home home;
};

} // namespace

TEST_CASE("each attempt of the list can be played, be the ghost, and be compared with another of its lesson") {
    Listed listed("attempts-list", {{"new", "gmaw-bead", "today"}, {"old", "gmaw-bead", "before"}});
    Home& home = listed.home;
    Activities activities;
    test::DrawnInterface interface;
    MenuRequest request = MenuRequest::none;
    const auto content = [&](ui::Context& context) {
        if (const MenuRequest asked = ui::attemptList(context, home, activities, 8); asked != MenuRequest::none)
            request = asked;
    };
    const auto click = [&](const char* name) {
        request = MenuRequest::none;
        interface.click(name, content);
        return request;
    };
    interface.draw(content);
    CHECK(click("home.attempt.1.play") == MenuRequest::replay);
    CHECK(home.attempts.chosen() == "old");
    CHECK(click("home.attempt.0.ghost") == MenuRequest::ghost);
    CHECK(home.attempts.chosen() == "new");
    CHECK(click("home.attempt.0.compare") == MenuRequest::none);
    CHECK(home.attempts.marked(0));
    interface.draw(content); // the panel shows the next step in an additional line
    CHECK(click("home.attempt.1.compare") == MenuRequest::compare);
    CHECK(home.attempts.pair()[0].file == "old");
}

TEST_CASE("a long list of attempts has pages") {
    std::vector<ReplayEntry> entries;
    for (int i = 0; i < 5; ++i)
        entries.push_back({std::to_string(i), "knitting", "once"}); // a lesson that no longer exists has no title
    Listed listed("attempts-pages", std::move(entries));
    Home& home = listed.home;
    Activities activities;
    test::DrawnInterface interface;
    const auto content = [&](ui::Context& context) { ui::attemptList(context, home, activities, 2); };
    interface.draw(content);
    CHECK(interface.shows("home.attempt.1.play"));
    CHECK_FALSE(interface.shows("home.attempt.2.play"));
    interface.click("home.attempts.older", content);
    interface.click("home.attempts.older", content);
    interface.click("home.attempts.older", content); // there are three pages
    CHECK(home.attempts.page == 2);
    CHECK(interface.shows("home.attempt.4.play"));
}

} // namespace meltpool
