// The program's interface for scripts and shells: lists as JSON, one table of all attempts, and silence with --quiet.
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Stores a recording of one step that began on this day; a killed program leaves no end.
void keep(const fs::path& folder, int day, const std::string& lesson, bool ended) {
    AttemptHead head = test::recordedHead(lesson);
    head.date = "2026-01-0" + std::to_string(day) + "T10:00:00+0000";
    if (day == 1) head.person = "Anna, \"A\"", head.personId = "0123456789abcdef";
    test::RecordingBytes recording;
    recording.head(head).step(test::recordedStep(1));
    if (ended) recording.end(test::recordedEnd(1));
    std::ofstream(folder / ("day-" + std::to_string(day) + ".meltrec"), std::ios::binary) << recording.bytes();
}

fs::path keptAttempts(const std::string& name) {
    const fs::path folder = test::scratchFolder(name);
    keep(folder, 1, "classic", true);
    keep(folder, 2, "a \"strange\", name", true);
    keep(folder, 3, "classic", false);
    std::ofstream(folder / "none.meltrec") << "not a recording";
    return folder;
}

constexpr const char* kShort = " --seconds 0.05 --pictures 0 --size 64x64 --set particles=64";

} // namespace

TEST_CASE("lessons and their values are listed as JSON", "[app]") {
    const fs::path own = test::scratchFolder("json-lessons") / "meltpool" / "lessons";
    fs::create_directories(own);
    writeTextFileAtomically(own / "mine.toml", "title = 'Mine'\nlevel = 3\n");
    writeTextFileAtomically(own / "wrong.toml", "titel = 'Wrong'\n");
    const std::string before = "env XDG_DATA_HOME='" + own.parent_path().parent_path().string() + "'";
    const test::Outcome outcome = runMeltpool("lessons --json", before);
    CHECK(outcome.code == 2); // one recording is unusable
    const json list = json::parse(outcome.output);
    REQUIRE(list.size() > 10);
    const json& mine = list.at(list.size() - 2);
    CHECK(mine.at("name") == "mine");
    CHECK(mine.at("origin") == "own");
    CHECK(mine.at("title") == "Mine");
    CHECK(mine.at("level") == 3);
    CHECK(mine.at("model") == "classic");
    CHECK(mine.at("fault") == "");
    CHECK(list.front().at("origin") == "shipped");
    CHECK_THAT(list.back().at("fault").get<std::string>(), containsText("wrong.toml:1: titel"));
    CHECK_THAT(outcome.errors, containsText("wrong.toml:1: titel"));

    const json values = json::parse(runMeltpool("lessons gmaw-bead --json").output);
    const auto find = [&](const std::string& key) {
        return *std::find_if(values.begin(), values.end(), [&](const json& each) { return each.at("key") == key; });
    };
    CHECK(find("length_mm").at("value") == "100");
    CHECK(find("length_mm").at("unit") == "mm");
    CHECK(find("length_mm").at("maximum").is_number());
    CHECK(find("workpiece").at("maximum").is_null());
    CHECK(find("workpiece").at("choices").size() > 3);
}

TEST_CASE("attempts are listed as JSON and as one table with their results", "[app]") {
    const fs::path folder = keptAttempts("json-recordings");
    const test::Outcome outcome = runMeltpool("recordings --json --folder '" + folder.string() + "'");
    INFO(outcome.errors);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.errors, containsText("none.meltrec"));
    const json list = json::parse(outcome.output);
    REQUIRE(list.size() == 3);
    CHECK(list[0].at("score").is_null()); // killed, and the newest one
    CHECK(list[1].at("lesson") == "a \"strange\", name");
    CHECK(list[2].at("date") == "2026-01-01T10:00:00+0000");
    CHECK(list[2].at("score") == 83.5);
    CHECK(list[2].at("verdict") == "accepted");
    CHECK(list[2].at("practice") == false);
    CHECK(list[2].at("person") == "Anna, \"A\"");
    CHECK(list[2].at("person_id") == "0123456789abcdef");
    CHECK(list[1].at("person") == "");
    CHECK(list[2].at("file") == (folder / "day-1.meltrec").string());

    const fs::path table = folder / "all.csv";
    const std::string arguments = "recordings --folder '" + folder.string() + "' --csv '" + table.string() + "'";
    const test::Outcome written = runMeltpool(arguments);
    CHECK(written.code == 0);
    CHECK_THAT(written.output, containsText("The table of 3 attempts is " + table.string()));
    const std::string text = readTextFile(table);
    const auto lines = splitText(text, '\n');
    REQUIRE(lines.size() == 5); // the head and three rows, and no text after the last line end
    CHECK(lines[0].starts_with("date,lesson,lesson_file,attempt,seconds,score,verdict,practice,"));
    CHECK_THAT(std::string(lines[1]),
               containsText("2026-01-03T10:00:00+0000,classic,,3,") && containsText(",,,no,,,,"));
    CHECK_THAT(std::string(lines[2]), containsText(",\"a \"\"strange\"\", name\",,3,"));
    CHECK_THAT(std::string(lines[3]), containsText(",83.5,accepted,no,0.75,start menu,0123456789abcdef,"));
    CHECK(lines[0].ends_with(",file,person,person_id,title,test"));
    CHECK(lines[3].ends_with("day-1.meltrec,\"Anna, \"\"A\"\"\",0123456789abcdef,,no"));
    CHECK_THAT(runMeltpool("recordings --folder '" + folder.string() + "'").output,
               containsText("day-1.meltrec  Anna, \"A\"\n"));
    CHECK(runMeltpool(arguments + " --quiet").output == table.string() + "\n");

    // A lone recording name would name the output; the recording must not be overwritten.
    const test::Outcome refused = runMeltpool("recordings --csv '" + (folder / "day-1.meltrec").string() + "'");
    CHECK(refused.code == 2);
    CHECK_THAT(refused.errors, containsText("day-1.meltrec: is a recording; expected a table's name"));
    CHECK(readRecording(folder / "day-1.meltrec").steps.size() == 1);
    const test::Outcome none = runMeltpool(arguments, "rm -f '" + folder.string() + "'/*.meltrec;");
    CHECK(none.code == 0);
    CHECK(splitText(readTextFile(table), '\n').size() == 2); // a head without rows
}

TEST_CASE("with --quiet a command says its result's path and nothing else, and errors as ever", "[app]") {
    const fs::path folder = test::scratchFolder("quiet");
    const std::string out = " --out '" + (folder / "run").string() + "'";
    const std::string run = std::string("run classic --quiet") + kShort + out;
    for (int turn = 0; turn < 2; ++turn) { // the second run has files to remove
        const test::Outcome outcome = runMeltpool(run);
        INFO(outcome.errors);
        CHECK(outcome.code == 0);
        CHECK(outcome.output == (folder / "run" / "result.json").string() + "\n");
        CHECK(outcome.errors.empty());
    }
    CHECK_THAT(runMeltpool(std::string("run classic") + kShort + out).output,
               containsText("pictures and result are in"));

    const std::string record = " '" + (folder / "run" / "telemetry.csv").string() + "'";
    const test::Outcome replay =
        runMeltpool("replay" + record + " --quiet --out '" + (folder / "again").string() + "'");
    CHECK(replay.output == (folder / "again" / "result.json").string() + "\n");
    const test::Outcome report = runMeltpool("report '" + (folder / "run").string() + "' --quiet");
    CHECK(report.output == (folder / "run" / "report.html").string() + "\n");

    const test::Outcome wrong = runMeltpool("run knitting --quiet --out '" + (folder / "none").string() + "'");
    CHECK(wrong.code == 2);
    CHECK_THAT(wrong.errors, containsText("'knitting' is not in the catalogue"));
    CHECK(wrong.output.empty());
}
