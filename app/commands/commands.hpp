// The program's commands, independent of the command line's syntax.
#pragma once

#include "app/desktop/desktop.hpp"
#include "app/platform/result_head.hpp"
#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Arguments of `meltpool run`; an empty value keeps the lesson's own.
struct RunRequest {
    std::string lesson;
    std::filesystem::path folder;
    std::filesystem::path torch;
    std::filesystem::path ghost; ///< path drawn into the pictures; empty: none
    std::string seconds;
    std::string picturesEvery;
    std::string size;              ///< "WIDTHxHEIGHT"
    std::vector<std::string> sets; ///< "key=value"
    std::filesystem::path record;  ///< place of telemetry.csv; empty: in the folder
    std::filesystem::path sound;   ///< WAV file of the sound; empty: none
    std::filesystem::path mesh;    ///< place of the weld's surface at the end; empty: nowhere
    bool video = false;            ///< true: a time-lapse, see FilmRequest
    std::string videoRate;         ///< pictures per second of the film
    std::string videoSpeed;        ///< simulated seconds per second of the film
    std::string turntable;         ///< count of pictures around the finished piece
};

/// Lesson with all changes of the request. Throws InputError for missing or invalid values.
Lesson requestedLesson(const RunRequest& request);

/// Runs a lesson without a screen and prints the place of its results. Throws whatever runHeadless() throws.
void runLesson(const RunRequest& request);

/// Runs the desktop trainer; without a display the lesson's demonstration, headless. Returns false if data that was to
/// be stored is lost. Throws InputError for requests that need a window.
bool runTrainer(const DesktopOptions& options);

/// Arguments of `meltpool validate`.
struct ValidationRequest {
    std::vector<std::filesystem::path> cases; ///< empty: all shipped cases
    ResultPlace results;
    /// Changes of the welds at a chart's values, instead of those in the files.
    std::optional<double> voltageOffset; ///< V
    std::optional<double> speedFactor;   ///< times the travel speed
};

/// Runs validation cases and prints every number next to its expected value. Returns false when a case failed; throws
/// InputError for a case file with a fault, RuntimeFault after the case in which a signal asked to stop.
bool runValidation(const ValidationRequest& request);

/// Arguments of `meltpool check`.
struct CheckRequest {
    std::vector<std::filesystem::path> checks; ///< files, or folders of files
    std::filesystem::path junit;               ///< empty: none
};

/// Welds the lessons of checks (see readLessonCheck()) and prints their results. Returns false if one differs from the
/// expected result or could not be welded to its end; throws InputError for a file with a fault, RuntimeFault when a
/// signal asked to stop.
bool runChecks(const CheckRequest& request);

/// Arguments of `meltpool report`.
struct ReportRequest {
    std::vector<std::filesystem::path> sources; ///< folders of runs, their result.json, or records
    std::filesystem::path page;                 ///< empty: report.html in the folder, or next to the record
    std::string lesson; ///< lesson of the records; empty: the one of the catalogue that they name
};

/// Writes a page for each source. Throws InputError for a source of no known kind, and whatever readRunResults(),
/// readRecordResults() and writeFile() throw.
void writeReports(const ReportRequest& request);

/// Arguments of `meltpool history`.
struct HistoryRequest {
    std::filesystem::path folder; ///< results of bench and validate, see readResultHistory()
    std::filesystem::path page = "history.html";
};

/// Writes the page of all results in the folder, and tells on standard error of each JSON file that is no complete
/// result. Throws as readResultHistory() and writeFile().
void writeHistory(const HistoryRequest& request);

/// Arguments of `meltpool recordings`.
struct RecordingsRequest {
    std::filesystem::path folder; ///< empty: the user's folder
    /// Recording and the table to make of it, or only the table of all recordings; empty: none.
    std::vector<std::filesystem::path> table;
    bool json = false;             ///< true: the list as JSON
    std::filesystem::path checked; ///< recording to check; empty: none
};

/// Lists recordings, makes a table of all or of one, or checks one. Returns false if a recording is damaged. Throws
/// InputError for a file that is no recording.
bool runRecordings(const RecordingsRequest& request);

/// Arguments of `meltpool replay`; an empty value keeps the lesson's own.
struct ReplayRequest {
    std::filesystem::path file; ///< file of the attempt
    std::string lesson;         ///< name or file; empty: the one that the attempt names
    std::filesystem::path folder;
    std::string seek;                ///< s; empty: to the end
    std::string picturesEvery;       ///< s
    std::string size;                ///< "WIDTHxHEIGHT"
    std::vector<std::string> views;  ///< "key=value" of the pictures
    std::vector<std::string> whatIf; ///< "key=value", see readWhatIf()
    bool page = true;                ///< page of a what-if: comparison.html
};

/// Welds a recorded attempt again into the folder, and prints if its metal ended in identical bits. With what-ifs the
/// attempt is welded into `original` and, changed, into `what-if` in the folder, and both are compared. Throws
/// InputError for missing or invalid values, and whatever runHeadless() throws.
void replayAttempt(const ReplayRequest& request);

/// Arguments of `meltpool compare`.
struct CompareRequest {
    std::filesystem::path first, second; ///< files of attempts, folders of runs or their result.json
    std::string lesson;                  ///< lesson of the attempts; empty: the one that they name
    std::filesystem::path folder;
    std::string picturesEvery; ///< s, for attempts that are welded; empty: one at the end
    std::string size;
    bool page = true;
};

/// Welds the attempts into `first` and `second` in the folder, prints how the second differs from the first and writes
/// comparison.html. Throws as replayAttempt().
void compareAttemptFiles(const CompareRequest& request);

/// Arguments of `meltpool demonstration`.
struct DemonstrationRequest {
    std::filesystem::path file; ///< file of the attempt
    std::string lesson;         ///< as in ReplayRequest
    std::filesystem::path out;  ///< .csv: the torch path; .toml: a lesson, with its path next to it
};

/// Writes an attempt as a demonstration for `run` and the trainer, without the time before and after the weld. Throws
/// InputError for an attempt without a pull of the trigger and for a file of no known kind.
void makeDemonstration(const DemonstrationRequest& request);

/// Prints the catalogue, group by group if a school or the person has lessons too. Returns false, with a sentence on
/// standard error for each, if a lesson or a folder of lessons cannot be used.
bool listLessons(bool json = false);

/// Prints every value of a lesson that --set takes, with its current value, unit, range and meaning.
void listParameters(const std::string& lesson, bool json = false);

/// Prints the parts that the machine has and lacks; with `speed` also the metal that it can keep up with, which takes
/// ten seconds. Returns false if a part that every run needs is missing.
bool runDoctor(bool speed = false);

} // namespace meltpool
