// Tests that menus show only the values with an effect in the current lesson, and temperatures with their unit.
#include "app/session/lesson_session.hpp"
#include "app/ui/panels.hpp"
#include "core/weld/process/processes.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

bool shows(const ParameterSection& section, std::string_view key) {
    const Parameter* parameter = findParameter(section.parameters, key);
    return parameter != nullptr && section.shows(*parameter);
}

} // namespace

TEST_CASE("a lesson's pages have the values of its own process only, and all of them") {
    for (int kind = 0; kind < static_cast<int>(AllProcesses::kCount); ++kind) {
        Lesson lesson = loadLesson("gmaw-bead");
        lesson.process.kind = kind;
        LessonSections sections(lesson);
        INFO(AllProcesses::kNames[static_cast<size_t>(kind)]);
        CHECK(shows(sections.simulation, "wire_feed_m_min") == lesson.process.is<Gmaw>());
        CHECK(shows(sections.simulation, "electrode_diameter_mm") ==
              (lesson.process.is<Gtaw>() || lesson.process.is<Smaw>()));
        CHECK_FALSE(shows(sections.simulation, "heat_temperature")); // parameter of the classic source
        CHECK(sections.simulation.name == "simulation"); // prefix of its controls and its table in the settings
        CHECK(sections.simulation.words == traitsOf(lesson.process).name);
        CHECK(sections.view.words == "view");
        const bool arc = isArcWelding(lesson.process);
        CHECK(shows(sections.view, "arc_light") == arc);
        CHECK_FALSE(shows(sections.view, "material")); // the view shows the workpiece's own
        CHECK_FALSE(shows(sections.view, "show_source"));
        CHECK(shows(sections.view, "exposure"));
        // Files and --set accept them too.
        setParameter(sections.view.parameters, "arc_light", "0.5", "test");
        CHECK(lesson.look.arcLight == 0.5f);
    }
    Lesson classic = loadLesson("classic");
    LessonSections sections(classic);
    CHECK(shows(sections.view, "material"));
    CHECK(shows(sections.view, "show_source"));
    CHECK_FALSE(shows(sections.view, "arc_light"));
    CHECK(shows(sections.simulation, "heat_temperature"));
    CHECK(sections.simulation.words == "simulation");
}

TEST_CASE("the highest temperature has its unit, but for the classic metal, whose scale has none") {
    LessonFigures figures;
    figures.kelvin = true;
    figures.hottest = 293.15;
    CHECK(std::string_view(ui::hottestText(figures)) == "20 \xC2\xB0"
                                                        "C");
    figures.hottest = 1811.2;
    CHECK(std::string_view(ui::hottestText(figures)) == "1538 \xC2\xB0"
                                                        "C");
    figures.kelvin = false;
    figures.hottest = 0.534;
    CHECK(std::string_view(ui::hottestText(figures)) == "0.53");
}

} // namespace meltpool
