// Tests the window's size and place for work areas, densities and several screens.
#include "app/desktop/window_place.hpp"
#include "tests/support/catch.hpp"

#include <array>

namespace meltpool::test {

namespace {

constexpr glm::ivec2 kUsual{1280, 720};

} // namespace

TEST_CASE("the window grows with the desktop's scale as far as the work area allows") {
    const ScreenArea wide{{0, 0}, {3840, 2160}};
    CHECK(fittingSize(kUsual, 1, wide, {}) == glm::ivec2(1280, 720));
    CHECK(fittingSize(kUsual, 2, wide, {}) == glm::ivec2(2560, 1440));
    CHECK(fittingSize(kUsual, 3, wide, {}) == glm::ivec2(3840, 2160));
    CHECK(fittingSize(kUsual, 1.25f, wide, {}) == glm::ivec2(1600, 900));
    // A panel of the desktop and the window's own frame need room too.
    const WindowFrame frame{{4, 28}, {4, 6}};
    CHECK(fittingSize(kUsual, 3, {{0, 40}, {3840, 2120}}, frame) == glm::ivec2(3832, 2086));
    CHECK(fittingSize(kUsual, 1, {{0, 0}, {800, 600}}, frame) == glm::ivec2(792, 566));
    CHECK(fittingSize(kUsual, 1, {{0, 24}, {1024, 576}}, {}) == glm::ivec2(1024, 576));
    CHECK(fittingSize(kUsual, 2, {}, frame) == glm::ivec2(2560, 1440)); // the screen is unknown
}

TEST_CASE("the smallest window grows with the scale too, but never beyond the one that fits") {
    CHECK(leastSize(1, kUsual) == glm::ivec2(640, 480));
    CHECK(leastSize(2, {2560, 1440}) == glm::ivec2(1280, 960));
    CHECK(leastSize(2, {792, 566}) == glm::ivec2(792, 566));
}

TEST_CASE("a window that sticks out of the work area goes to its middle, another stays where it is") {
    const ScreenArea workArea{{100, 30}, {1000, 700}};
    const WindowFrame frame{{5, 25}, {5, 5}};
    CHECK_FALSE(placeInside({{105, 55}, {600, 400}}, frame, workArea));
    CHECK(placeInside({{104, 55}, {600, 400}}, frame, workArea) == glm::ivec2(300, 190));
    CHECK(placeInside({{105, 54}, {600, 400}}, frame, workArea) == glm::ivec2(300, 190));
    CHECK(placeInside({{600, 55}, {600, 400}}, frame, workArea) == glm::ivec2(300, 190));
    CHECK_FALSE(placeInside({{105, 55}, {990, 670}}, frame, workArea)); // the window fills it
    CHECK(placeInside({{0, 0}, {2000, 2000}}, frame, workArea) == glm::ivec2(105, 55));
    CHECK_FALSE(placeInside({{-50, -50}, {600, 400}}, frame, {}));
}

TEST_CASE("full screen goes to the screen that shows most of the window") {
    const std::array<ScreenArea, 3> screens{
        {{{0, 0}, {1920, 1080}}, {{1920, 0}, {2560, 1440}}, {{-1280, 200}, {1280, 720}}}};
    CHECK(screenOf({{100, 100}, {1280, 720}}, screens) == 0);
    CHECK(screenOf({{2000, 300}, {1280, 720}}, screens) == 1);
    CHECK(screenOf({{1200, 300}, {1280, 720}}, screens) == 0); // 720 points on the first, 560 on the second
    CHECK(screenOf({{1400, 300}, {1280, 720}}, screens) == 1);
    CHECK(screenOf({{-900, 300}, {1280, 500}}, screens) == 2);
    CHECK(screenOf({{9000, 9000}, {10, 10}}, screens) == 0); // the window is on no screen
}

} // namespace meltpool::test
