// The program's commands, independent of the command line's syntax.
#pragma once

#include "app/desktop/desktop.hpp"
#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// `meltpool run`; what is left empty keeps the lesson's own value.
struct RunRequest {
    std::string lesson;
    std::filesystem::path folder;
    std::filesystem::path torch;
    std::filesystem::path ghost; ///< drawn into the pictures; empty: none
    std::string seconds;
    std::string picturesEvery;
    std::string size;              ///< "WIDTHxHEIGHT"
    std::vector<std::string> sets; ///< "key=value"
    std::filesystem::path record;  ///< where telemetry.csv goes; empty: into the folder
    std::filesystem::path sound;   ///< WAV file of what is heard; empty: none
    std::filesystem::path mesh;    ///< where the weld's surface goes at the end; empty: nowhere
    bool video = false;            ///< a time-lapse, see FilmRequest
    std::string videoRate;         ///< its pictures a second
    std::string videoSpeed;        ///< simulated seconds in each of its seconds
    std::string turntable;         ///< pictures round the finished piece
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

/// `meltpool report`.
struct ReportRequest {
    std::vector<std::filesystem::path> sources; ///< folders of runs, their result.json, or records
    std::filesystem::path page;                 ///< empty: report.html in the folder, or beside the record
    std::string lesson;                         ///< of the records; empty: the one of the catalogue that they name
};

/// Writes a page for each source. Throws InputError where one is none, and what readRunResults(), readRecordResults()
/// and writeFile() throw.
void writeReports(const ReportRequest& request);

/// `meltpool recordings`.
struct RecordingsRequest {
    std::filesystem::path folder; ///< empty: the user's
    /// A recording and the table that is made of it, or only the table of all recordings; empty: none.
    std::vector<std::filesystem::path> table;
    bool json = false;             ///< the list as JSON
    std::filesystem::path checked; ///< a recording; empty: none
};

/// Lists recordings, makes a table of all or of one, or checks one. Returns false where a recording is damaged. Throws
/// InputError for a file that is no recording.
bool runRecordings(const RecordingsRequest& request);

/// `meltpool replay`; what is left empty keeps the lesson's own value.
struct ReplayRequest {
    std::filesystem::path file; ///< of the attempt
    std::string lesson;         ///< name or file; empty: the one that the attempt names
    std::filesystem::path folder;
    std::string seek;                ///< s; empty: to the end
    std::string picturesEvery;       ///< s
    std::string size;                ///< "WIDTHxHEIGHT"
    std::vector<std::string> views;  ///< "key=value" of what pictures show
    std::vector<std::string> whatIf; ///< "key=value", see readWhatIf()
    bool page = true;                ///< of a what-if: comparison.html
};

/// Welds a recorded attempt again into the folder, and says whether its metal ended in the same bits. With what-ifs the
/// attempt is welded into `original` and, changed, into `what-if` in the folder, and both are compared. Throws
/// InputError for what is not there or does not fit, and what runHeadless() throws.
void replayAttempt(const ReplayRequest& request);

/// `meltpool compare`.
struct CompareRequest {
    std::filesystem::path first, second; ///< files of attempts, folders of runs or their result.json
    std::string lesson;                  ///< of the attempts; empty: what they name
    std::filesystem::path folder;
    std::string picturesEvery; ///< s, of attempts that are welded; empty: one at the end
    std::string size;
    bool page = true;
};

/// Welds the attempts into `first` and `second` in the folder, says how the second differs from the first and writes
/// comparison.html. Throws as replayAttempt().
void compareAttemptFiles(const CompareRequest& request);

/// `meltpool demonstration`.
struct DemonstrationRequest {
    std::filesystem::path file; ///< of the attempt
    std::string lesson;         ///< as in ReplayRequest
    std::filesystem::path out;  ///< .csv: the torch path; .toml: a lesson, with its path beside it
};

/// Writes an attempt as a demonstration, without the time before and after the weld, that `run` and the trainer take.
/// Throws InputError for an attempt without a pull of the trigger and a file that is neither.
void makeDemonstration(const DemonstrationRequest& request);

/// Prints the catalogue, group by group where a school or the person has lessons too. Returns false, with a sentence on
/// standard error for each, where a lesson or a folder of lessons cannot be used.
bool listLessons(bool json = false);

/// Prints every value of a lesson that --set takes, with what it is there, unit, range and meaning.
void listParameters(const std::string& lesson, bool json = false);

/// Prints what the machine has and what is missing; with `speed` also what it bears, which takes ten seconds. Returns
/// false where something is missing that every run needs.
bool runDoctor(bool speed = false);

} // namespace meltpool
