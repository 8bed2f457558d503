// Tests the table of the window's actions: each name, key and request leads to one action.
#include "app/desktop/desktop_actions.hpp"
#include "tests/support/catch.hpp"

#include <set>
#include <string>

namespace meltpool::test {

TEST_CASE("each name, key and request of the window is that of one action") {
    std::set<std::string> names;
    std::set<Key> keys;
    std::set<MenuRequest> requests;
    for (const DesktopAction& action : desktopActions()) {
        INFO(action.name);
        CHECK(names.insert(action.name).second);
        if (action.key) CHECK(keys.insert(*action.key).second);
        if (action.request != MenuRequest::none) CHECK(requests.insert(action.request).second);
        CHECK((action.key || action.request != MenuRequest::none)); // an action without both would be out of reach
    }
    CHECK(!names.empty());
}

TEST_CASE("each request of menus and headset has an action") {
    std::set<MenuRequest> requests;
    for (const DesktopAction& action : desktopActions())
        requests.insert(action.request);
    for (int i = 0; i <= static_cast<int>(MenuRequest::welder); ++i) {
        INFO("request " << i);
        CHECK(requests.count(static_cast<MenuRequest>(i)) == 1); // actions with a key only have `none`
    }
}

} // namespace meltpool::test
