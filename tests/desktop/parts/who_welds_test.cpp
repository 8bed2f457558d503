// Tests the home page's question for a name, drawn without a window.
#include "app/session/who_welds.hpp"

#include "app/ui/panels.hpp"
#include "core/base/resources.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <string>

namespace meltpool {

namespace {

void type(WhoWelds& who, const std::string& text) {
    who.typed.fill(0);
    std::copy(text.begin(), text.end(), who.typed.begin());
}

} // namespace

TEST_CASE("the question offers the person who was here last, and by turns the other one") {
    WhoWelds who(test::scratchFolder("who-offered") / "persons");
    who.ask();
    CHECK(who.asked());
    CHECK(std::string(who.typed.data()).empty());
    CHECK(who.takeTyped()); // nothing typed: the account
    CHECK(who.welder().kind == AttemptOwner::Kind::account);
    CHECK(who.name().empty());
    CHECK_FALSE(who.asked());
    REQUIRE(who.take("Anna"));
    REQUIRE(who.take("Bert"));
    CHECK(who.name() == "Bert");
    for (const char* next : {"Anna", "Bert", "Anna"}) {
        who.ask();
        CHECK(std::string(who.typed.data()) == next);
        CHECK(who.takeTyped());
        CHECK(who.welder().person.name == next);
    }
    who.ask();
    who.close();
    CHECK(who.name() == "Anna"); // welds on
    who.takeGuest();
    CHECK(who.name() == "Guest");
    CHECK(who.welder().person.id.empty());
    who.ask();
    CHECK(std::string(who.typed.data()) == "Anna");
}

TEST_CASE("a refused name leaves the question open with its sentence") {
    WhoWelds who(test::scratchFolder("who-refused") / "persons");
    who.ask();
    type(who, std::string(60, 'x'));
    CHECK_FALSE(who.takeTyped());
    CHECK(who.asked());
    CHECK(who.refusal().find("has 60 letters") != std::string::npos);
    type(who, "Anna");
    CHECK(who.takeTyped());
    CHECK(who.refusal().empty());
}

TEST_CASE("the home page asks who welds: a known name, a guest, no name, or back, by mouse at desk and headset") {
    test::context(); // the pictures of lessons are textures
    Home home(resourceFolder() / "data" / "lessons", test::scratchFolder("who-home") / "best-scores.toml",
              test::scratchFolder("who-home-persons") / "persons");
    REQUIRE(home.who.take("Anna"));
    REQUIRE(home.who.take("Bert"));
    test::DrawnInterface interface;
    Activities activities;
    MenuRequest request = MenuRequest::none;
    const auto desk = [&](ui::Context& context) {
        if (const MenuRequest asked = ui::personsPart(context, home.who, true); asked != MenuRequest::none)
            request = asked;
    };
    const auto panel = [&](ui::Context& context) {
        if (const MenuRequest asked = ui::homePart(context, home, activities); asked != MenuRequest::none)
            request = asked;
    };
    home.who.ask();
    interface.draw(desk);
    for (const char* name : {"persons.name", "persons.accept", "persons.known.0", "persons.known.1", "persons.guest",
                             "persons.account", "persons.back"}) {
        INFO(name);
        CHECK(interface.shows(name));
    }
    CHECK_FALSE(interface.shows("persons.refusal"));
    CHECK_FALSE(interface.shows("persons.more"));
    interface.click("persons.known.1", desk);
    CHECK(request == MenuRequest::welder);
    CHECK(home.who.name() == "Anna");

    const auto name = [&](ui::Context& context) { ui::personsButton(context, home.who, false); };
    interface.draw(name);
    interface.click("home.persons", name);
    CHECK(home.who.asked());
    interface.draw(panel);                        // the headset's panel
    CHECK_FALSE(interface.shows("persons.name")); // no keyboard there
    CHECK_FALSE(interface.shows("home.attempts"));
    request = MenuRequest::none;
    interface.click("persons.guest", panel);
    CHECK(request == MenuRequest::welder);
    CHECK(home.who.welder().kind == AttemptOwner::Kind::guest);

    home.who.ask();
    request = MenuRequest::none;
    interface.draw(desk);
    interface.click("persons.back", desk);
    CHECK(request == MenuRequest::none);
    CHECK_FALSE(home.who.asked());
    CHECK(home.who.welder().kind == AttemptOwner::Kind::guest);
}

TEST_CASE("a class of names has pages") {
    WhoWelds who(test::scratchFolder("who-class") / "persons");
    for (int i = 0; i < 15; ++i)
        REQUIRE(who.take("Pupil " + std::to_string(i)));
    who.ask();
    test::DrawnInterface interface;
    const auto content = [&](ui::Context& context) { ui::personsPart(context, who, false); };
    interface.draw(content);
    CHECK(interface.shows("persons.known.0"));
    CHECK_FALSE(interface.shows("persons.known.12"));
    interface.click("persons.more", content);
    interface.draw(content);
    CHECK(interface.shows("persons.known.14"));
    CHECK_FALSE(interface.shows("persons.known.0"));
}

} // namespace meltpool
