// The program's commands, independent of the command line's syntax.
#pragma once

#include "app/desktop/desktop.hpp"
#include "core/training/lesson.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// `meltpool run`; what is left empty keeps the lesson's own value.
struct RunRequest {
    std::string lesson;
    std::filesystem::path folder;
    std::filesystem::path torch;
    std::string seconds;
    std::string picturesEvery;
    std::string size;              ///< "WIDTHxHEIGHT"
    std::vector<std::string> sets; ///< "key=value"
    std::filesystem::path record;  ///< where telemetry.csv goes; empty: into the folder
};

/// The lesson with all that the request changes. Throws InputError for what is not there or does not fit.
Lesson requestedLesson(const RunRequest& request);

/// Runs a lesson without a screen and says where its results are. Throws what runHeadless() throws.
void runLesson(const RunRequest& request);

/// The desktop trainer; without a display the lesson's demonstration, headless. Returns false where something that was
/// to be kept is lost. Throws InputError for what only a window can do.
bool runTrainer(const DesktopOptions& options);

/// `meltpool validate`.
struct ValidationRequest {
    std::vector<std::filesystem::path> cases; ///< empty: all that ship
    std::filesystem::path json;               ///< empty: none
};

/// Runs validation cases and prints every number beside what it should be. Returns false when a case failed; throws
/// InputError for a case file with a fault, RuntimeFault after the case in which a signal asked to stop.
bool runValidation(const ValidationRequest& request);

/// `meltpool check`.
struct CheckRequest {
    std::vector<std::filesystem::path> checks; ///< files, or folders of them
    std::filesystem::path junit;               ///< empty: none
};

/// Welds the lessons of checks (see readLessonCheck()) and prints what came of them. Returns false when one is not as
/// expected or could not be welded to its end; throws InputError for a file with a fault, RuntimeFault when a signal
/// asked to stop.
bool runChecks(const CheckRequest& request);

/// `meltpool report`: writes the page of a run's folder into `file`, by default report.html in the folder. Throws what
/// readRunResults(), reportPage() and writeFile() throw.
void writeReport(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Prints the catalogue.
void listLessons();

/// Prints every value of a lesson that --set takes, with what it is there, unit, range and meaning.
void listParameters(const std::string& lesson);

/// Prints what the machine has and what is missing. Returns false where something is missing that every run needs.
bool runDoctor();

} // namespace meltpool
