// The doctor's measurement of a weld's speed and its advice on the particle spacing.
#include "app/commands/speed_doctor.hpp"
#include "core/base/resources.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

using namespace meltpool;

TEST_CASE("the doctor advises the finest spacing that leaves time for the picture", "[app]") {
    const std::array fast{WeldSpeed{1, 1.6}};
    CHECK(bearableSpacing(fast) == 1.0F);
    CHECK(speedFinding(fast).state == Finding::State::good);
    CHECK(speedFinding(fast).remedy.empty());
    CHECK_THAT(speedFinding(fast).found, test::containsText("1 mm: 160 %"));
    const std::array middling{WeldSpeed{1, 1.1}, WeldSpeed{1.5F, 2.4}};
    CHECK(bearableSpacing(middling) == 1.5F);
    CHECK(speedFinding(middling).state == Finding::State::note);
    CHECK_THAT(speedFinding(middling).found, test::containsText("1 mm: 110 %, at 1.5 mm: 240 %"));
    CHECK_THAT(speedFinding(middling).remedy, test::containsText("1.5 mm"));
    const std::array slow{WeldSpeed{1, 0.1}, WeldSpeed{1.5F, 0.2}, WeldSpeed{2, 0.4}};
    CHECK_FALSE(bearableSpacing(slow));
    CHECK_THAT(speedFinding(slow).remedy, test::containsText("slower than the clock"));
}

TEST_CASE("a weld's speed is that of its steps", "[app]") {
    Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    for (const auto& [key, value] : {std::pair{"length_mm", "30"}, {"width_mm", "20"}, {"spacing_mm", "2"}})
        lesson.set(key, value, "test");
    const WeldSpeed speed = measureWeldSpeed(test::shaders(), lesson, 0, 0); // one step each
    CHECK(speed.spacingMm == 2);
    CHECK(speed.ratio > 0);
    CHECK(speed.ratio < 1e4);
}
