// Contact of the tip with the metal.
#include "core/weld/process/tip_touch.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

namespace {

SurfaceDistance metalAt(float mm) {
    SurfaceDistance metal;
    metal.ahead = metal.nearest = mm * 1e-3f;
    return metal;
}

constexpr float kRadius = 1.2e-3f; // radius of a tungsten electrode, m
constexpr double kFrame = 1.0 / 90;

} // namespace

TEST_CASE("a touch is noticed once, with the speed at which the hand came, and again after leaving") {
    TipTouch touch;
    const glm::vec3 down(0, -0.2f, 0);
    touch.update(kRadius, metalAt(10), down, kFrame);
    CHECK_FALSE(touch.touching());
    // The answer arrives after the hand has stopped.
    touch.update(kRadius, metalAt(1.0f), glm::vec3(0), kFrame);
    CHECK(touch.touching());
    CHECK(touch.since() == 0);
    CHECK(touch.speed() > 0.1f);
    CHECK(touch.speed() <= 0.2f);
    for (const float mm : {0.5f, 1.1f, 1.3f, 1.6f, 0.9f}) // a tremble at the surface is no new touch
        touch.update(kRadius, metalAt(mm), down, kFrame);
    CHECK(touch.count() == 1);
    CHECK(touch.since() == Approx(5.0 / 90));
    touch.update(kRadius, metalAt(2), -down, kFrame);
    CHECK_FALSE(touch.touching());
    touch.update(kRadius, metalAt(1), glm::vec3(0.3f, 0, 0), kFrame);
    CHECK(touch.count() == 2);
}

TEST_CASE("a hand that comes back inside the metal has touched nothing") {
    TipTouch touch;
    touch.update(kRadius, metalAt(-3), glm::vec3(0), kFrame);
    CHECK(touch.touching());
    CHECK(touch.count() == 0);
    touch.update(kRadius, metalAt(9), glm::vec3(0), kFrame);
    touch.update(kRadius, metalAt(0), glm::vec3(0), kFrame);
    CHECK(touch.count() == 1);
    touch.forget();
    touch.update(kRadius, metalAt(-3), glm::vec3(0), kFrame);
    CHECK(touch.count() == 1);
}
