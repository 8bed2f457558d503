// The way from the list of lessons to a running one and back, and what is kept of each: values and best score.
#pragma once

#include "app/desktop/desktop_settings.hpp"
#include "app/session/controls.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"

#include <filesystem>
#include <string>

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
    /// Tells how the table of the lesson's torch path is read, and pathWarnings().
    void tellPath(double now);
    /// Runs the lesson by an attempt or a demonstration. False, with a message, where it cannot begin.
    bool start(void (LessonSession::*begin)(Controls&), double now);

    /// Plays a kept attempt in its lesson, or in the one named, see lessonOfAttempt(), which this throws as, and as
    /// LessonSession::begin().
    void openAttempt(const std::filesystem::path& file, double now, const std::string& lesson = {});
    /// The same from a menu: false, with a message and nothing changed, where the file cannot be used.
    bool replay(const std::filesystem::path& file, double now);

    /// Begins an attempt in the lesson of a kept one, whose torch goes along as the ghost. False, with a message, where
    /// it cannot.
    bool weldBeside(const std::filesystem::path& file, double now);
    /// Compares the two attempts that were marked in their list; where it cannot, a message says why.
    void compare(double now);

    /// Keeps the judged attempt's score where it is the lesson's best. `zoom` at which the workpiece was shown.
    void keepScore(double zoom, double now);
    /// Writes the judged attempt's page, tells where it is, and shows it where the desktop can. `driver` of the
    /// graphics.
    void writePage(const std::string& driver, double now);

  private:
    void take(Lesson opened);
    void tellMoved(const Lesson& attempt, double now);

    Home& home_;
    LessonSession& session_;
    DesktopSettings& settings_;
    Controls& controls_;
    Messages& messages_;
    double zoom_ = 1; ///< of the newest judgement
};

} // namespace meltpool
