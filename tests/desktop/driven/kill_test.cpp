// The window ends without warning or on a signal in mid-lesson: the record is whole and nearly all of the metal's time
// is in it.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/record_check.hpp"

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

namespace meltpool::test {

using nlohmann::json;

namespace {

/// s of the metal's time that may be missing in a record.
constexpr double kMayBeMissing = 0.2;

/// The record of an ended window is whole; `ended`: it says why it ended.
void checkLeft(const TrainerWindow& window, bool ended) {
    const json last = window.state(); // what the program told last
    const RecordCheck record = checkRecord(window.folder() / "record.csv");
    for (const std::string& line : record.broken)
        UNSCOPED_INFO(line);
    CHECK(record.whole());
    CHECK(record.lastTime >= last.at("metal").at("time").get<double>() - kMayBeMissing);
    CHECK(record.ended == (ended ? "the program ended" : ""));
}

/// Starts a lesson, ends it by the signal after `seconds`, and looks at its record.
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

void endAtRandomMoments(int count) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> moment(0, 2);
    for (int i = 0; i < count; ++i)
        for (const int signal : {SIGKILL, SIGTERM, SIGINT})
            endInMidLesson(signal, moment(random));
}

} // namespace

TEST_CASE("a killed, ended or interrupted window leaves a whole record") {
    endAtRandomMoments(2);
}

TEST_CASE("a window whose terminal is closed ends like one that is asked to: settings and record are whole") {
    TrainerWindow window("hung-up", {.arguments = {"--record", "record.csv"}});
    window.start();
    window.waitFor("some steps", stepsPast(20));
    const std::string before = readTextFile(window.settingsFile());
    window.process().signal(SIGHUP);
    CHECK(window.finish() == 0);
    checkLeft(window, true);
    CHECK(readTextFile(window.settingsFile()) != before); // all values, no longer the test's few
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

TEST_CASE("a window killed, ended or interrupted at 51 random moments leaves a whole record", "[long]") {
    endAtRandomMoments(17);
}

} // namespace meltpool::test
