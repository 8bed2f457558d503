#include "app/commands/command_line.hpp"

#include "app/bench/bench.hpp"
#include "app/commands/commands.hpp"
#include "app/program/program_info.hpp"
#include "core/base/error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace meltpool {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadInput = 2;

/// The parsed command line.
struct Words {
    RunRequest run;
    DesktopOptions desktop;
    bool headset = false;
    bool desktopOnly = false;
    std::string suite;
    std::filesystem::path benchJson;
    ValidationRequest validation;
    std::string listed; ///< lesson whose values are listed; empty: the catalogue
};

void addDesktop(CLI::App& app, Words& words) {
    app.add_option("--lesson", words.desktop.lesson, "The window's lesson: a name of the catalogue or a TOML file");
    app.add_option("--telemetry", words.desktop.telemetry, "The window writes what it does here, JSON a line")
        ->type_name("FILE");
    app.add_option("--record", words.desktop.record, "Write every step of the lesson here, as a torch path")
        ->type_name("FILE");
    CLI::Option* wanted =
        app.add_flag("--headset", words.headset, "Use the headset; end with the reason where there is none");
    app.add_flag("--desktop", words.desktopOnly, "Look for no headset")->excludes(wanted);
    app.add_flag("--watch-shaders", words.desktop.watchShaders, "Reload changed shaders while the window is open");
}

void addRun(CLI::App& app, Words& words) {
    CLI::App* run = app.add_subcommand("run", "Run a lesson's demonstration without a screen");
    RunRequest& r = words.run;
    run->add_option("LESSON", r.lesson, "Name of a lesson (meltpool lessons) or a TOML file")->required();
    run->add_option("--out", r.folder, "Folder for result.json, telemetry.csv and pictures")
        ->required()
        ->type_name("DIR");
    run->add_option("--torch", r.torch, "Torch path, .csv or .toml, instead of the lesson's")->type_name("FILE");
    run->add_option("--seconds", r.seconds, "Simulated time, s")->type_name("S");
    run->add_option("--pictures", r.picturesEvery, "Time between pictures, s; 0: one at the end")->type_name("EVERY_S");
    run->add_option("--size", r.size, "Size of the pictures, pixels")->type_name("WxH");
    run->add_option("--set", r.sets, "Set a value (meltpool lessons LESSON); may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void addOthers(CLI::App& app, Words& words) {
    CLI::App* bench = app.add_subcommand("bench", "Measure the speed of this machine");
    std::string suites = "Suite; all where none is named";
    for (const BenchPart& part : benchParts())
        suites += "\n" + std::string(part.suite) + ": " + std::string(part.note);
    bench->add_option("SUITE", words.suite, suites);
    bench->add_option("--json", words.benchJson, "Keep the rows in this file")->type_name("FILE");
    CLI::App* validate = app.add_subcommand("validate", "Hold the metal against exact solutions and experiments");
    validate->add_option("CASE", words.validation.cases, "Case files, .toml; all that ship where none is named");
    validate->add_option("--json", words.validation.json, "Keep the numbers in this file")->type_name("FILE");
    app.add_subcommand("doctor", "Tell what this machine has and what is missing");
    CLI::App* lessons = app.add_subcommand("lessons", "List the lessons, or the values of one");
    lessons->add_option("LESSON", words.listed, "List what --set can set in this lesson");
}

DesktopOptions trainerOptions(const Words& words) {
    DesktopOptions options = words.desktop;
    if (words.headset) options.headset = HeadsetUse::wanted;
    if (words.desktopOnly) options.headset = HeadsetUse::off;
    return options;
}

int dispatch(const CLI::App& app, const Words& words) {
    if (app.got_subcommand("run"))
        runLesson(words.run);
    else if (app.got_subcommand("bench"))
        runBench(words.suite, words.benchJson);
    else if (app.got_subcommand("validate"))
        return runValidation(words.validation) ? kDone : kFailed;
    else if (app.got_subcommand("doctor"))
        return runDoctor() ? kDone : kFailed;
    else if (app.got_subcommand("lessons"))
        words.listed.empty() ? listLessons() : listParameters(words.listed);
    else
        runTrainer(trainerOptions(words));
    return kDone;
}

/// One line on standard error.
void complain(std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::fprintf(stderr, "meltpool: %s\n", sentence.c_str());
}

int parseAndRun(int argc, char** argv) {
    CLI::App app("Meltpool, a virtual welding trainer. Without a command it opens the trainer's window.", "meltpool");
    app.set_version_flag("--version",
                         "meltpool " + std::string(programVersion()) + " (" + std::string(programCommit()) + ")");
    app.require_subcommand(0, 1);
    Words words;
    addDesktop(app, words);
    addRun(app, words);
    addOthers(app, words);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        complain(std::string(error.what()) + "; expected what 'meltpool --help' shows");
        return kBadInput;
    }
    return dispatch(app, words);
}

} // namespace

int runProgram(int argc, char** argv) {
    try {
        return parseAndRun(argc, argv);
    } catch (const InputError& error) {
        complain(error.what());
        return kBadInput;
    } catch (const std::exception& error) {
        complain(error.what());
        return kFailed;
    }
}

} // namespace meltpool
