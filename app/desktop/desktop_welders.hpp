// Gives best scores, skill, recordings and settings to the person who welds.
#pragma once

#include "app/session/home.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/person_settings.hpp"

#include <string>
#include <vector>

namespace meltpool {

/// Borrows the window's objects; `now` is s on the program's clock.
class DesktopWelders {
  public:
    DesktopWelders(Home& home, LessonSession& session, Messages& messages)
        : home_(home), session_(session), messages_(messages) {}

    /// Takes the values in use that belong to a person, see PersonSettings::use().
    void use(ParameterList values) { settings_.use(std::move(values)); }
    /// Takes the person of Home::who. Expects that no lesson runs.
    void enter(double now);
    /// Stores the person's settings, and sets those in use to the account's, before the program saves them. Returns a
    /// sentence for each fault.
    std::vector<std::string> leave() { return settings_.leave(); }

  private:
    Home& home_;
    LessonSession& session_;
    Messages& messages_;
    PersonSettings settings_;
};

} // namespace meltpool
