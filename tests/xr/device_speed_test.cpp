// Tests the choice of the display's rate.
#include "tests/support/catch.hpp"
#include "xr/device_speed.hpp"

#include <vector>

using namespace meltpool;

TEST_CASE("the display's rate is the highest up to 90 Hz, in any order, and the runtime's own if all are higher") {
    CHECK(xr::chooseRefreshRate(std::vector{72.0f, 80.0f, 90.0f, 120.0f}) == 90.0f);
    CHECK(xr::chooseRefreshRate(std::vector{120.0f, 89.95f, 60.0f}) == 89.95f);
    CHECK(xr::chooseRefreshRate(std::vector{72.0f, 60.0f}) == 72.0f);
    CHECK_FALSE(xr::chooseRefreshRate(std::vector{120.0f, 144.0f}));
    CHECK_FALSE(xr::chooseRefreshRate({}));
}
