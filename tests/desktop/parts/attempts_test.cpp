// Tests the list of saved attempts and the panel of two of them, drawn without a window.
#include "app/ui/panels.hpp"
#include "core/base/resources.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <functional>

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

/// The table of the window, drawn with attempts of two lessons.
class Table {
  public:
    Table(const std::string& name, size_t attempts, ImVec2 size) : listed_(name, entriesFor(attempts)) {
        interface.size = size;
        draw();
        draw(); // the parts' heights are known
    }

    void draw() { interface.draw(content()); }
    MenuRequest click(const std::string& name) {
        request_ = MenuRequest::none;
        draw(); // the lines below the table have their height
        draw();
        interface.click(name, content());
        return request_;
    }
    /// Number of rows in sight.
    size_t rows() const {
        size_t count = 0;
        while (interface.shows("home.attempt." + std::to_string(count)))
            ++count;
        return count;
    }
    ReplayList& list() { return listed_.home.attempts; }

    test::DrawnInterface interface;

  private:
    static std::vector<ReplayEntry> entriesFor(size_t count) {
        std::vector<ReplayEntry> entries;
        for (size_t i = 0; i < count; ++i) {
            ReplayEntry entry{std::to_string(i), i % 2 == 0 ? "gmaw-bead" : "knitting", "once"};
            entry.score = static_cast<int>(i);
            entry.test = i == 3;
            entries.push_back(std::move(entry));
        }
        return entries;
    }

    test::DrawnInterface::Content content() { return draw_; }

    Listed listed_;
    Activities activities_;
    MenuRequest request_ = MenuRequest::none;
    std::function<void(ui::Context&)> draw_ = [this](ui::Context& context) {
        if (const MenuRequest asked = ui::attemptTable(context, listed_.home, activities_); asked != MenuRequest::none)
            request_ = asked;
    };
};

} // namespace

TEST_CASE("the table has as many rows as fit, and more in a larger window") {
    size_t rows = 0;
    {
        const Table low("attempts-low", 60, {780, 420});
        rows = low.rows();
        CHECK(rows >= 10);
        for (const char* column : {"lesson", "title", "date", "score", "test"})
            CHECK(low.interface.shows(std::string("home.attempts.column.") + column));
    }
    {
        const Table high("attempts-high", 60, {780, 900});
        CHECK(high.rows() > 2 * rows);
    }
    const Table narrow("attempts-narrow", 3, {390, 420}); // text of twice the size in a window of 800 pixels
    CHECK(narrow.interface.shows("home.attempts.column.lesson"));
    CHECK(narrow.interface.shows("home.attempts.column.score"));
    CHECK_FALSE(narrow.interface.shows("home.attempts.column.title"));
    CHECK(narrow.interface.shows("home.attempt.0"));
}

TEST_CASE("headings sort, filters choose, and the buttons act on the chosen row") {
    Table table("attempts-table-acts", 6, {1000, 600});
    ReplayList& list = table.list();
    CHECK(table.rows() == 6);
    CHECK(list.selected() == 0);
    CHECK(table.click("home.attempts.column.score") == MenuRequest::none);
    CHECK(list.order() == AttemptOrder{AttemptColumn::score, false});
    CHECK(table.click("home.attempt.0") == MenuRequest::none);
    CHECK(list.selected() == 5);
    CHECK(table.click("home.attempts.play") == MenuRequest::replay);
    CHECK(list.chosen() == "5");
    table.click("home.attempts.column.score");
    table.click("home.attempt.1");
    CHECK(list.selected() == 1);
    CHECK(table.click("home.attempts.ghost") == MenuRequest::ghost);
    CHECK(list.chosen() == "1");
    CHECK(table.click("home.attempts.page") == MenuRequest::keptPage);
    CHECK(table.click("home.attempts.export") == MenuRequest::exportAttempts);
    CHECK(table.click("home.attempts.compare") == MenuRequest::none);
    CHECK(list.marked(1));
    const ui::Place before = table.interface.place("home.attempts.compare");
    table.draw();
    table.draw();
    CHECK(table.interface.shows("home.attempts.marked"));
    CHECK(table.interface.place("home.attempts.compare").y == before.y); // no button moves away from the pointer
    table.click("home.attempt.3");
    CHECK(table.click("home.attempts.compare") == MenuRequest::compare);
    CHECK(list.pair()[0].file == "3"); // the older one
    table.click("home.attempts.tests");
    table.draw();
    CHECK(list.filter().testsOnly);
    CHECK(table.rows() == 1);
    CHECK(list.selected() == 3);
    table.click("home.attempts.tests");
    table.click("home.attempts.lesson");
    table.draw();
    REQUIRE(table.interface.shows("home.attempts.lesson.knitting"));
    table.click("home.attempts.lesson.knitting");
    table.draw();
    CHECK(list.filter().lesson == "knitting");
    CHECK(table.rows() == 3);
}

TEST_CASE("a name is asked for in a line, a removal by a question, and both can be given up") {
    Table table("attempts-asks", 4, {1000, 600});
    ReplayList& list = table.list();
    table.click("home.attempts.name");
    table.draw();
    CHECK(list.asking == ReplayList::Asking::title);
    CHECK(table.interface.shows("home.attempts.title"));
    table.click("home.attempts.title.cancel");
    CHECK(list.asking == ReplayList::Asking::nothing);
    table.click("home.attempts.delete");
    table.draw();
    CHECK(list.asking == ReplayList::Asking::removal);
    CHECK(list.entries().size() == 4);
    table.click("home.attempts.delete.no");
    CHECK(list.asking == ReplayList::Asking::nothing);
    table.click("home.attempts.delete");
    table.draw();
    table.click("home.attempts.delete.yes"); // no such file: the attempt stays, and the list says why
    CHECK(list.entries().size() == 4);
    CHECK_FALSE(list.notice().empty());
    CHECK_FALSE(list.canBringBack());
}

TEST_CASE("the bright button of a result is the next lesson's after an accepted weld") {
    CHECK(ui::brightResultButton(false, false, true) == "result.judge");
    CHECK(ui::brightResultButton(true, false, true) == "result.again");
    CHECK(ui::brightResultButton(true, true, true) == "result.next");
    CHECK(ui::brightResultButton(true, true, false) == "result.again");
}

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
