// The list of keys: every key of the window is named, once in each situation, and the bar follows the activity.
#include "app/ui/key_guide.hpp"

#include "app/desktop/desktop_actions.hpp"
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace meltpool::test {

namespace {

using ui::KeyGuide;
using ui::KeyRow;
using ui::KeySituation;

std::vector<KeySituation> situations() {
    const KeySituation weld{.lesson = true, .seam = true, .arc = true, .judges = true, .redoes = true};
    std::vector<KeySituation> all(9, weld);
    all[1].rod = all[1].fadedCues = true;
    all[2].caught = all[2].weaves = true;
    all[3].looking = true;
    all[4].headset = all[4].next = true;
    all[5] = {.lesson = true, .source = true, .cold = true};
    all[6] = {.lesson = true, .demonstration = true};
    all[7] = {.lesson = true, .replay = true};
    all[8] = {.lesson = true, .cut = true, .seam = true, .arc = true, .judges = true};
    all.push_back(weld);
    all.back().latch = true;
    all.push_back(weld);
    all.back().menus = true;
    all.push_back({.home = true});
    all.push_back({});
    return all;
}

bool has(const KeyGuide& guide, Key key, bool inBar = false) {
    return std::any_of(guide.rows().begin(), guide.rows().end(), [&](const KeyRow& row) {
        return std::find(row.used().begin(), row.used().end(), key) != row.used().end() &&
               (!inBar || !row.hint.empty());
    });
}

bool tells(const KeyGuide& guide, std::string_view what) {
    return std::any_of(guide.rows().begin(), guide.rows().end(), [&](const KeyRow& row) { return row.what == what; });
}

} // namespace

TEST_CASE("every key of the window is named in the help of some situation, and once in each") {
    DrawnInterface interface;
    std::set<Key> named;
    for (const KeySituation& now : situations()) {
        std::set<Key> here;
        const KeyGuide guide(now);
        for (const KeyRow& row : guide.rows()) {
            INFO(row.what);
            CHECK_FALSE(phrase(row.what).empty());
            if (!row.hint.empty()) CHECK_FALSE(phrase(row.hint).empty());
            interface.draw([&](ui::Context& context) { CHECK_FALSE(keyRowName(context, row).empty()); });
            for (const Key key : row.used()) {
                INFO("key " << static_cast<int>(key));
                CHECK(here.insert(key).second);
                named.insert(key);
            }
        }
    }
    CHECK(named.size() == static_cast<size_t>(Key::count));
    for (const DesktopAction& action : desktopActions())
        if (action.key) {
            INFO(action.name);
            CHECK(named.count(*action.key) == 1);
        }
}

TEST_CASE("the bar names what the activity uses and nothing else") {
    const std::vector<KeySituation> all = situations();
    const KeyGuide weld(all[0]), rod(all[1]), classic(all[5]), demonstration(all[6]), cut(all[8]);
    CHECK(has(rod, Key::r, true));
    CHECK_FALSE(has(weld, Key::r));
    CHECK(has(KeyGuide(all[2]), Key::g, true));
    CHECK_FALSE(has(weld, Key::g));
    CHECK(tells(weld, "help.weld_while_held"));
    CHECK_FALSE(tells(weld, "help.heat_while_held"));
    CHECK_FALSE(has(weld, Key::f)); // the flame's key
    CHECK(has(classic, Key::f));
    CHECK(tells(classic, "help.heat_while_held"));
    for (const KeyGuide& played : {demonstration, cut}) {
        CHECK_FALSE(tells(played, "help.heat_while_held"));
        CHECK_FALSE(tells(played, "help.weld_while_held"));
    }
    CHECK(has(demonstration, Key::space, true));
    CHECK(has(cut, Key::x, true));
    CHECK(has(weld, Key::backspace));
}

TEST_CASE("a narrow bar leaves out whole figures, the last ones first") {
    DrawnInterface interface;
    const KeySituation replay{.lesson = true, .replay = true};
    const auto drawn = [&](float width, std::string_view picture, const KeySituation& now) {
        ImGui::GetIO().DisplaySize.x = width;
        LessonFigures figures;
        figures.picture = picture;
        figures.particles = 24851;
        return interface.draw([&](ui::Context& context) { statusBar(context, figures, now); });
    };
    for (const float width : {560.0F, 700.0F, 760.0F}) {
        INFO(width << " points wide");
        const int cut = drawn(width, "a picture of few pixels", replay);
        CHECK(cut == drawn(width, {}, replay));
    }
    CHECK(drawn(3000, "a picture of few pixels", {.lesson = true, .cut = true}) ==
          drawn(3000, {}, {.lesson = true, .cut = true})); // the weld rests
    CHECK(drawn(3000, "a picture of few pixels", replay) > drawn(3000, {}, replay));
}

TEST_CASE("a bar too narrow for the torch's figures leaves out its angles and names a key") {
    DrawnInterface interface;
    const KeySituation weld{.lesson = true, .seam = true, .arc = true};
    const auto drawn = [&](float width, double travel, double distance) {
        ImGui::GetIO().DisplaySize.x = width;
        LessonFigures figures;
        figures.torch.emplace();
        figures.torch->travel = travel;
        figures.torch->distance = distance;
        return interface.draw([&](ui::Context& context) { statusBar(context, figures, weld); });
    };
    constexpr double kPush = 0.1, kSteepPush = 0.3; // of one digit and of two
    CHECK(drawn(3000, kPush, 0.015) < drawn(3000, kSteepPush, 0.015));
    CHECK(drawn(400, kPush, 0.015) == drawn(400, kSteepPush, 0.015));
    CHECK(drawn(400, kPush, 0.005) < drawn(400, kPush, 0.015));
}

TEST_CASE("while a gamepad is in use the list names its parts, each with one effect") {
    const KeySituation weld{.lesson = true,
                            .seam = true,
                            .arc = true,
                            .rod = true,
                            .weaves = true,
                            .judges = true,
                            .next = true,
                            .redoes = true};
    std::vector<KeySituation> all(5, weld);
    all[1] = {.lesson = true, .demonstration = true};
    all[2] = {.lesson = true, .cut = true, .seam = true, .arc = true, .judges = true};
    all[3].menus = true;
    all[4] = {.home = true};
    const std::array uses{GamepadUse::torch, GamepadUse::playing, GamepadUse::cut, GamepadUse::menus,
                          GamepadUse::menus};
    DrawnInterface interface;
    for (size_t i = 0; i < all.size(); ++i) {
        INFO("situation " << i);
        const KeyGuide guide(all[i]);
        std::set<std::string> parts;
        for (const KeyRow& row : guide.rows()) {
            INFO(row.what);
            interface.draw([&](ui::Context& context) {
                context.byGamepad = true;
                CHECK(keyRowName(context, row).empty() == row.pad.empty());
                context.byGamepad = false;
            });
            if (row.pad.empty()) continue;
            CHECK(phrase(row.pad) != row.pad);
            CHECK(parts.insert(std::string(row.pad)).second);
        }
        for (const auto& [button, part] : {std::pair{GamepadButton::a, "help.pad.a"},
                                           {GamepadButton::b, "help.pad.b"},
                                           {GamepadButton::x, "help.pad.x"},
                                           {GamepadButton::y, "help.pad.y"}}) {
            if (i == 4) break; // arrows and Enter have one line there
            INFO(part);
            CHECK(parts.contains(part) == keyOf(button, uses[i]).has_value());
        }
    }
    const KeyGuide torch(all[0]);
    for (const char* part :
         {"help.pad.left_stick", "help.pad.right_stick", "help.pad.left_trigger", "help.pad.right_trigger",
          "help.pad.right_thumb", "help.pad.shoulders", "help.pad.menu", "help.pad.view"}) {
        INFO(part);
        CHECK(
            std::any_of(torch.rows().begin(), torch.rows().end(), [&](const KeyRow& row) { return row.pad == part; }));
    }
}

} // namespace meltpool::test
