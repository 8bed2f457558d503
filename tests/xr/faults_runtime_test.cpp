// Tests the whole program while the real runtime hangs, is killed, or shows another program.
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <csignal>
#include <memory>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

auto stateIs(const char* state) {
    return [state](const json& row) { return row["headset"]["state"] == state; };
}

bool burns(const json& row) {
    return row["headset"]["tip"]["action"] == "burning";
}

bool tellsOfAnotherProgram(const json& row) {
    return row["headset"]["warning"].get<std::string>().find("another program") != std::string::npos;
}

auto modeIs(const char* mode) {
    return [mode](const json& row) { return row["headset"]["mode"] == mode; };
}

/// Returns the longest time between two of the window's rows (one every 0.05 s if frames come) from `since` on, s.
double longestPause(TrainerProcess& trainer, double since) {
    double longest = 0, last = since;
    for (const json& row : trainer.rows()) {
        if (row["seconds"] < since) continue;
        longest = std::max(longest, row["seconds"].get<double>() - last);
        last = row["seconds"];
    }
    return longest;
}

/// Requires one row a step, without a gap, readable to the end.
void requireWhole(const fs::path& record) {
    const TorchRecording whole = readTorchCsv(record);
    REQUIRE(whole.samples.size() > 10);
    const double step = whole.samples[1].time - whole.samples[0].time;
    for (size_t i = 1; i < whole.samples.size(); ++i)
        REQUIRE(whole.samples[i].time - whole.samples[i - 1].time == Approx(step).epsilon(0.01));
}

} // namespace

TEST_CASE("the runtime hangs in mid-weld: the desk goes on, the arc is out, and the headset is in use again after it",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "hang", record = folder / "telemetry.csv";
    auto trainee = std::make_unique<Trainee>();
    TrainerProcess trainer(folder, {"--lesson", smallLesson(folder).string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    REQUIRE(
        trainee->strike(trainer, glm::vec3(0.018f), [](const json& row) { return row["metal"]["hottest"] > 0.05; }));

    const double before = trainer.now()["seconds"];
    REQUIRE(kill(servicePid(), SIGSTOP) == 0);
    REQUIRE(trainer.waitFor(stateIs("stalled")));
    const json hung = trainer.now();
    CHECK_THAT(hung["headset"]["warning"].get<std::string>(), containsText("arc is out"));
    CHECK(trainer.waitFor(
        [](const json& row) { return row["messages"].dump().find("does not answer") != std::string::npos; }));
    // Lesson and window continue, which proves that no frame waits for the runtime.
    CHECK(trainer.waitFor([&](const json& row) {
        return row["metal"]["steps"] > hung["metal"]["steps"].get<int>() + 20 &&
               row["frame"] > hung["frame"].get<int>() + 20;
    }));
    CHECK(trainer.now()["headset"]["state"] == "stalled");
    REQUIRE(kill(servicePid(), SIGCONT) == 0);
    CHECK(trainer.waitFor(running));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == true; }));
    CHECK(trainer.now()["headset"]["openings"] == 1); // the session is unchanged
    passFrames(trainer, 5);
    CHECK(trainer.now()["torch"]["trigger"] == 0); // the trigger has not been released
    trainee->letGo(trainer);
    CHECK(trainee->strike(trainer, glm::vec3(0.018f), burns));
    const double pause = longestPause(trainer, before);
    WARN("longest pause of the window while the runtime hung and came back: " << pause << " s");
    CHECK(trainer.misuses() == "");

    // The runtime hangs again and is killed, which counts as any other loss.
    const double again = trainer.now()["seconds"];
    REQUIRE(kill(servicePid(), SIGSTOP) == 0);
    REQUIRE(trainer.waitFor(stateIs("stalled")));
    REQUIRE(kill(servicePid(), SIGKILL) == 0);
    REQUIRE(trainer.waitFor(stateIs("searching")));
    REQUIRE(trainer.waitFor(stateIs("running")));
    CHECK(trainer.now()["headset"]["openings"] == 2);
    WARN("and while it was killed and came back: " << longestPause(trainer, again) << " s");
    trainee = std::make_unique<Trainee>();
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == true; }));

    // The runtime hangs for good now: the program still ends.
    const int hanging = servicePid();
    REQUIRE(kill(hanging, SIGSTOP) == 0);
    CHECK(trainer.waitFor(stateIs("stalled")));
    CHECK(trainer.stop() == 0);
    kill(hanging, SIGCONT);
    requireWhole(record);
}

TEST_CASE(
    "the first start of all, in which the driver compiles every shader in the middle of frames: the headset is in "
    "use soon after",
    "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "cold";
    Trainee trainee;
    trainee.bottom = -0.010f; // 4 mm of plate over 6 mm of supports
    trainee.zoom = 1;
    trainee.take("gmaw");
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    TrainerProcess trainer(folder, {"--headset", "--lesson", plateLesson(folder).string()});
    unsetenv("MESA_SHADER_CACHE_DISABLE");
    REQUIRE(trainer.waitFor(ready));
    trainee.lookDown();
    trainee.aim({0, 0.003f, 0}, 1.0f);
    // A runtime that adapts its pace to slow frames makes the program wait, and is never content without other frames:
    // no frame in use follows another then.
    long long since = -1;
    CHECK(trainer.waitFor([&](const json& row) {
        if (row["headset"]["state"] != "running")
            since = -1;
        else if (since < 0)
            since = row["frame"];
        return since >= 0 && row["frame"] > since + 20;
    }));
    CHECK(trainer.now()["headset"]["openings"] == 1);
    CHECK(trainer.stop() == 0);
}

TEST_CASE("another program comes before the trainee's eyes: input and arc are gone, the desk looks by itself, then all "
          "is back",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "behind";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));
    REQUIRE(trainer.waitFor(modeIs("focused")));
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["mirrored"] == true; }));
    REQUIRE(trainee.strike(trainer, glm::vec3(0.018f), burns));
    {
        xr::Headset other(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
        REQUIRE(reach(other, xr::SessionMode::focused));
        const auto show = [&] { stepFrame(other, {}); };
        REQUIRE(trainer.waitFor(modeIs("synchronized"), show));
        CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == false; }, show));
        CHECK(trainer.waitFor([](const json& row) { return row["torch"]["trigger"] == 0; }, show));
        CHECK(trainer.waitFor([](const json& row) { return row["headset"]["mirrored"] == false; }, show));
        CHECK(trainer.waitFor(tellsOfAnotherProgram, show));
        const int steps = trainer.now()["metal"]["steps"];
        CHECK(trainer.waitFor([&](const json& row) { return row["metal"]["steps"] > steps + 10; }, show));
        CHECK(trainer.waitFor(stateIs("running"), show));
    }
    CHECK(trainer.waitFor(modeIs("focused")));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == true; }));
    passFrames(trainer, 5);
    CHECK(trainer.now()["torch"]["trigger"] == 0); // the trigger has not been released
    trainee.letGo(trainer);
    CHECK(trainee.strike(trainer, glm::vec3(0.018f), burns));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["mirrored"] == true; }));
    CHECK(trainer.now()["headset"]["openings"] == 1);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}
