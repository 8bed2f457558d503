// Runs that are killed or asked to stop at any moment: what they leave is whole and tells what happened.
#include "app/program/stop_signals.hpp"
#include "core/base/image.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <functional>
#include <random>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Milliseconds = std::chrono::milliseconds;

constexpr int kKilled = 128; ///< more than this: the number of the signal that ended it

/// Runs `work` in a process of its own, sends it the signals, each after its time, and answers how it ended.
int endOf(const std::function<void()>& work, const std::vector<std::pair<Milliseconds, int>>& signals) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGHUP, SIG_DFL); // the tests may run under nohup, which children inherit
        work();
        _exit(99);
    }
    for (const auto& [after, signal] : signals) {
        std::this_thread::sleep_for(after);
        kill(child, signal);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status);
}

void runProgramQuietly(const std::vector<std::string>& words, const char* output = "/dev/null") {
    const std::string program = (fs::path(MELTPOOL_BINARY_FOLDER) / "bin" / "meltpool").string();
    std::vector<char*> arguments{const_cast<char*>(program.c_str())};
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int file = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execv(program.c_str(), arguments.data());
}

std::vector<std::string> runInto(const fs::path& folder) {
    return {"run",           "classic",    "--size", "32x24",     "--set", "cells=24", "--set",
            "particles=512", "--pictures", "0.1",    "--seconds", "3600",  "--out",    folder.string()};
}

/// The time of the last picture, s, all of which must be whole; 0 without any.
double lastPicture(const fs::path& folder) {
    double last = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".png") continue;
        CHECK(readPng(entry.path()).width == 32);
        const std::string name = entry.path().filename().string();
        last = std::max(last, parseDouble(name.substr(0, name.find('s'))).value_or(0));
    }
    return last;
}

void checkWhatIsLeft(const fs::path& folder, int signal, int code) {
    CHECK(code == (signal == SIGKILL ? kKilled + SIGKILL : 1));
    if (!fs::exists(folder / "result.json")) {
        CHECK_FALSE(fs::exists(folder / "telemetry.csv")); // it ended before it began
        return;
    }
    const Json result = Json::parse(readTextFile(folder / "result.json"));
    CHECK(result.at("finished") == false);
    CHECK_FALSE(result.at("error").get<std::string>().empty());
    if (!fs::exists(folder / "telemetry.csv")) return;
    const std::string record = readTextFile(folder / "telemetry.csv");
    if (record.empty()) return;
    CHECK(record.back() == '\n');
    const double pictured = lastPicture(folder);
    if (pictured == 0) return; // no step may have been made
    const TorchRecording rows = readTorchCsv(folder / "telemetry.csv");
    CHECK(rows.samples.back().time >= pictured - 0.2);
    if (result.contains("steps")) CHECK(rows.samples.size() == result.at("steps").get<size_t>());
}

void killRuns(int count, unsigned seed) {
    std::mt19937 random(seed);
    constexpr std::array<int, 4> kSignals{SIGKILL, SIGTERM, SIGINT, SIGHUP};
    for (int i = 0; i < count; ++i) {
        const fs::path folder = test::scratchFolder("killed");
        const int signal = kSignals[static_cast<size_t>(i) % kSignals.size()];
        const Milliseconds moment(random() % 3000);
        INFO("signal " << signal << " after " << moment.count() << " ms");
        const int code = endOf([&] { runProgramQuietly(runInto(folder)); }, {{moment, signal}});
        // Before the program listens, a signal ends it in the system's own way.
        const bool listened = fs::exists(folder / "result.json");
        checkWhatIsLeft(folder, signal, listened || signal == SIGKILL ? code : 1);
    }
}

} // namespace

TEST_CASE("runs that are killed at random moments leave whole files that say so", "[app]") {
    killRuns(8, 1);
}

TEST_CASE("fifty kills at random moments", "[app][long]") {
    killRuns(50, 2);
}

TEST_CASE("signals ask; a second Ctrl-C ends at once, a second signal of another kind does not", "[app]") {
    const auto deaf = [] {
        const StopSignals signals;
        std::this_thread::sleep_for(std::chrono::seconds(3));
        _exit(StopSignals::asked() ? 42 : 43);
    };
    const Milliseconds begun(500), later(600);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        CHECK(endOf(deaf, {{begun, signal}}) == 42);
    CHECK(endOf(deaf, {}) == 43);
    CHECK(endOf(deaf, {{begun, SIGINT}, {later, SIGINT}}) == 1);
    CHECK(endOf(deaf, {{begun, SIGTERM}, {later, SIGTERM}}) == 42);
}

TEST_CASE("what does not come to its next step is ended after its last words, what stops in order is not", "[app]") {
    const fs::path file = test::scratchFolder("last") / "words.txt";
    const auto work = [&](bool grants) {
        StopSignals signals;
        signals.endAfter(Milliseconds(200), [&] { writeTextFileAtomically(file, "ended"); });
        while (!StopSignals::asked())
            std::this_thread::sleep_for(Milliseconds(5));
        if (grants) signals.grantStop();
        std::this_thread::sleep_for(std::chrono::seconds(3));
        _exit(42);
    };
    CHECK(endOf([&] { work(true); }, {{Milliseconds(500), SIGTERM}}) == 42);
    CHECK_FALSE(fs::exists(file));
    CHECK(endOf([&] { work(false); }, {{Milliseconds(500), SIGTERM}}) == 1);
    CHECK(readTextFile(file) == "ended");
}

TEST_CASE("Ctrl-C ends a run in the middle of a step of minutes and its result says so", "[app]") {
    const fs::path folder = test::scratchFolder("long-step");
    const std::vector<std::string> words{"run",       "classic", "--size",     "32x24", "--set", "particles=2000000",
                                         "--seconds", "3600",    "--pictures", "0",     "--out", folder.string()};
    const pid_t child = fork();
    if (child == 0) {
        runProgramQuietly(words);
        _exit(99);
    }
    while (!fs::exists(folder / "result.json"))
        std::this_thread::sleep_for(Milliseconds(20));
    const auto asked = std::chrono::steady_clock::now();
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - asked;
    WARN("a run of two million particles ended " << waited.count() << " s after Ctrl-C");
    CHECK(WEXITSTATUS(status) == 1);
    CHECK_THAT(Json::parse(readTextFile(folder / "result.json")).at("error").get<std::string>(),
               containsText("stopped"));
}

namespace {

/// What a command that keeps its JSON after each case or row left when signals ended it.
struct Interrupted {
    int code = -1;
    Json json;
    std::string words; ///< all that it said
};

/// Sends the signals, 400 ms apart, `after` it said `firstWords`. `list`: of the cases or rows in the JSON.
Interrupted interrupt(std::vector<std::string> command, const std::string& list, const std::string& firstWords,
                      const std::vector<int>& signals, Milliseconds after = Milliseconds(0)) {
    const fs::path folder = test::scratchFolder("interrupted");
    const fs::path file = folder / "out.json", output = folder / "words.txt";
    command.insert(command.end(), {"--json", file.string()});
    const pid_t child = fork();
    if (child == 0) {
        runProgramQuietly(command, output.c_str());
        _exit(99);
    }
    const auto begun = [&] { return fs::exists(output) && readTextFile(output).find(firstWords) != std::string::npos; };
    while (!begun() && waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(Milliseconds(5));
    std::this_thread::sleep_for(after);
    for (const int signal : signals) {
        kill(child, signal);
        std::this_thread::sleep_for(Milliseconds(400));
    }
    int status = 0;
    waitpid(child, &status, 0);
    const Interrupted end{WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status),
                          Json::parse(readTextFile(file)), readTextFile(output)};
    INFO(end.words);
    CHECK(end.json.at("complete") == false);
    REQUIRE(end.json.contains(list));
    return end;
}

std::string caseFile(const std::string& name) {
    return (test::testFolder() / "validation" / "cases" / (name + ".toml")).string();
}

} // namespace

TEST_CASE("validate that is asked to stop ends after its case with what it had", "[app]") {
    const std::string quick = caseFile("conduction_step");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const Interrupted end = interrupt({"validate", quick, quick, quick, quick, quick, quick, quick, quick}, "cases",
                                          "temperature_at_2mm_k", {signal});
        INFO("signal " << signal);
        CHECK(end.code == 1);
        CHECK(end.json.at("passed") == false);
        CHECK_FALSE(end.json.at("cases").empty());
        CHECK(end.json.at("cases").size() < 8);
        for (const Json& one : end.json.at("cases"))
            CHECK(one.at("passed") == true);
        CHECK_THAT(end.words, containsText("stops after this case"));
        CHECK_THAT(end.words, containsText("the validation was stopped after"));
    }
}

TEST_CASE("a second Ctrl-C ends validate in the middle of a case of minutes", "[app]") {
    const Interrupted end = interrupt({"validate", caseFile("conduction_step"), caseFile("bead_gmaw_park")}, "cases",
                                      "temperature_at_2mm_k", {SIGINT, SIGINT}, Milliseconds(2000));
    CHECK(end.code == 1);
    CHECK(end.json.at("cases").size() == 1); // the second never came to its end
    CHECK_THAT(end.words, containsText("ended at once"));
}

TEST_CASE("bench that is asked to stop ends after its row with what it had", "[app]") {
    const Interrupted end = interrupt({"bench", "classic"}, "rows", "ms (least)", {SIGTERM});
    CHECK(end.code == 1);
    CHECK_FALSE(end.json.at("rows").empty());
    CHECK(end.json.at("rows").size() < 4); // the whole suite has more than ten
    CHECK_THAT(end.words, containsText("the measurement was stopped"));
}
