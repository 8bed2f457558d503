#include "app/commands/command_line.hpp"

#include "app/bench/bench.hpp"
#include "app/commands/attempt_options.hpp"
#include "app/commands/command_texts.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/shell_documents.hpp"
#include "app/desktop/error_window.hpp"
#include "app/library/persons.hpp"
#include "app/platform/memory.hpp"
#include "app/platform/program_info.hpp"
#include "app/platform/say.hpp"
#include "app/platform/watched_run.hpp"
#include "app/sound/openal_device.hpp"
#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/likely_name.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson_folders.hpp"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <vector>

namespace meltpool {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadInput = 2;

#ifdef __linux__
/// Option for starts from an icon, without a terminal that shows standard error.
constexpr const char* kErrorWindow = "--error-window";
#endif

/// The parsed command line.
struct Arguments {
    RunRequest run;
    DesktopOptions desktop;
    bool errorWindow = false; ///< runProgram() acts on it earlier
    bool headset = false;
    bool desktopOnly = false;
    bool unrecorded = false;
    RecordingsRequest recordings;
    std::string suite;
    ResultPlace benchResults;
    ValidationRequest validation;
    CheckRequest check;
    ReportRequest report;
    HistoryRequest history;
    AttemptArguments attempts;
    std::string listed; ///< lesson whose values are listed; empty: the catalogue
    bool listedAsJson = false;
    bool quiet = false;
    std::string shell;                  ///< shell whose completion script is printed
    std::vector<std::string> completed; ///< words of the command line that a script completes
    bool speed = false;                 ///< true: the doctor welds too
};

void addDesktop(CLI::App& app, Arguments& arguments) {
    app.add_option("--lesson", arguments.desktop.lesson,
                   "The window opens on this lesson, a name of the catalogue or a TOML file; without one on the list "
                   "of lessons")
        ->type_name("LESSON");
    app.add_option("--telemetry", arguments.desktop.telemetry,
                   "Write the state of the window here, one JSON object a line")
        ->type_name("FILE");
    app.add_option("--record", arguments.desktop.record, "Write every step of the lesson here, as a torch path")
        ->type_name("FILE");
    app.add_option("--replay", arguments.desktop.replay,
                   "The window opens on this kept attempt and plays it; a torch path needs --lesson too")
        ->type_name("FILE");
    app.add_option("--ghost", arguments.desktop.ghost, "Show the torch of this attempt or torch path beside yours")
        ->type_name("FILE");
    app.add_option_function<std::string>(
           "--person", [&arguments](const std::string& name) { arguments.desktop.person = name; },
           "Name of the person who welds: scores and help are theirs")
        ->type_name("NAME");
    app.add_flag("--no-recording", arguments.unrecorded, "Keep no recordings of attempts");
    CLI::Option* wanted = app.add_flag("--headset", arguments.headset,
                                       "Use the headset; without one the program ends and names the reason");
    app.add_flag("--desktop", arguments.desktopOnly, "Do not search for a headset")->excludes(wanted);
#ifdef __linux__
    app.add_flag(kErrorWindow, arguments.errorWindow,
                 "Show the reason for an early end in a window too, as the menu entry does");
#endif
    app.add_flag("--watch-shaders", arguments.desktop.watchShaders, "Reload changed shaders while the window is open");
}

void addRun(CLI::App& app, Arguments& arguments) {
    CLI::App* run = app.add_subcommand("run", "Run a lesson's demonstration without a screen");
    RunRequest& r = arguments.run;
    run->add_option("LESSON", r.lesson, "Name of a lesson (meltpool lessons) or a TOML file")->required();
    run->add_option("--out", r.folder,
                    "Folder for result.json, telemetry.csv and pictures; without it a new one here, such as "
                    "meltpool-classic")
        ->type_name("DIR");
    run->add_option("--torch", r.torch, "Torch path, .csv or .toml, instead of the lesson's")->type_name("FILE");
    run->add_option("--ghost", r.ghost, "Draw the torch of this attempt or torch path beside the lesson's")
        ->type_name("FILE");
    run->add_option("--seconds", r.seconds, "Simulated time, s")->type_name("S");
    run->add_option("--pictures", r.picturesEvery, "Time between pictures, s; 0: one at the end")->type_name("EVERY_S");
    run->add_option("--size", r.size, "Size of the pictures, pixels")->type_name("WxH");
    run->add_option("--sound", r.sound, "Write the sound of the weld into this WAV file")->type_name("FILE");
    run->add_option("--mesh", r.mesh, "Write the surface of the metal at the end here: .glb, .gltf or .ply")
        ->type_name("FILE");
    run->add_flag("--video", r.video,
                  "Make a time-lapse of the pictures' size: video.mp4 if ffmpeg is in PATH, else video-000000.png, ..");
    run->add_option("--video-rate", r.videoRate, "Pictures per second of the time-lapse; by default 30")
        ->type_name("N");
    run->add_option("--video-speed", r.videoSpeed, "Simulated seconds per second of the time-lapse; by default 4")
        ->type_name("TIMES");
    run->add_option("--turntable", r.turntable,
                    "Take this many pictures round the finished piece: turntable-000.png, ..")
        ->type_name("N");
    run->add_option("--set", r.sets, "Set a value (meltpool lessons LESSON); may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void addRecordings(CLI::App& app, RecordingsRequest& r) {
    CLI::App* recordings = app.add_subcommand("recordings", "List the recordings of attempts, or look into one");
    recordings->add_option("--folder", r.folder, "Folder of recordings; by default the user's")->type_name("FOLDER");
    CLI::Option* table = recordings->add_option(
        "--csv", r.table, "Write one table of all attempts with their results; FILE OUT: the steps of one recording");
    table->type_name("[FILE] OUT")->expected(1, 2);
    recordings->add_flag("--json", r.json, "Print the list as JSON")->excludes(table);
    recordings->add_option("--check", r.checked, "Say how much of a recording is whole")
        ->type_name("FILE")
        ->excludes(table);
}

void addResultPlace(CLI::App& command, ResultPlace& place) {
    CLI::Option* file = command.add_option("--json", place.named, "Write the results into this file");
    file->type_name("FILE");
    command
        .add_option("--results", place.folder, "Write the results into FOLDER/MACHINE/COMMIT-NAME.json, for 'history'")
        ->type_name("FOLDER")
        ->excludes(file);
}

void addOthers(CLI::App& app, Arguments& arguments) {
    CLI::App* bench = app.add_subcommand("bench", "Measure the speed of this machine");
    std::string suites = "Suite; by default all";
    for (const BenchPart& part : benchParts())
        suites += "\n" + std::string(part.suite) + ": " + std::string(part.note);
    bench->add_option("SUITE", arguments.suite, suites);
    addResultPlace(*bench, arguments.benchResults);
    CLI::App* validate = app.add_subcommand("validate", "Compare the metal with exact solutions and experiments");
    validate->add_option("CASE", arguments.validation.cases,
                         "Case files (.toml) or folders of them; by default all shipped ones");
    addResultPlace(*validate, arguments.validation.results);
    validate
        ->add_option("--voltage-offset", arguments.validation.voltageOffset,
                     "V added to welds at a chart's values, such as -4")
        ->type_name("V");
    validate
        ->add_option("--speed-factor", arguments.validation.speedFactor,
                     "Travel speed of welds at a chart's values, times the chart's, such as 2")
        ->type_name("FACTOR");
    CLI::App* history = app.add_subcommand("history", "Draw results of bench and validate over time, as one HTML page");
    history->add_option("FOLDER", arguments.history.folder, "Folder that --results of bench and validate has filled")
        ->required();
    history->add_option("--out", arguments.history.page, "The page; by default history.html")->type_name("FILE");
    CLI::App* check =
        app.add_subcommand("check", "Weld lessons and compare score, verdict and weld with expected values");
    check
        ->add_option("CHECK", arguments.check.checks,
                     "Files (.toml) with a table [expect], folders of them, or names of such lessons")
        ->required();
    check->add_option("--junit", arguments.check.junit, "Write the results into this file")->type_name("FILE");
    CLI::App* report = app.add_subcommand("report", "Make one HTML page of each attempt");
    report->add_option("DIR", arguments.report.sources, "Folder of a run, or an attempt's record (.csv)")->required();
    report
        ->add_option("--out", arguments.report.page,
                     "The page; by default report.html in the folder, or beside the record under its name")
        ->type_name("FILE");
    report
        ->add_option("--lesson", arguments.report.lesson,
                     "Lesson of the records, a TOML file, if it is not in the catalogue")
        ->type_name("LESSON");
    addRecordings(app, arguments.recordings);
    app.add_subcommand("doctor", "List the parts that this computer has, and missing ones with their cure")
        ->add_flag("--speed", arguments.speed, "Weld for ten seconds and advise a particle spacing");
    CLI::App* lessons = app.add_subcommand("lessons", "List the lessons, or the values of one");
    lessons->add_option("LESSON", arguments.listed, "List the parameters of this lesson that --set takes");
    lessons->add_flag("--json", arguments.listedAsJson, "Print the list as JSON");
    CLI::App* completion =
        app.add_subcommand("completion", "Print the script by which a shell completes this command line");
    completion->add_option("SHELL", arguments.shell, "bash, zsh or fish")->required();
    completion->add_option("WORD", arguments.completed)->group(""); // hidden; completion scripts use it
    app.add_subcommand("manual", "Print the manual page, which 'man -l -' shows");
}

/// Throws before the window opens if no person can have this name.
std::string checkedPerson(const std::string& name) {
    try {
        return personName(name);
    } catch (const InputError& fault) {
        throw InputError(std::string("--person: ") + fault.what());
    }
}

DesktopOptions trainerOptions(const Arguments& arguments) {
    DesktopOptions options = arguments.desktop;
    if (arguments.headset) options.headset = HeadsetUse::wanted;
    options.recordings = !arguments.unrecorded;
    if (options.person) options.person = checkedPerson(*options.person);
    if (arguments.desktopOnly) options.headset = HeadsetUse::off;
    return options;
}

int runLessons(const Arguments& arguments) {
    if (arguments.listed.empty()) return listLessons(arguments.listedAsJson) ? kDone : kBadInput;
    listParameters(arguments.listed, arguments.listedAsJson);
    return kDone;
}

void printLessonNames() {
    for (const NamedLesson& each : LessonFolders::ofUser().list())
        if (each.fault.empty()) std::printf("%s\n", printable(each.key, 300).c_str());
}

/// Prints "KEY=" of each value of the lesson that `words` name; no-op if they name none.
void printLessonKeys(const std::vector<std::string>& words) {
    const LessonFolders folders = LessonFolders::ofUser();
    for (const std::string& word : words)
        try {
            Lesson lesson = findLesson(word, folders);
            for (const Parameter& each : lesson.parameters())
                std::printf("%s=\n", std::string(each.key).c_str());
            return;
        } catch (const InputError&) {
            continue; // an option, or a file of another kind
        }
}

/// Prints the script itself, or the lines that a script asks for: `completion lessons`, `completion keys -- WORD..`.
void printCompletion(const CLI::App& app, const Arguments& arguments) {
    if (arguments.shell == "lessons")
        printLessonNames();
    else if (arguments.shell == "keys")
        printLessonKeys(arguments.completed);
    else
        std::fputs(completionScript(app, arguments.shell).c_str(), stdout);
}

int dispatch(const CLI::App& app, const Arguments& arguments) {
    if (app.got_subcommand("run"))
        runLesson(arguments.run);
    else if (app.got_subcommand("bench"))
        runBench(arguments.suite, arguments.benchResults);
    else if (app.got_subcommand("validate"))
        return runValidation(arguments.validation) ? kDone : kFailed;
    else if (app.got_subcommand("check"))
        return runChecks(arguments.check) ? kDone : kFailed;
    else if (app.got_subcommand("report"))
        writeReports(arguments.report);
    else if (app.got_subcommand("history"))
        writeHistory(arguments.history);
    else if (app.got_subcommand("recordings"))
        return runRecordings(arguments.recordings) ? kDone : kFailed;
    else if (app.got_subcommand("doctor"))
        return runDoctor(arguments.speed) ? kDone : kFailed;
    else if (app.got_subcommand("lessons"))
        return runLessons(arguments);
    else if (app.got_subcommand("completion"))
        printCompletion(app, arguments);
    else if (app.got_subcommand("manual"))
        std::fputs(manualPage(app).c_str(), stdout);
    else if (!runAttemptCommand(app, arguments.attempts))
        return runTrainer(trainerOptions(arguments)) ? kDone : kFailed;
    return kDone;
}

/// Prints one line on standard error.
void complain(const std::string& sentence) {
    constexpr size_t kMostBytes = 3000;
    std::fprintf(stderr, "meltpool: %s\n", printable(sentence, kMostBytes).c_str());
}

/// Ignores the signals of a file beyond the size limit and a pipe without a reader: they would end the program and lose
/// its data. The failing write reports the fault instead.
void tellWritesOfTheirFaults() {
#ifndef _WIN32
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

/// Throws for an option of the trainer's window before another command, which would ignore it.
void refuseForeignOptions(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    if (commands.empty()) return;
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0)
            throw InputError(option->get_name() + " is an option of the trainer's window, which '" +
                             commands.front()->get_name() + "' does not open; expected what 'meltpool " +
                             commands.front()->get_name() + " --help' shows");
}

/// Throws RuntimeFault if standard output did not take everything, unless its reader closed it.
void requireOutput() {
    errno = 0;
    std::cout.flush();
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
    const int code = errno;
    if (!written && !isPipe(stdout))
        throw RuntimeFault(
            std::string("standard output cannot be written to its end") +
            (code != 0 ? std::string(": ") + std::strerror(code) : std::string()) + "; " +
            (code == 0 || code == EPIPE ? "expected a reader that reads to the end" : writeExpectation(code)));
}

/// Text of the program's --help below its commands.
std::string footer() {
    const auto list = [](const char* heading, std::span<const NamedText> texts) {
        std::string lines = std::string(heading) + ":\n";
        for (const NamedText& each : texts)
            lines += "  " + std::string(each.name) +
                     std::string(each.name.size() < 26 ? 26 - each.name.size() : 1, ' ') + "  " +
                     std::string(each.text) + "\n";
        return lines;
    };
    return list("Exit codes", kExitCodes) + "\n" + list("Environment", kVariables);
}

/// Declares options and commands, whose values go into `arguments`.
void declare(CLI::App& app, Arguments& arguments) {
    app.set_version_flag("--version", "meltpool " + programBuild());
    app.require_subcommand(0, 1);
    app.allow_windows_style_options(false); // a path may begin with a slash on Windows too
    addDesktop(app, arguments);
    addRun(app, arguments);
    addAttemptCommands(app, arguments.attempts);
    addOthers(app, arguments);
    for (const char* command :
         {"run", "replay", "compare", "demonstration", "check", "report", "history", "recordings", "validate"})
        app.get_subcommand(command)->add_flag("--quiet", arguments.quiet,
                                              "Print only errors, and the path of the result");
    app.footer(footer()); // last: commands would inherit it
}

/// Command that was given, or else the program itself.
const CLI::App& givenCommand(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

/// Command or option of `command` of which a refused word is a misspelling; empty if there is none.
std::string likelyWord(const CLI::App& command, const std::string& refused) {
    std::vector<std::string> known;
    if (refused.starts_with("-")) {
        for (const CLI::Option* option : command.get_options())
            for (const std::string& name : option->get_lnames())
                known.push_back("--" + name);
    } else {
        for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; }))
            known.push_back(each->get_name());
    }
    return likelyName(std::string_view(refused).substr(0, refused.find('=')), known);
}

/// Sentence for an option without its value; empty if the error is another one.
std::string missingValue(const CLI::App& command, const std::string& error) {
    const std::string name = error.substr(0, error.find(':'));
    const CLI::Option* option = error.ends_with(" missing") ? command.get_option_no_throw(name) : nullptr;
    if (option == nullptr) return {};
    std::string text = option->get_description();
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return name + " has no value; expected " + name + " " + option->get_type_name() + ": " + text;
}

/// Sentence for a command line that CLI11 refuses.
std::string refusal(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = givenCommand(app);
    if (const std::string text = missingValue(command, error.what()); !text.empty()) return text;
    const std::string said = printable(error.what(), 400);
    const std::vector<std::string> refused = app.remaining(true);
    const std::string likely = refused.empty() ? std::string() : likelyWord(command, refused.front());
    return said + (likely.empty() ? "; expected" : "; did you mean " + quote(likely) + "? Expected") +
           " what 'meltpool " + (&command == &app ? "" : command.get_name() + " ") + "--help' shows" +
           (said.starts_with("LESSON ") ? ", and a name that 'meltpool lessons' lists" : "");
}

/// Throws CLI::Success for a request for help or version, InputError for an invalid command line.
void parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success&) {
        throw;
    } catch (const CLI::ParseError& error) {
        throw InputError(refusal(app, error));
    }
    refuseForeignOptions(app);
}

constexpr const char* kDescription =
    "Meltpool, a virtual welding trainer. Without a command it opens the trainer's window.";

int parseAndRun(int argc, char** argv) {
    CLI::App app(kDescription, "meltpool");
    Arguments arguments;
    declare(app, arguments);
    int code = kDone;
    try {
        parse(app, argc, argv);
        if (arguments.quiet) beQuiet();
        code = dispatch(app, arguments);
    } catch (const CLI::Success& help) {
        app.exit(help);
    }
    requireOutput();
    return code;
}

#ifdef __linux__
/// Runs the program in a process of its own, so that its crash is shown too.
int runForIcon(const std::vector<std::string>& words) {
    const WatchedEnd end = runWatched(words);
    if (const std::string sentence = endSentence(end); !sentence.empty()) showErrorWindow(sentence);
    return end.code;
}
#endif

} // namespace

int runProgram(int argc, char** argv) {
    giveLargeBlocksBack();
    tellWritesOfTheirFaults();
    OpenAlDevice::quietLibrary();
    try {
#ifdef __linux__
        if (const auto words = withoutOption(argc, argv, kErrorWindow)) return runForIcon(*words);
#endif
        chooseUsersLanguage();
        return parseAndRun(argc, argv);
    } catch (const InputError& error) {
        complain(error.what());
        return kBadInput;
    } catch (const std::exception& error) {
        complain(error.what());
        return kFailed;
    }
}

void checkCommandLine(std::span<const std::string> words) {
    CLI::App app(kDescription, "meltpool");
    Arguments arguments;
    declare(app, arguments);
    std::vector<const char*> pointers{"meltpool"};
    for (const std::string& word : words)
        pointers.push_back(word.c_str());
    try {
        parse(app, static_cast<int>(pointers.size()), pointers.data());
    } catch (const CLI::Success&) {
        return;
    }
    if (app.got_subcommand("run")) requestedLesson(arguments.run);
}

} // namespace meltpool
