#include "app/session/lesson_sections.hpp"

#include <algorithm>
#include <array>

namespace meltpool {

namespace {

ParameterList workpieceParameters(Lesson& lesson) {
    return lesson.model == LessonModel::Weld ? describe(lesson.workpiece) : describe(lesson.setup);
}

ParameterList startParameters(Lesson& lesson, AttemptParameters& attempt) {
    ParameterList list = describe(attempt);
    for (const Parameter& p : workpieceParameters(lesson))
        if (p.key != "seed") list.push_back(p);
    for (const Parameter& p : describe(lesson.surface))
        if (p.onlyAtStart || p.key == "influence") list.push_back(p);
    return list;
}

/// Parameters of the look without the picture's detail, which is a setting of the window for all lessons.
ParameterList viewParameters(LookParameters& look) {
    ParameterList list = describe(look);
    std::erase_if(list, [](const Parameter& p) { return p.key == "detail"; });
    return list;
}

/// Keys of the look that have no effect in this lesson.
std::span<const std::string_view> idleLook(const Lesson& lesson) {
    static constexpr std::array<std::string_view, 8> kIdle{"arc_light",         "spatter",         "fume",
                                                           "visor_light_shade", "visor_switching", "adaptation",
                                                           "material",          "show_source"};
    const std::span<const std::string_view> all(kIdle);
    if (lesson.model == LessonModel::Classic) return all.first(6); // the classic model has no arc
    return isArcWelding(lesson.process) ? all.last(2) : all;
}

} // namespace

ParameterList liveParameters(ParameterList list) {
    std::erase_if(list, [](const Parameter& p) { return p.onlyAtStart; });
    return list;
}

ParameterList describe(AttemptParameters& a) {
    return {{"for_score",
             "Test",
             "",
             &a.forScore,
             0,
             1,
             "No help is shown. The computer's speed is checked first.",
             {},
             true}};
}

LessonSections::LessonSections(Lesson& lesson)
    : start("start", startParameters(lesson, attempt)),
      view("view", viewParameters(lesson.look)),
      surface("surface", liveParameters(describe(lesson.surface))),
      simulation("simulation", liveParameters(lesson.model == LessonModel::Weld ? lesson.processParameters()
                                                                                : describe(lesson.metal))),
      chart(lesson, simulation) {
    static constexpr std::array<std::string_view, 1> kStart{"for_score"};
    static constexpr std::array<std::string_view, 2> kFlame{"heat_radius", "heat_temperature"};
    view.idle = idleLook(lesson);
    start.everyday = kStart;
    if (lesson.model == LessonModel::Classic) simulation.everyday = kFlame;
    if (lesson.model == LessonModel::Weld) {
        simulation.fixed = &attempt.forScore;
        simulation.words = traitsOf(lesson.process).name; // processes give one key different labels
    }
    for (const ChosenSetting& each : lesson.choose) {
        simulation.chosen.push_back(each.key);
        // A value outside the allowed choices cannot be a default.
        if (each.start && (*each.start < each.from || *each.start > each.to)) simulation.defaults.erase(each.key);
    }
}

void LessonSections::restoreDefaults() {
    for (const ParameterSection* each : all())
        for (const auto& [key, text] : each->defaults)
            setParameter(each->parameters, key, text, each->name);
}

void LessonSections::restoreGiven() {
    for (const Parameter& p : simulation.parameters)
        if (simulation.isGiven(p)) setParameter({p}, p.key, simulation.defaults.at(std::string(p.key)), "given");
}

bool LessonSections::workpieceChanged(Lesson& lesson) const {
    const ParameterList now = workpieceParameters(lesson);
    return std::any_of(now.begin(), now.end(), [this](const Parameter& p) {
        const auto first = start.defaults.find(p.key);
        return first != start.defaults.end() && first->second != parameterText(p);
    });
}

bool LessonSections::machineChanged(const Lesson& lesson) const {
    if (lesson.model != LessonModel::Weld) return false;
    return std::any_of(simulation.parameters.begin(), simulation.parameters.end(), [this](const Parameter& p) {
        const auto first = simulation.defaults.find(p.key);
        const bool chosen =
            std::find(simulation.chosen.begin(), simulation.chosen.end(), p.key) != simulation.chosen.end();
        return !chosen && first != simulation.defaults.end() && first->second != parameterText(p);
    });
}

} // namespace meltpool
