// Tests that the window, ended without warning or by a signal in mid-lesson, leaves a complete record and recording
// with nearly all of the metal's time.
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/newest_recording.hpp"
#include "tests/support/record_check.hpp"

#include <chrono>
#include <csignal>
#include <initializer_list>
#include <random>
#include <thread>

namespace meltpool::test {

using nlohmann::json;

namespace {

/// Metal's time that may be missing in a record or a recording, s.
constexpr double kMayBeMissing = 0.2;

/// Checks that the record of an ended window is complete; `ended`: it gives the reason of the end.
void checkLeft(const TrainerWindow& window, bool ended) {
    const json last = window.state(); // last row of the program
    const RecordCheck record = checkRecord(window.folder() / "record.csv");
    for (const std::string& line : record.broken)
        UNSCOPED_INFO(line);
    CHECK(record.whole());
    CHECK(record.lastTime >= last.at("metal").at("time").get<double>() - kMayBeMissing);
    CHECK(record.ended == (ended ? "the program ended" : ""));
    const Recording recording = readRecording(newestRecording(window.recordingsFolder()));
    INFO(recording.stateSentence());
    CHECK_FALSE(recording.damaged());
    CHECK(recording.seconds() >= last.at("metal").at("time").get<double>() - kMayBeMissing);
    CHECK((recording.end ? recording.end->reason : "") == record.ended);
}

/// Starts a lesson, ends it by the signal after `seconds`, and checks its record.
void endInMidLesson(int signal, double seconds) {
    INFO("signal " << signal << " after " << seconds << " s");
    TrainerWindow window("kill", {.arguments = {"--record", "record.csv"}});
    window.start();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    window.process().signal(signal);
    const int code = window.finish();
    CHECK(code == (signal == SIGKILL ? 128 + SIGKILL : 0));
    checkLeft(window, signal != SIGKILL);
}

auto stepsPast(long long count) {
    return [count](const json& s) { return s.at("metal").at("steps") > count; };
}

void endAtRandomMoments(int count, std::initializer_list<int> signals, unsigned seed = 20) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moment(0, 2);
    for (int i = 0; i < count; ++i)
        for (const int signal : signals)
            endInMidLesson(signal, moment(random));
}

} // namespace

TEST_CASE("a killed, ended or interrupted window leaves a whole record") {
    endAtRandomMoments(2, {SIGKILL, SIGTERM, SIGINT});
}

TEST_CASE("a window whose terminal is closed ends like one that is asked to: settings and record are whole") {
    TrainerWindow window("hung-up", {.arguments = {"--record", "record.csv"}});
    window.start();
    window.waitFor("some steps", stepsPast(20));
    const std::string before = readTextFile(window.settingsFile());
    window.process().signal(SIGHUP);
    CHECK(window.finish() == 0);
    checkLeft(window, true);
    CHECK(readTextFile(window.settingsFile()) != before); // all values, not only the test's few
}

TEST_CASE("a window whose display goes away keeps settings and record, and says so") {
    VirtualDisplay display(96);
    TrainerWindow window("lost-display", {.arguments = {"--record", "record.csv"}, .display = &display});
    window.start();
    window.waitFor("some steps", stepsPast(20));
    const std::string before = readTextFile(window.settingsFile());
    display.kill();
    CHECK(window.finish() == 1);
    checkLeft(window, true);
    CHECK_THAT(window.output(), containsText("the display is gone"));
    CHECK(readTextFile(window.settingsFile()) != before);
}

TEST_CASE("a window killed at 50 random moments leaves a whole record and a whole recording", "[long]") {
    endAtRandomMoments(50, {SIGKILL}, 21);
}

TEST_CASE("a window ended or interrupted at 34 random moments leaves a whole record", "[long]") {
    endAtRandomMoments(17, {SIGTERM, SIGINT}, 22);
}

} // namespace meltpool::test
