// Leads from the list of lessons to a running one and back, and saves each lesson's values and best score.
#pragma once

#include "app/desktop/desktop_settings.hpp"
#include "app/session/controls.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

/// Borrows the window's objects; `now` is s on the program's clock.
class DesktopLessons {
  public:
    DesktopLessons(Home& home, LessonSession& session, DesktopSettings& settings, Controls& controls,
                   Messages& messages)
        : home_(home), session_(session), settings_(settings), controls_(controls), messages_(messages) {}

    /// Ends the attempt and shows the lesson's first page.
    void leave();
    /// Shows the list of lessons.
    void goHome();
    /// Shows the first page of another lesson; for a faulty file a message says so and nothing changes.
    void open(const CataloguedLesson& lesson, double now);
    /// Reports how the program reads the table of the lesson's torch path, and pathWarnings().
    void tellPath(double now);
    /// Runs the lesson by an attempt or a demonstration. Returns false, with a message, if it cannot begin.
    bool start(void (LessonSession::*begin)(Controls&), double now);

    /// Plays a saved attempt in its lesson, or in the named one. Throws as lessonOfAttempt() and
    /// LessonSession::begin().
    void openAttempt(const std::filesystem::path& file, double now, const std::string& lesson = {});
    /// Plays a saved attempt from a menu. Returns false, with a message and nothing changed, if the file cannot be
    /// used.
    bool replay(const std::filesystem::path& file, double now);

    /// Begins an attempt in the lesson of a saved one, whose torch is the ghost. Returns false, with a message, if it
    /// cannot.
    bool weldBeside(const std::filesystem::path& file, double now);
    /// Compares the two attempts marked in their list; if it cannot, a message says why.
    void compare(double now);
    /// Shows the page of the attempt chosen in the list, and makes it first if it has none.
    void showKeptPage(double now);
    /// Writes the list's shown rows as a table, and shows it if the desktop can.
    void exportAttempts();

    /// Ends the judged attempt and compares it with itself under the chosen remedy, in the list of attempts; if it
    /// cannot, a message says why.
    void tryCure(double now);

    /// Saves the judged attempt's score if it is the lesson's best. `zoom`: zoom at which the workpiece was shown.
    void keepScore(double zoom, double now);
    /// Writes the judged attempt's page, reports its file, and shows it if the desktop can. `driver`: name of the
    /// graphics driver.
    void writePage(const std::string& driver, double now);

  private:
    void take(Lesson opened);
    void tellMoved(const Lesson& attempt, double now);

    Home& home_;
    LessonSession& session_;
    DesktopSettings& settings_;
    Controls& controls_;
    Messages& messages_;
    double zoom_ = 1; ///< zoom of the newest judgement
};

} // namespace meltpool
