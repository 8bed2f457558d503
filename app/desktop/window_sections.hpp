// Sections of values that belong to no lesson, for settings file, view menu and telemetry.
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
    /// Borrows all three. The values that they hold now are the defaults.
    WindowSections(Controls& controls, PanelState& panels, LessonSession& session);
    WindowSections(const WindowSections&) = delete; // the sections point at `window`
    WindowSections& operator=(const WindowSections&) = delete;

    WindowParameters window;

    /// `headset`: the headset's section; null: there is none.
    std::vector<ParameterSection*> forFile(ParameterSection* headset);
    /// With those of the open lesson. Holds until the next call; does not allocate, as it is called in each frame.
    std::span<const ParameterSection* const> forViewMenu(const ParameterSection* headset);
    /// With those of the open lesson.
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
