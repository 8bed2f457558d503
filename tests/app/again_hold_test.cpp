// The hold of a trigger that asks for the next attempt.
#include "app/headset/again_hold.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

namespace {

/// Holds the trigger for so many frames of `elapsed` s; returns the number of frames that ask.
int held(AgainHold& hold, int frames, double elapsed, bool free = true) {
    int asks = 0;
    for (int i = 0; i < frames; ++i) {
        hold.update(true, free, elapsed);
        asks += hold.asked();
    }
    return asks;
}

} // namespace

TEST_CASE("a trigger held for a second over a result asks once", "[app]") {
    AgainHold hold;
    CHECK(held(hold, 80, 1.0 / 90) == 0);
    CHECK(hold.holds());
    CHECK(held(hold, 200, 1.0 / 90) == 1);
    hold.update(false, true, 1.0 / 90);
    CHECK_FALSE(hold.holds());
    CHECK(held(hold, 100, 1.0 / 90) == 1);
}

TEST_CASE("a pull before the result, or over the panel, and a slow frame ask for nothing", "[app]") {
    AgainHold hold;
    CHECK(held(hold, 10, 1.0 / 90, false) == 0);
    CHECK(held(hold, 300, 1.0 / 90) == 0); // the pull of the weld goes on over its result
    hold.update(false, true, 1.0 / 90);
    CHECK(held(hold, 3, 2.0) == 0);
}
