#include "app/commands/attempt_options.hpp"

#include <CLI/CLI.hpp>

namespace meltpool {

namespace {

constexpr const char* kFile = "Record of an attempt, written by the trainer or a run";
constexpr const char* kLesson = "Name or TOML file of the attempt's lesson, if it is not in the catalogue";

void addReplay(CLI::App& app, AttemptArguments& arguments) {
    ReplayRequest& r = arguments.replay;
    CLI::App* replay =
        app.add_subcommand("replay", "Weld a recorded attempt again, as it was or with one thing changed");
    replay->add_option("FILE", r.file, kFile)->required();
    replay->add_option("--out", r.folder, "Folder for result.json, telemetry.csv, pictures and the page of a what-if")
        ->required()
        ->type_name("DIR");
    replay->add_option("--lesson", r.lesson, kLesson)->type_name("LESSON");
    replay->add_option("--seek", r.seek, "Weld to this second, take its picture and go no further")->type_name("S");
    replay->add_option("--pictures", r.picturesEvery, "Time between pictures, s; 0: one at the end")
        ->type_name("EVERY_S");
    replay->add_option("--size", r.size, "Size of the pictures, pixels")->type_name("WxH");
    replay->add_option("--view", r.views, "Set what pictures show, such as azimuth=90; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    replay
        ->add_option(
            "--what-if", r.whatIf,
            "Weld it a second time with this changed: speed (0.8, or 6mm/s), arc_length or stick_out (mm more), "
            "work_angle or travel_angle (degrees more), stillness (0 to 1), or a value of the lesson; may be "
            "given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    replay->add_flag("--no-page", arguments.noPage, "Do not write comparison.html");
}

void addCompare(CLI::App& app, AttemptArguments& arguments) {
    CompareRequest& c = arguments.compare;
    CLI::App* compare = app.add_subcommand("compare", "Say how two attempts differ, and make a page of both");
    constexpr const char* kSide = "Record of an attempt, which is welded again, or the folder of a run";
    compare->add_option("A", c.first, kSide)->required();
    compare->add_option("B", c.second, kSide)->required();
    compare->add_option("--out", c.folder, "Folder for comparison.html and the welded attempts")
        ->required()
        ->type_name("DIR");
    compare->add_option("--lesson", c.lesson, kLesson)->type_name("LESSON");
    compare
        ->add_option("--pictures", c.picturesEvery,
                     "Time between pictures of the welded attempts, s; 0: one at the end")
        ->type_name("EVERY_S");
    compare->add_option("--size", c.size, "Size of the pictures, pixels")->type_name("WxH");
    compare->add_flag("--no-page", arguments.noPage, "Do not write comparison.html");
}

void addDemonstration(CLI::App& app, AttemptArguments& arguments) {
    DemonstrationRequest& d = arguments.demonstration;
    CLI::App* demonstration =
        app.add_subcommand("demonstration", "Make a recorded attempt the demonstration of a lesson");
    demonstration->add_option("FILE", d.file, kFile)->required();
    demonstration->add_option("--out", d.out, "X.csv: the torch path; X.toml: a lesson, and its path X.csv beside it")
        ->required()
        ->type_name("FILE");
    demonstration->add_option("--lesson", d.lesson, kLesson)->type_name("LESSON");
}

} // namespace

void addAttemptCommands(CLI::App& app, AttemptArguments& arguments) {
    addReplay(app, arguments);
    addCompare(app, arguments);
    addDemonstration(app, arguments);
}

bool runAttemptCommand(const CLI::App& app, const AttemptArguments& arguments) {
    if (app.got_subcommand("replay")) {
        ReplayRequest request = arguments.replay;
        request.page = !arguments.noPage;
        replayAttempt(request);
        return true;
    }
    if (app.got_subcommand("compare")) {
        CompareRequest request = arguments.compare;
        request.page = !arguments.noPage;
        compareAttemptFiles(request);
        return true;
    }
    if (app.got_subcommand("demonstration")) {
        makeDemonstration(arguments.demonstration);
        return true;
    }
    return false;
}

} // namespace meltpool
