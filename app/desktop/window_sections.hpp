// Holds the sections of values that belong to no lesson, for settings file, view menu and telemetry.
#pragma once

#include "app/desktop/desktop_settings.hpp"
#include "app/session/controls.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"

#include <array>
#include <span>
#include <vector>

namespace meltpool {

class WindowSections {
  public:
    /// Borrows all three. Their current values are the defaults.
    WindowSections(Controls& controls, PanelState& panels, LessonSession& session);
    WindowSections(const WindowSections&) = delete; // the sections point at `window`
    WindowSections& operator=(const WindowSections&) = delete;

    WindowParameters window;

    /// Returns the sections of the settings file. `headset`: the headset's section; null: none.
    std::vector<ParameterSection*> forFile(ParameterSection* headset);
    /// Returns the values that belong to the person who welds.
    ParameterList ofPerson(const ParameterSection* headset) const;
    /// Returns the sections of the view menu, with those of the open lesson. Valid until the next call; does not
    /// allocate, since every frame calls it.
    std::span<const ParameterSection* const> forViewMenu(const ParameterSection* headset);
    /// Returns the sections of the telemetry, with those of the open lesson.
    std::vector<const ParameterSection*> forTelemetry() const;

  private:
    LessonSession& session_;
    ParameterSection window_;
    ParameterSection controls_;
    ParameterSection panels_;
    ParameterSection recordings_;
    std::array<const ParameterSection*, 9> viewMenu_{};
};

} // namespace meltpool
