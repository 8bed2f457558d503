// The way from the list of lessons to a running one and back, and what is kept of each: values and best score.
#pragma once

#include "app/desktop/desktop_settings.hpp"
#include "app/session/controls.hpp"
#include "app/session/home/home.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"

namespace meltpool {

/// Borrows what the window has; `now` is s on the program's clock.
class DesktopLessons {
  public:
    DesktopLessons(Home& home, LessonSession& session, DesktopSettings& settings, Controls& controls,
                   Messages& messages)
        : home_(home), session_(session), settings_(settings), controls_(controls), messages_(messages) {}

    /// Ends the attempt: the lesson's first page.
    void leave();
    /// The list of lessons.
    void goHome();
    /// The first page of another lesson; a file at fault is told and nothing changes.
    void open(const CataloguedLesson& lesson, double now);
    /// Runs the lesson by an attempt or a demonstration. False, with a message, where it cannot begin.
    bool start(void (LessonSession::*begin)(Controls&), double now);

    /// Keeps the judged attempt's score where it is the lesson's best. `zoom` at which the workpiece was shown.
    void keepScore(double zoom, double now);

  private:
    Home& home_;
    LessonSession& session_;
    DesktopSettings& settings_;
    Controls& controls_;
    Messages& messages_;
};

} // namespace meltpool
