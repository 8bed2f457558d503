// Tests records over resets and restarts, without a place to write, and the pace of a program that gets too little
// processor time.
#include "core/base/text.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/little_time.hpp"
#include "tests/support/newest_recording.hpp"

namespace meltpool::test {

using nlohmann::json;

namespace {

namespace fs = std::filesystem;

auto stepsPast(long long count) {
    return [count](const json& s) { return s.at("metal").at("steps") > count; };
}

std::string endOf(const fs::path& record) {
    const auto attempt = readRecordedAttempt(record);
    REQUIRE(attempt);
    CHECK(attempt->rows > 5);
    return attempt->ended;
}

bool toldSlow(const json& row) {
    return row.at("messages").dump().find("This computer is too slow") != std::string::npos;
}

/// Waits until a program with few frames keeps pace with the clock. A busy machine has no time for that: its frames
/// make more than three steps each, and a message says so; or it is too busy to judge.
void waitForFullPace(TrainerWindow& window) {
    BusyMachine machine;
    const json begin = window.state();
    const char* why = "";
    const json last = window.waitFor("few frames at full pace", [&](const json& row) {
        const double seconds = row.at("seconds").get<double>() - begin.at("seconds").get<double>();
        const double frames = row.at("frame").get<double>() - begin.at("frame").get<double>();
        const double steps = row.at("metal").at("steps").get<double>() - begin.at("metal").at("steps").get<double>();
        if (seconds < 3) return false; // the rate of frames is an average over a while
        why = "at full pace";
        if (row.at("frames_per_second") < 25 && row.at("metal").at("speed") > 0.95) return true;
        why = "the machine is busy, which is told";
        if (steps > 3 * frames && toldSlow(row)) return true;
        why = "the machine is too busy to judge";
        return machine.excuses();
    });
    WARN("few frames: " << why << "; " << last.at("frames_per_second").get<double>() << " a second, metal at "
                        << last.at("metal").at("speed").get<double>() << " of real time; a processor was free for "
                        << machine.share() << " of the time when last asked");
}

} // namespace

TEST_CASE("an attempt that cannot be recorded is told in the window, which goes on, and by the exit code") {
    TrainerWindow window("no-recording", {.environment = {{"XDG_DATA_HOME", "/proc/nowhere"}}});
    window.start();
    window.waitFor("a sentence over the picture", [](const json& s) {
        return s.at("messages").dump().find("This attempt is not recorded") != std::string::npos;
    });
    window.waitFor("some steps", stepsPast(5));
    window.closeWindow();
    CHECK(window.finish() == 1);
    CHECK_THAT(window.output(), containsText("This attempt is not recorded"));
}

TEST_CASE("a picture that cannot be saved is told in the window, which goes on, and by the exit code") {
    TrainerWindow window("no-picture", {.environment = {{"XDG_PICTURES_DIR", "/proc/nowhere"}}});
    window.start();
    window.key("F10");
    window.waitFor("a sentence over the picture",
                   [](const json& s) { return s.at("messages").dump().find("/proc/nowhere") != std::string::npos; });
    window.waitFor("some steps", stepsPast(5));
    window.closeWindow();
    CHECK(window.finish() == 1);
    CHECK_THAT(window.output(), containsText("a picture was not saved: /proc/nowhere"));
}

TEST_CASE("who wants no recordings has none") {
    TrainerWindow window("unrecorded", {.arguments = {"--no-recording"}});
    window.start();
    window.waitFor("some steps", stepsPast(5));
    window.closeWindow();
    CHECK(window.finish() == 0);
    CHECK_FALSE(fs::exists(window.recordingsFolder()));
}

TEST_CASE("Reset, Restart and the window's cross leave a whole record of each attempt") {
    const fs::path folder = scratchFolder("desk-records");
    TrainerWindow window("desk-records-window", {.arguments = {"--record", (folder / "weld.csv").string()}});
    window.start();
    window.waitFor("some steps", stepsPast(20));
    window.key("F5");
    window.waitFor("the reset", [](const json& s) { return s.at("metal").at("steps") < 20; });
    window.waitFor("some steps", stepsPast(20));
    window.click("bar.restart");
    window.waitFor("the start menu", [](const json& s) { return s.at("page") == "start"; });
    window.start();
    window.waitFor("some steps", stepsPast(20));
    window.closeWindow();
    CHECK(window.finish() == 0);
    CHECK(endOf(folder / "weld.csv") == "reset");
    CHECK(endOf(folder / "weld-2.csv") == "start menu");
    CHECK(endOf(folder / "weld-3.csv") == "the program ended");
    // Every attempt has a recording without a request, with the end of its record.
    std::vector<std::string> ended;
    for (const fs::path& file : recordingsIn(window.recordingsFolder())) {
        const auto attempt = readRecordedAttempt(file);
        REQUIRE(attempt);
        ended.push_back(attempt->ended);
    }
    CHECK(ended == std::vector<std::string>{"reset", "start menu", "the program ended"});
    CHECK(readRecordedAttempt(recordingsIn(window.recordingsFolder())[1])->stateHash ==
          readRecordedAttempt(folder / "weld-2.csv")->stateHash);
}

TEST_CASE("a record that cannot be written is asked about; the exit code tells of the attempt without one") {
    TrainerWindow window("no-record", {.arguments = {"--record", "/proc/nowhere/weld.csv"}});
    window.click("start.start");
    window.waitFor("the question", [](const json& s) { return s.at("places").contains("question.1"); });
    window.takePicture("question");
    CHECK(window.settle().at("metal").at("steps") == 0);
    SECTION("without a record") {
        window.click("question.0");
        window.waitFor("some steps", stepsPast(5));
        window.closeWindow();
        CHECK(window.finish() == 1);
        CHECK(window.output().find("was not recorded") != std::string::npos);
    }
    SECTION("not at all") {
        window.click("question.1");
        window.waitFor("the start menu", [](const json& s) { return s.at("page") == "start"; });
        window.closeWindow();
        CHECK(window.finish() == 0);
    }
}

TEST_CASE("at twelve frames a second the metal keeps the clock; on a machine that is too slow the record says so") {
    const fs::path folder = scratchFolder("desk-pace");
    TrainerWindow window("desk-pace-window", {.arguments = {"--record", (folder / "weld.csv").string()}});
    window.start();
    window.waitFor("some steps", stepsPast(20));
    const auto signal = [&](int number) { window.process().signal(number); };
    {
        const LittleTime fewFrames(signal, 0.085, 0.06);
        waitForFullPace(window);
    }
    {
        const LittleTime slow(signal, 1.2, 1.0);
        window.waitFor("a slow metal, and a sentence about it over the picture",
                       [](const json& s) { return toldSlow(s) && s.at("metal").at("speed") < 0.8; });
    }
    window.closeWindow();
    CHECK(window.finish() == 0);
    const auto attempt = readRecordedAttempt(folder / "weld.csv");
    REQUIRE(attempt);
    REQUIRE(attempt->realTime);
    CHECK(*attempt->realTime < 1);
    CHECK(readTextFile(folder / "weld.csv").find("# least_real_time 0.") != std::string::npos);
}

} // namespace meltpool::test
