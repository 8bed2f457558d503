// Wishes of a what-if: keys, units, ranges, and their replacements in a record.
#include "core/base/error.hpp"
#include "core/training/lesson/what_if.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

Lesson lessonOf(const std::string& name) {
    return findLesson(name, test::testFolder().parent_path() / "app" / "data" / "lessons");
}

WhatIf read(const Lesson& lesson, const std::vector<std::string>& wishes) {
    return readWhatIf(wishes, lesson);
}

std::string faultOf(const Lesson& lesson, const std::vector<std::string>& wishes) {
    try {
        read(lesson, wishes);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

} // namespace

TEST_CASE("a what-if is read with its units", "[training][comparison]") {
    const Lesson gtaw = lessonOf("gtaw-bead");
    const WhatIf all = read(gtaw, {"speed=0.8", "arc_length=2", "work_angle=-5", "travel_angle=10", "stillness=0.5",
                                   "current=120", "spacing_mm=1.5"});
    CHECK(all.path.speed == 0.8);
    CHECK(all.path.farther == Approx(2e-3));
    CHECK(all.path.workAngle == Approx(-0.0872665));
    CHECK(all.path.travelAngle == Approx(0.174533));
    CHECK(all.path.stillness == 0.5);
    REQUIRE(all.values.size() == 2);
    CHECK(all.values[0] == std::pair<std::string, std::string>("current", "120"));
    CHECK(all.asked.size() == 7);
    CHECK(read(gtaw, {"speed=0.8", "current=120"}).text() == "speed=0.8, current=120");

    const WhatIf travel = read(gtaw, {"speed=3mm/s"});
    REQUIRE(travel.path.travelSpeed);
    CHECK(travel.path.resolved(2e-3).speed == Approx(1.5));
    CHECK_FALSE(travel.path.resolved(2e-3).travelSpeed);
    CHECK_THROWS_AS(travel.path.resolved(std::nullopt), InputError);
    CHECK_THROWS_AS(travel.path.resolved(1e-5), InputError);

    const WhatIf wire = read(lessonOf("gmaw-bead"), {"stick_out=3", "wire_feed=5"});
    CHECK(wire.path.farther == Approx(3e-3));
    REQUIRE(wire.values.size() == 1);
    CHECK(wire.values[0].first == "wire_feed_m_min");
}

TEST_CASE("a what-if that cannot be is refused with what can be changed", "[training][comparison]") {
    const Lesson gmaw = lessonOf("gmaw-bead"), gtaw = lessonOf("gtaw-bead"), classic = lessonOf("classic");
    const auto has = [](const std::string& text, const char* part) {
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    has(faultOf(gmaw, {"colour=red"}), "stick_out, work_angle, travel_angle, stillness");
    has(faultOf(gmaw, {"current=100"}), "wire_feed");
    has(faultOf(gmaw, {"arc_length=2"}), "voltage");
    has(faultOf(gtaw, {"stick_out=2"}), "arc_length");
    has(faultOf(gtaw, {"stillness=2"}), "from 0");
    has(faultOf(gtaw, {"speed=0"}), "factor from 0.1");
    has(faultOf(gtaw, {"speed=quick"}), "factor from 0.1");
    has(faultOf(gtaw, {"travel_angle=200"}), "degrees");
    has(faultOf(gtaw, {"speed=0.5", "speed=0.6"}), "twice");
    has(faultOf(gmaw, {"wire_feed=5", "wire_feed_m_min=5"}), "twice");
    has(faultOf(gtaw, {"speed"}), "KEY=VALUE");
    has(faultOf(gtaw, {"current=1"}), "--what-if current=1");
    has(faultOf(classic, {"speed=0.5"}), "cannot be changed");
    CHECK(read(classic, {"viscosity=0.5"}).values.size() == 1);
}

TEST_CASE("a value that is asked for holds over the record's, and events come at their place of a slower path",
          "[training][comparison]") {
    Lesson lesson = lessonOf("gtaw-bead");
    RecordedAttempt& recorded = lesson.recorded.emplace();
    recorded.values = {{0, "current", "100", 1}, {0, "metal", "304", 2}};
    recorded.changes = {{10, "current", "90", 3}, {20, "rod_diameter_mm", "0", 4}};
    recorded.events = {{30, "torch", "lost"}};
    recorded.stateHash = "00ff";
    takeWhatIf(lesson, read(lesson, {"current=120"}), 0.5);
    CHECK(lesson.process.of<Gtaw>().current == 120);
    CHECK(recorded.values.size() == 1);
    REQUIRE(recorded.changes.size() == 1);
    CHECK(recorded.changes[0].steps == 40);
    CHECK(recorded.events[0].steps == 60);
    CHECK(recorded.stateHash.empty());
}
