// Files that people bring to the program: foreign torch paths, implausible paths, incomplete lessons, attempts that
// cannot be compared, and an output that is cut off.
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A weld that a software driver finishes in seconds.
const std::string kQuickWeld = "run gmaw-bead --size 160x120 --pictures 0 --seconds 0.25 --set length_mm=24 "
                               "--set width_mm=20 --set thickness_mm=4 --set cells=24 --torch '";

std::string brought(const char* name) {
    return (test::testFolder() / "data" / "brought" / name).string();
}

Json resultIn(const fs::path& folder) {
    return Json::parse(readTextFile(folder / "result.json"));
}

/// Writes as much of a run's folder as a comparison reads.
void writeRun(const fs::path& folder, const std::string& lesson) {
    fs::create_directories(folder);
    writeTextFileAtomically(folder / "result.json", R"({"lesson": ")" + lesson + R"(", "finished": true})");
}

} // namespace

TEST_CASE("a run tells how it reads somebody's torch path, and the result says so too", "[app]") {
    const auto folder = test::scratchFolder("brought");
    const test::Outcome outcome =
        runMeltpool(kQuickWeld + brought("excel-german.csv") + "' --out '" + folder.string() + "'");
    INFO(outcome.errors);
    CHECK(outcome.code == 0);
    CHECK(outcome.errors.empty());
    CHECK_THAT(outcome.output, containsText("excel-german.csv is read as Windows-1252, columns separated by "
                                            "semicolons, decimal comma, times in s."));
    const Json form = resultIn(folder).at("torch_form");
    CHECK(form.at("encoding") == "Windows-1252");
    CHECK(form.at("separator") == ";");
    CHECK(form.at("decimal_comma") == true);
    CHECK(form.at("time_unit") == "s");
    CHECK(form.at("rows_without_pose") == 0);
    CHECK(resultIn(folder).at("max_temperature_c") > 1450);
    CHECK_FALSE(resultIn(folder).contains("warnings"));
}

TEST_CASE("rows without a pose are a lost torch in the record, which repeats bit by bit", "[app]") {
    const auto folder = test::scratchFolder("unseen");
    const test::Outcome first =
        runMeltpool(kQuickWeld + brought("motion-capture.tsv") + "' --out '" + (folder / "first").string() + "'");
    INFO(first.errors);
    REQUIRE(first.code == 0);
    const std::string record = readTextFile(folder / "first" / "telemetry.csv");
    CHECK_THAT(record, containsText("# event torch lost") && containsText("# event torch seen"));
    CHECK(resultIn(folder / "first").at("torch_form").at("rows_without_pose") == 4);
    fs::copy_file(folder / "first" / "telemetry.csv", folder / "record.csv");
    const test::Outcome again =
        runMeltpool("run gmaw-bead --size 160x120 --pictures 0 --set cells=24 --torch '" +
                    (folder / "record.csv").string() + "' --out '" + (folder / "again").string() + "'");
    INFO(again.errors);
    REQUIRE(again.code == 0);
    CHECK(resultIn(folder / "again").at("state_hash") == resultIn(folder / "first").at("state_hash"));
    CHECK_FALSE(resultIn(folder / "again").contains("torch_form")); // records need no guess
}

TEST_CASE("a run that can weld nothing says so on the terminal and in its result", "[app]") {
    const auto folder = test::scratchFolder("implausible");
    std::string text = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n";
    for (int i = 0; i < 10; ++i)
        text += formatNumber(0.02 * i) + ",1250,400,800,-0.7071,0,0,0.7071,1\n";
    writeTextFileAtomically(folder / "robot.csv", text);
    const test::Outcome far =
        runMeltpool(kQuickWeld + (folder / "robot.csv").string() + "' --out '" + (folder / "far").string() + "'");
    CHECK(far.code == 0);
    CHECK_THAT(far.errors, containsText("meltpool: warning: The torch path robot.csv is wholly outside"));
    REQUIRE(resultIn(folder / "far").at("warnings").size() == 1);
    CHECK_THAT(resultIn(folder / "far").at("warnings")[0].get<std::string>(), containsText("wholly outside"));

    // The path is over the plate but too far for an arc, so only the end of the run shows the fault.
    writeTextFileAtomically(folder / "high.toml", "start_mm = [0, 25, 0]\n[[move]]\nkind = 'arc_on'\n"
                                                  "[[move]]\nkind = 'line'\nto_mm = [5, 25, 0]\nspeed_mm_s = 20\n");
    const test::Outcome high =
        runMeltpool(kQuickWeld + (folder / "high.toml").string() + "' --out '" + (folder / "high").string() + "'");
    CHECK(high.code == 0);
    CHECK_THAT(high.errors, containsText("meltpool: warning: The arc of 'gmaw-bead' was never lit"));
    CHECK_THAT(resultIn(folder / "high").at("warnings")[0].get<std::string>(), containsText("never lit"));

    // A soldering iron has no arc.
    const test::Outcome iron = runMeltpool("run solder-joint --seconds 1.5 --size 160x120 --pictures 0 --out '" +
                                           (folder / "iron").string() + "'");
    CHECK(iron.code == 0);
    CHECK(iron.errors.find("never lit") == std::string::npos);
}

TEST_CASE("a lesson that leaves something out is warned of where its values are listed", "[app]") {
    const auto folder = test::scratchFolder("left-out");
    writeTextFileAtomically(folder / "mine.toml", "next = 'solder-cub'\n");
    fs::copy_file(folder / "mine.toml", folder / "OTHER.TOML");
    CHECK(runMeltpool("lessons '" + (folder / "OTHER.TOML").string() + "'").code == 0);
    const test::Outcome outcome = runMeltpool("lessons '" + (folder / "mine.toml").string() + "'");
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.errors, containsText("meltpool: warning: The lesson mine.toml has no title") &&
                                   containsText("names 'solder-cub' as the next lesson"));
}

TEST_CASE("attempts at two lessons are not compared", "[app]") {
    const auto folder = test::scratchFolder("two-lessons");
    writeRun(folder / "one", "tee-fillet");
    writeRun(folder / "two", "gmaw-bead");
    const test::Outcome outcome =
        runMeltpool("compare '" + (folder / "one").string() + "' '" + (folder / "two").string() + "' --out '" +
                    (folder / "out").string() + "'");
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.errors, containsText("two: is of the lesson 'gmaw-bead', and ") &&
                                   containsText("of 'tee-fillet'; expected two attempts at one lesson"));
    CHECK_FALSE(fs::exists(folder / "out"));
}

TEST_CASE("a command with a part missing points to its own help", "[app]") {
    CHECK_THAT(runMeltpool("run").errors, containsText("expected what 'meltpool run --help' shows"));
    CHECK_THAT(runMeltpool("compare one").errors, containsText("expected what 'meltpool compare --help' shows"));
    CHECK_THAT(runMeltpool("fly").errors, containsText("expected what 'meltpool --help' shows"));
}

TEST_CASE("a misspelled word is answered with the word that is meant", "[app]") {
    CHECK_THAT(runMeltpool("recrodings").errors, containsText("did you mean 'recordings'? Expected what 'meltpool"));
    CHECK_THAT(runMeltpool("run gmaw-bead --ouz x").errors, containsText("did you mean '--out'? Expected what"));
    CHECK_THAT(runMeltpool("run gmaw-bead --pictrues=2").errors, containsText("did you mean '--pictures'?"));
    CHECK_THAT(runMeltpool("lessons tee-filet").errors, containsText("did you mean 'tee-fillet'? Expected one of "));
    CHECK_THAT(runMeltpool("run gmaw-bead --set votlage=20").errors, containsText("did you mean 'voltage'?"));
    CHECK(runMeltpool("run gmaw-bead --set xyzzy=20").errors.find("did you mean") == std::string::npos);
}

TEST_CASE("an option without its value says what it takes", "[app]") {
    const test::Outcome outcome = runMeltpool("recordings --csv");
    CHECK(outcome.code == 2);
    CHECK(outcome.errors == "meltpool: --csv has no value; expected --csv [FILE] OUT: write one table of all attempts "
                            "with their results; FILE OUT: the steps of one recording\n");
    CHECK_THAT(runMeltpool("run gmaw-bead --seconds").errors, containsText("expected --seconds S: simulated time, s"));
}

TEST_CASE("a reader who has read enough ends the output without a word", "[app]") {
    for (const char* arguments : {"lessons", "lessons gmaw-bead", "--help"}) {
        INFO(arguments);
        // The reader ends before the program writes.
        const test::Outcome outcome =
            runMeltpool(arguments, "bash -c 'set -o pipefail; (sleep 0.3; exec \"$@\") | true' bash");
        CHECK(outcome.code == 0);
        CHECK(outcome.errors.empty());
    }
}

TEST_CASE("a record that a spreadsheet has saved is still the record of its attempt", "[app]") {
    const fs::path file = brought("record-saved-by-excel.csv");
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    CHECK(attempt->head.lesson == "classic");
    CHECK(attempt->rows == 2);
    CHECK(attempt->ended == "reset");
    CHECK(attempt->realTime == 0.99);
    REQUIRE(attempt->changes.size() == 1);
    CHECK(attempt->changes[0].value == "0.1");
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    takeTorch(lesson, file);
    REQUIRE(lesson.torch.samples().size() == 2);
    CHECK(lesson.torch.samples()[0].time == 0.016666668);
    CHECK(lesson.torch.form()->ours);
}
