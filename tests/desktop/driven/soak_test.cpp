// Tests a person's long work with every panel open: the window lives, and its memory does not grow.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/record_check.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace meltpool::test {

using nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Returns a line of a process's status, KiB: `VmRSS` is its total, `RssAnon` its own part, `RssFile` its part of
/// files.
double statusKib(int pid, const std::string& line) {
    const std::string status = readTextFile("/proc/" + std::to_string(pid) + "/status");
    const size_t at = status.find(line + ":");
    REQUIRE(at != std::string::npos);
    return std::strtod(status.c_str() + at + line.size() + 1, nullptr);
}

void openEveryPanel(TrainerWindow& window) {
    for (const auto& [key, panel] : {std::pair{"F2", "view"}, {"F3", "simulation"}, {"F4", "timings"}}) {
        if (window.state().at("panels").at(panel) == true) continue;
        window.key(key);
        window.waitFor(panel, [name = panel](const json& s) { return s.at("panels").at(name) == true; });
    }
}

/// Does a person's turn: heats along a path, opens the help, looks from elsewhere, freezes, starts again.
void work(TrainerWindow& window, int turn) {
    window.moveMouse(480, 300);
    window.xdotool({"mousedown", "1"});
    for (int i = 0; i < 20; ++i) {
        window.moveMouse(480 + 6 * (i % 5), 300 + 3 * i);
        window.settle();
    }
    window.xdotool({"mouseup", "1"});
    for (const char* key : {"F1", "F1", "v", "v", "f", "f", "F9", "F9"}) {
        window.key(key);
        window.settle();
    }
    if (turn % 5 == 4) window.key("F5");
    window.settle();
}

/// Does a trainee's turn: watches the expert for a second of the metal's time, welds for a second, begins again.
void weld(TrainerWindow& window) {
    const auto waitForPage = [&window](const std::string& page) {
        window.waitFor("the page " + page, [page](const json& s) { return s.at("page") == page; });
    };
    const auto waitForMetal = [&window](double seconds) {
        window.waitFor("the metal", [seconds](const json& s) { return s.at("metal").at("time") > seconds; });
    };
    window.click("start.demonstration");
    waitForMetal(1);
    window.key("Return");
    window.waitFor("one's own attempt", [](const json& s) { return s.at("demonstration").is_null(); });
    window.moveMouse(440, 380);
    window.xdotool({"mousedown", "1"});
    waitForMetal(1);
    window.xdotool({"mouseup", "1"});
    window.key("F5");
    window.settle();
    window.key("h");
    waitForPage("home");
    window.click("home.lesson.gmaw-bead");
    waitForPage("start");
}

/// Samples of memory and the length of turns in the course of a soak.
struct Soak {
    std::vector<double> seconds; ///< time at the end of a turn
    std::vector<double> turns;   ///< s, length of each
    std::vector<double> kib;

    /// Returns the median of the samples between two moments.
    double median(const std::vector<double>& samples, double from, double to) const {
        std::vector<double> chosen;
        for (size_t i = 0; i < samples.size(); ++i)
            if (seconds[i] >= from && seconds[i] <= to) chosen.push_back(samples[i]);
        REQUIRE_FALSE(chosen.empty());
        std::nth_element(chosen.begin(), chosen.begin() + std::ptrdiff_t(chosen.size() / 2), chosen.end());
        return chosen[chosen.size() / 2];
    }

    /// Compares the first tenth of the time after a minute with the last; the first minute fills lasting buffers.
    /// `growth`: the allowed share of the first.
    void holds(double growth) const {
        const double end = seconds.back(), tenth = (end - 60) / 10;
        const double first = median(kib, 60, 60 + tenth), last = median(kib, end - tenth, end);
        WARN(kib.size() << " turns in " << end << " s; " << first << " KiB after a minute, " << last
                        << " KiB at the end; a turn took " << median(turns, 60, 60 + tenth) << " s, at the end "
                        << median(turns, end - tenth, end) << " s");
        CHECK(last < first * (1 + growth));
    }
};

/// Returns the length of the soak, s; MELTPOOL_SOAK_SECONDS changes it.
double lengthAsked() {
    const char* asked = std::getenv("MELTPOOL_SOAK_SECONDS");
    const double length = asked != nullptr ? std::strtod(asked, nullptr) : 600;
    REQUIRE(length >= 120);
    return length;
}

/// Takes turns for `length` seconds, at least so many.
Soak soak(TrainerWindow& window, double length, int turns, const std::function<void(int)>& turn) {
    Soak soak;
    std::ofstream course(window.folder() / "memory.csv"); // the course shows the time of any growth
    course << "s,turn_s,VmRSS_kib,RssAnon_kib,RssFile_kib\n";
    const int pid = window.process().pid();
    const auto begin = Clock::now();
    for (int i = 0; i < turns || since(begin) < length; ++i) {
        const double before = since(begin);
        turn(i);
        soak.seconds.push_back(since(begin));
        soak.turns.push_back(soak.seconds.back() - before);
        soak.kib.push_back(statusKib(pid, "VmRSS"));
        course << soak.seconds.back() << ',' << soak.turns.back() << ',' << soak.kib.back() << ','
               << statusKib(pid, "RssAnon") << ',' << statusKib(pid, "RssFile") << std::endl;
    }
    return soak;
}

/// Works for `length` seconds, at least `turns` turns, with a record.
Soak soakClassic(const std::string& name, double length, int turns) {
    TrainerWindow window(name,
                         {.settings = "[start]\nparticles = 1000\ncells = 16\n[window]\nwidth = 960\nheight = 640\n",
                          .arguments = {"--record", "record.csv"}});
    window.start();
    openEveryPanel(window);
    const Soak memory = soak(window, length, turns, [&window](int turn) { work(window, turn); });
    openEveryPanel(window); // all panels are still there
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);
    CHECK(checkRecord(window.folder() / "record.csv").whole());
    return memory;
}

} // namespace

TEST_CASE("the window bears all panels open while a person works") {
    const Soak memory = soakClassic("short-soak", 0, 3);
    CHECK(memory.kib.size() == 3);
}

TEST_CASE("the window's memory stays within 1 % while a person works for long", "[long]") {
    soakClassic("soak", lengthAsked(), 1).holds(0.01);
}

// The next flush of the steps' thread frees a lesson's remains, up to ten seconds later: samples differ by the 12 MB of
// a lesson, 5 %. A leak of a lesson a turn adds as much every half minute.
TEST_CASE("the window's memory stays within 6 % while a trainee watches and welds for long", "[long]") {
    TrainerWindow window("weld-soak", {.settings = "[window]\nwidth = 960\nheight = 640\n", .lesson = "gmaw-bead"});
    soak(window, lengthAsked(), 2, [&window](int) { weld(window); }).holds(0.06);
    window.closeWindow();
    CHECK(window.finish() == 0);
}

} // namespace meltpool::test
