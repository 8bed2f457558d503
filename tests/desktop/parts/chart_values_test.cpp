// Makers' charts at the machine's panel: the rows of the shipped lessons, their words, and the taking of a row.
#include "app/session/lesson_session.hpp"
#include "app/ui/panels.hpp"
#include "core/base/text.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <algorithm>

namespace meltpool {

namespace {

bool has(const std::vector<std::string>& sentences, const std::string& part) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

std::string figure(const ShownChartRow& row, const std::string& label) {
    for (const ShownChartRow::Value& each : row.figures)
        if (each.label == label) return each.text;
    return "none";
}

float settingOf(const LessonSections& sections, std::string_view key) {
    return *std::get<float*>(findParameter(sections.simulation.parameters, key)->value);
}

/// A lesson with its sections.
struct Opened {
    explicit Opened(const std::string& name) : lesson(loadLesson(name)), sections(lesson) { sections.chart.update(); }
    Lesson lesson;
    LessonSections sections;
    ChartValues& chart() { return sections.chart; }
};

} // namespace

TEST_CASE("the panel shows the middle and the range of a maker's row for the lesson's joint, with its source",
          "[chart]") {
    Opened tee("tee-thin");
    REQUIRE(tee.chart().rows().size() > 1);
    CHECK(tee.chart().notice().empty());
    const ShownChartRow& row = tee.chart().shown();
    CHECK(row.title == "Tee, 3.2 mm");
    CHECK(figure(row, "Voltage") == "20.3 V (19.5 to 21)");
    CHECK(figure(row, "Transfer") == "dip (short arc)");
    CHECK(figure(row, "Current") == "135 A (130 to 140)");
    CHECK(figure(row, "Travel speed") == "9.2 mm/s (8.3 to 10)");
    CHECK(figure(row, "Tip to work") == "10 mm");
    CHECK(figure(row, "Leg") == "4 mm");
    CHECK(row.source == "Panasonic YD-350GL4, manual p. 52");
    CHECK(has(row.notes, "The wire feed is the one that melts at it here."));
    CHECK_FALSE(has(row.notes, "taken off"));
    tee.chart().showNext();
    CHECK(tee.chart().shownIndex() == 1);
    CHECK(has(tee.chart().shown().notes, "The chart is for CO2. 1.5 V were taken off for your gas."));
    for (size_t i = 1; i < tee.chart().rows().size(); ++i)
        tee.chart().showNext();
    CHECK(tee.chart().shownIndex() == 0);
    // Another gas, other rows; and the same row again for the same gas.
    setParameter(tee.sections.simulation.parameters, "gas", "co2", "test");
    tee.chart().update();
    CHECK(tee.chart().shown().source.find("OTC") == 0);
    CHECK_FALSE(has(tee.chart().shown().notes, "for your gas"));
    setParameter(tee.sections.simulation.parameters, "gas", "ar", "test");
    tee.chart().update();
    CHECK(tee.chart().rows().empty());
    CHECK(tee.chart().notice() == "No chart row for tee, 3 mm of s235, 2F, wire of 1.2 mm, gas Ar.");
}

TEST_CASE("a lesson's wire feed is near the first row's for the distance at which the lesson is welded", "[chart]") {
    for (const char* name : {"tee-fillet", "tee-thin", "lap-2f", "butt-1g", "tee-3f"}) {
        INFO(name);
        Opened lesson(name);
        REQUIRE_FALSE(lesson.chart().rows().empty());
        const auto feed = lesson.chart().shown().values.feed;
        REQUIRE(feed);
        const double set = double(settingOf(lesson.sections, "wire_feed_m_min")) / 60;
        CHECK(set / feed->middle() == Approx(1).epsilon(0.12));
    }
}

TEST_CASE("trade knowledge is marked, stick and tungsten have their rows, and a flame has none", "[chart]") {
    CHECK(has(Opened("corner-1f").chart().shown().notes, "Trade knowledge: no source was checked."));
    Opened stick("smaw-tee");
    REQUIRE_FALSE(stick.chart().rows().empty());
    CHECK(figure(stick.chart().shown(), "Current") == "120 A (115 to 125)");
    CHECK(figure(stick.chart().shown(), "Wire feed") == "none");
    CHECK(figure(Opened("gtaw-butt").chart().shown(), "Current") == "75 A (65 to 85)");
    Opened bead("gtaw-bead");
    CHECK(bead.chart().notice() == "No chart row for plate, 4 mm of 304, 1G.");
    CHECK_FALSE(Opened("solder-bridge").chart().applies());
    CHECK_FALSE(Opened("classic").chart().applies());
}

TEST_CASE("taking a row sets the machine, as far as the lesson leaves it to the trainee", "[chart]") {
    Opened tee("tee-thin");
    const float given = settingOf(tee.sections, "wire_diameter_mm");
    REQUIRE(tee.chart().canTake());
    CHECK_FALSE(tee.chart().beyondLimits());
    tee.chart().take();
    CHECK(settingOf(tee.sections, "voltage") == 20.3F);
    CHECK(settingOf(tee.sections, "wire_feed_m_min") == Approx(2.96).margin(0.1));
    CHECK(settingOf(tee.sections, "wire_diameter_mm") == given);
    CHECK(tee.sections.machineChanged(tee.lesson));
    // In a test the lesson gives the machine.
    Opened test("tee-thin");
    test.sections.attempt.forScore = true;
    CHECK_FALSE(test.chart().canTake());
    const float voltage = settingOf(test.sections, "voltage");
    test.chart().take();
    CHECK(settingOf(test.sections, "voltage") == voltage);
}

TEST_CASE("taking a row stays within the limits of a setting that the trainee chooses, and says so", "[chart]") {
    Opened bead("gmaw-bead");
    bead.sections.attempt.forScore = true; // voltage and feed are the trainee's in a test, too
    REQUIRE(bead.chart().canTake());
    const Parameter& voltage = *findParameter(bead.sections.simulation.parameters, "voltage");
    const double middle = bead.chart().shown().values.voltage->middle();
    CHECK(bead.chart().beyondLimits() == (middle < voltage.minimum || middle > voltage.maximum));
    bead.chart().take();
    CHECK(double(settingOf(bead.sections, "voltage")) ==
          Approx(std::clamp(middle, voltage.minimum, voltage.maximum)).margin(0.051));
    CHECK(bead.lesson.unsetSettings().empty());
}

TEST_CASE("an unchanged chart is found once, and its panel takes a row by a click", "[chart]") {
    Opened tee("tee-thin");
    test::DrawnInterface drawn;
    const auto content = [&](ui::Context& context) { ui::chartPart(context, tee.chart()); };
    for (int i = 0; i < 3; ++i)
        drawn.draw(content);
    REQUIRE(drawn.shows("simulation.chart_take"));
    REQUIRE(drawn.shows("simulation.chart_next"));
    const ShownChartRow* before = tee.chart().rows().data();
    drawn.draw(content);
    CHECK(tee.chart().rows().data() == before);
    drawn.click("simulation.chart_next", content);
    CHECK(tee.chart().shownIndex() == 1);
    drawn.click("simulation.chart_take", content);
    CHECK(settingOf(tee.sections, "voltage") == Approx(tee.chart().shown().values.voltage->middle()).margin(0.051));
    // In a test without a setting of one's own there is no button.
    tee.sections.attempt.forScore = true;
    drawn.draw(content);
    CHECK_FALSE(drawn.shows("simulation.chart_take"));
}

TEST_CASE("every shipped weld lesson names its gas, or has none", "[chart]") {
    for (const std::string& name : lessonNames(test::sourceFolder() / "app" / "data" / "lessons")) {
        INFO(name);
        const Lesson lesson = loadLesson(name);
        if (lesson.model != LessonModel::Weld) continue;
        const ShieldingGas* gas = equipmentOf(lesson.process).gas;
        const std::string file = readTextFile(lesson.file);
        CHECK((gas != nullptr) == (file.find("\ngas = \"") != std::string::npos));
        if (gas != nullptr) CHECK(file.find("\ngas = \"" + std::string(gas->name) + "\"") != std::string::npos);
    }
}

} // namespace meltpool
