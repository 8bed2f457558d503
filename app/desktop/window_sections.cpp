#include "app/desktop/window_sections.hpp"

#include "app/session/person_settings.hpp"

namespace meltpool {

WindowSections::WindowSections(Controls& controls, PanelState& panels, LessonSession& session)
    : session_(session),
      window_("window", describe(window)),
      controls_("controls", describe(controls.parameters)),
      panels_("panels", describe(panels)),
      recordings_("recordings", describe(session.log().recordings().parameters)) {}

std::vector<ParameterSection*> WindowSections::forFile(ParameterSection* headset) {
    HelpSections& help = session_.help();
    std::vector<ParameterSection*> sections{&window_,    &controls_,  &panels_,    &help.cues,
                                            &help.sound, &help.ghost, &recordings_};
    if (headset) sections.push_back(headset);
    return sections;
}

ParameterList WindowSections::ofPerson(const ParameterSection* headset) const {
    ParameterList values;
    for (const ParameterSection* section : {&window_, headset})
        for (const Parameter& p : section != nullptr ? section->parameters : ParameterList())
            if (PersonSettings::has(p.key)) values.push_back(p);
    return values;
}

std::span<const ParameterSection* const> WindowSections::forViewMenu(const ParameterSection* headset) {
    LessonSections& lesson = session_.sections();
    HelpSections& help = session_.help();
    viewMenu_ = {&help.cues, &help.ghost, &lesson.view, &lesson.surface, &help.sound,
                 &controls_, &window_,    &recordings_, headset};
    return std::span(viewMenu_).first(headset ? 9 : 8);
}

std::vector<const ParameterSection*> WindowSections::forTelemetry() const {
    const LessonSections& lesson = session_.sections();
    const HelpSections& help = session_.help();
    return {&lesson.start, &lesson.view, &lesson.surface, &lesson.simulation, &window_,
            &controls_,    &panels_,     &help.cues,      &help.sound,        &help.ghost};
}

} // namespace meltpool
