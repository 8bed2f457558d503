// Runs that are killed or asked to stop at any moment: their files are whole and say how the run ended.
#include "app/platform/stop_signals.hpp"
#include "core/base/image.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <functional>
#include <random>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Milliseconds = std::chrono::milliseconds;

constexpr int kKilled = 128; ///< exit codes above it contain the number of the fatal signal

/// Runs `work` in its own process, sends each signal after its time, and returns how the process ended.
int endOf(const std::function<void()>& work, const std::vector<std::pair<Milliseconds, int>>& signals) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGHUP, SIG_DFL); // tests may run under nohup, which children inherit
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
    const std::string program = (test::buildFolder() / "bin" / "meltpool").string();
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

/// Returns the time of the last picture, s, and checks that all pictures are whole; 0 without any.
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
        CHECK_FALSE(fs::exists(folder / "telemetry.csv")); // the run ended before its start
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
    if (pictured == 0) return; // the run may have made no step
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
        // Before the program installs its handler, a signal ends it in the system's own way.
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

namespace {

/// Longer than any step takes on a busy machine; only a hang reaches it.
constexpr Milliseconds kPatience(300'000);

/// A child process that exchanges bytes with the test, one for each state it reaches and one for each command. No
/// waiting time is guessed.
class TalkingChild {
  public:
    /// `work` gets the child's ends of the pipes: one to write, one to read.
    explicit TalkingChild(const std::function<void(int tell, int listen)>& work) {
        REQUIRE(pipe(told_.data()) == 0);
        REQUIRE(pipe(said_.data()) == 0);
        child_ = fork();
        if (child_ != 0) return;
        std::signal(SIGHUP, SIG_DFL); // tests may run under nohup, which children inherit
        work(told_[1], said_[0]);
        _exit(99);
    }
    ~TalkingChild() {
        if (!ended_) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
        for (const int end : {told_[0], told_[1], said_[0], said_[1]})
            close(end);
    }
    TalkingChild(const TalkingChild&) = delete;
    TalkingChild& operator=(const TalkingChild&) = delete;

    /// Waits for the child's next byte; false at the pipe's end.
    bool hear() const {
        pollfd end{told_[0], POLLIN, 0};
        char byte = 0;
        return poll(&end, 1, static_cast<int>(kPatience.count())) == 1 && read(told_[0], &byte, 1) == 1;
    }
    void signal(int number) const { kill(child_, number); }
    void say() const { CHECK(write(said_[1], "x", 1) == 1); }
    /// Waits for the child's end and returns its status. Kills a child that does not end.
    int end() {
        int status = 0;
        ended_ = true;
        for (Milliseconds waited(0); waitpid(child_, &status, WNOHANG) == 0; waited += Milliseconds(5)) {
            if (waited >= kPatience) kill(child_, SIGKILL);
            std::this_thread::sleep_for(Milliseconds(5));
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status);
    }

  private:
    std::array<int, 2> told_{}, said_{};
    pid_t child_ = -1;
    bool ended_ = false;
};

/// Reports when it handles signals and when a stop was requested, then ends on command: 42 after a request, else 43.
void waitForEnd(int tell, int listen) {
    const StopSignals signals;
    bool told = false;
    const auto say = [tell] {
        if (write(tell, "x", 1) != 1) _exit(98);
    };
    say();
    while (true) {
        if (StopSignals::asked() && !std::exchange(told, true)) say();
        pollfd end{listen, POLLIN, 0};
        if (poll(&end, 1, 5) == 1) _exit(StopSignals::asked() ? 42 : 43);
    }
}

/// Returns how this process ends after the signal; with `again` the signal comes once more after half a second.
int endOfAsked(int signal, bool again) {
    TalkingChild child(waitForEnd);
    REQUIRE(child.hear()); // the handler is installed
    child.signal(signal);
    REQUIRE(child.hear()); // the stop was requested
    if (again) {
        std::this_thread::sleep_for(Milliseconds(500)); // an earlier signal is a copy of the first
        child.signal(signal);
    }
    if (!again || signal != SIGINT) child.say(); // a pending signal comes before the child can read this
    return child.end();
}

} // namespace

TEST_CASE("signals ask; a second Ctrl-C ends at once, a second signal of another kind does not", "[app]") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        CHECK(endOfAsked(signal, false) == 42);
    TalkingChild unasked(waitForEnd);
    REQUIRE(unasked.hear());
    unasked.say();
    CHECK(unasked.end() == 43);
    CHECK(endOfAsked(SIGINT, true) == 1);
    CHECK(endOfAsked(SIGTERM, true) == 42);
}

TEST_CASE("what does not come to its next step is ended after its last words, what stops in order is not", "[app]") {
    const fs::path file = test::scratchFolder("last") / "words.txt";
    const auto end = [&](bool grants) {
        fs::remove(file);
        TalkingChild child([&](int tell, int) {
            constexpr Milliseconds kLeft(1000);
            StopSignals signals;
            signals.endAfter(kLeft, [&] { writeTextFileAtomically(file, "ended"); });
            if (write(tell, "x", 1) != 1) _exit(98);
            while (!StopSignals::asked())
                std::this_thread::sleep_for(Milliseconds(5));
            if (grants) signals.grantStop();
            std::this_thread::sleep_for(grants ? 2 * kLeft : kPatience);
            _exit(42);
        });
        REQUIRE(child.hear());
        child.signal(SIGTERM);
        return child.end();
    };
    // One of five tries suffices: on a busy machine the child may run out of time before it grants its stop.
    int granted = -1;
    for (int attempt = 0; attempt < 5 && granted != 42; ++attempt)
        granted = end(true);
    CHECK(granted == 42);
    CHECK_FALSE(fs::exists(file));
    CHECK(end(false) == 1);
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

/// State that a command with a JSON after each case or row leaves when signals end it.
struct Interrupted {
    int code = -1;
    Json json;
    std::string words; ///< its whole output
};

/// Sends the signals `after` the output contains `firstWords`, each 400 ms after the answer to the one before. `list`
/// names the cases or rows in the JSON.
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
    int status = 0;
    bool ended = false;
    const auto waitForWords = [&](const std::string& words) {
        const auto said = [&] { return fs::exists(output) && readTextFile(output).find(words) != std::string::npos; };
        while (!said() && !ended) {
            ended = waitpid(child, &status, WNOHANG) == child;
            std::this_thread::sleep_for(Milliseconds(5));
        }
    };
    waitForWords(firstWords);
    std::this_thread::sleep_for(after);
    for (size_t i = 0; i < signals.size() && !ended; ++i) {
        if (i > 0) {
            waitForWords("stops after this");
            std::this_thread::sleep_for(Milliseconds(400));
        }
        kill(child, signals[i]);
    }
    if (!ended) waitpid(child, &status, 0);
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
    constexpr size_t kCases = 60; // more cases than finish while this test is suspended
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        std::vector<std::string> command{"validate"};
        command.insert(command.end(), kCases, quick);
        const Interrupted end = interrupt(command, "cases", "temperature_at_2mm_k", {signal});
        INFO("signal " << signal);
        CHECK(end.code == 1);
        CHECK(end.json.at("passed") == false);
        CHECK_FALSE(end.json.at("cases").empty());
        CHECK(end.json.at("cases").size() < kCases);
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
    CHECK(end.json.at("cases").size() == 1); // the second case did not finish
    CHECK_THAT(end.words, containsText("ended at once"));
}

TEST_CASE("bench that is asked to stop ends after its row with what it had", "[app]") {
    const Interrupted end = interrupt({"bench", "classic"}, "rows", "ms (least)", {SIGTERM});
    CHECK(end.code == 1);
    CHECK_FALSE(end.json.at("rows").empty());
    CHECK(end.json.at("rows").size() < 4); // the whole suite has more than ten
    CHECK_THAT(end.words, containsText("the measurement was stopped"));
}
