// Tests the whole program on a real runtime: a tracked torch melts the cube, the panel is used, controller and runtime
// are lost.
#include "core/base/text.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/desk_window.hpp"
#include "tests/xr/trainee.hpp"
#include "xr/pivot.hpp"

#include <glm/gtc/constants.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <random>
#include <thread>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Returns the cells of the last row; only comments follow it.
std::vector<std::string> lastRow(const fs::path& csv) {
    const std::string text = readTextFile(csv);
    std::vector<std::string_view> lines = splitText(trimText(text), '\n');
    while (lines.size() > 1 && lines.back().starts_with('#'))
        lines.pop_back();
    std::vector<std::string> cells;
    for (const std::string_view cell : splitText(lines.back(), ','))
        cells.emplace_back(cell);
    return cells;
}

/// Returns true if the count of steps fell somewhere along the rows.
bool wasReset(const std::vector<json>& rows) {
    for (size_t i = 1; i < rows.size(); ++i)
        if (rows[i]["metal"]["steps"] < rows[i - 1]["metal"]["steps"]) return true;
    return false;
}

} // namespace

TEST_CASE("a tracked torch melts the cube's corner, and its record melts it again without a headset", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "melt";
    const fs::path lesson = smallLesson(folder), record = folder / "telemetry.csv";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", lesson.string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == true; }));
    trainee.lookDown();

    // The torch moves from the cube's side to its front upper corner, heating on the way in.
    for (int i = 0; i <= 20; ++i) {
        trainee.aim(glm::mix(glm::vec3(0.04f), glm::vec3(0.018f), float(i) / 20), i > 10 ? 1.0f : 0.0f);
        sleepFor(0.03);
    }
    CHECK(trainee.strike(trainer, glm::vec3(0.018f), [](const json& row) { return row["metal"]["molten"] > 100; }));
    keepPicture(screenshot(), "melting.png");
    trainee.aim(glm::vec3(0.018f), 0.0f);
    passFrames(trainer, 4);
    const long long steps = trainer.now()["metal"]["steps"];
    CHECK(trainer.waitFor([&](const json& row) { return row["metal"]["steps"] > steps + 6; }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");

    const std::vector<std::string> row = lastRow(record);
    REQUIRE(row.size() >= 13);
    const fs::path again = folder / "again";
    REQUIRE(runTrainer({"run", lesson.string(), "--torch", record.string(), "--seconds", row[0], "--pictures", "0",
                        "--size", "64x64", "--out", again.string()}) == 0);
    const std::vector<std::string> headless = lastRow(again / "telemetry.csv");
    const json result = json::parse(readTextFile(again / "result.json"));
    const auto number = [](const std::string& text) { return parseDouble(text).value(); };
    WARN("molten " << row[9] << " in the headset, " << headless[9] << " headless; hottest " << row[12] << ", "
                   << headless[12] << "; mean " << row[11] << ", " << headless[11]);
    for (const size_t column : {9u, 10u, 11u, 12u})
        CHECK(headless[column] == row[column]);
    CHECK(number(row[9]) > 100);
}

TEST_CASE("the torch's controller goes off in mid-weld: the arc is out, it is said, and it comes back", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "controller";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string(), "--record",
                                    (folder / "telemetry.csv").string()});
    REQUIRE(trainer.waitFor(ready));
    REQUIRE(trainee.strike(trainer, glm::vec3(0.018f), [](const json& row) { return row["metal"]["hottest"] > 0.05; }));
    trainee.state.hands[1].active = false;
    trainee.driver.send(trainee.state);
    json lost;
    REQUIRE(trainer.waitFor([&](const json& row) {
        lost = row;
        return row["headset"]["tracked"] == false &&
               row["headset"]["warning"].dump().find("arc is out") != std::string::npos &&
               row["messages"].dump().find("arc is out") != std::string::npos;
    }));
    // The lesson continues.
    CHECK(trainer.waitFor(
        [&](const json& row) { return row["metal"]["steps"] > lost["metal"]["steps"].get<int>() + 10; }));
    CHECK(trainer.now()["headset"]["tracked"] == false);
    trainee.state.hands[1].active = true;
    trainee.driver.send(trainee.state);
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == true; }));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["warning"] == ""; }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    // The record has a released trigger during the loss of the hand.
    const TorchRecording record = readTorchCsv(folder / "telemetry.csv");
    int edges = 0;
    for (size_t i = 1; i < record.samples.size(); ++i)
        edges += record.samples[i - 1].trigger > 0 && record.samples[i].trigger <= 0 ? 1 : 0;
    CHECK(edges >= 1);
}

TEST_CASE("the runtime is killed in mid-weld: the window goes on, the headset is used again", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "killed";
    const fs::path record = folder / "telemetry.csv";
    auto trainee = std::make_unique<Trainee>();
    TrainerProcess trainer(folder, {"--lesson", smallLesson(folder).string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    REQUIRE(
        trainee->strike(trainer, glm::vec3(0.018f), [](const json& row) { return row["metal"]["hottest"] > 0.05; }));
    const double before = trainer.now()["seconds"];
    REQUIRE(kill(servicePid(), SIGKILL) == 0);
    json lost;
    REQUIRE(trainer.waitFor([&](const json& row) {
        lost = row;
        return row["headset"]["state"] == "searching";
    }));
    CHECK_THAT(lost["headset"]["warning"].get<std::string>(), containsText("has stopped"));
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["state"] == "running"; }));
    CHECK(trainer.now()["headset"]["openings"] == 2);
    CHECK(trainer.now()["metal"]["time"] > lost["metal"]["time"]);

    // The window continues during the runtime's absence, for two seconds at least.
    double longest = 0, last = before;
    long long framesAlone = 0;
    for (const json& row : trainer.rows()) {
        if (row["seconds"] < before) continue;
        longest = std::max(longest, row["seconds"].get<double>() - last);
        last = row["seconds"];
        if (row["headset"]["state"] == "searching")
            framesAlone = row["frame"].get<long long>() - lost["frame"].get<long long>();
    }
    WARN("longest pause of the window around the loss and the return: " << longest << " s; " << framesAlone
                                                                        << " frames without a runtime");
    CHECK(framesAlone > 2); // a window that waits for the runtime has none

    const double molten = trainer.now()["metal"]["molten"];
    trainee = std::make_unique<Trainee>();
    trainee->letGo(trainer);
    const bool melts = // the other upper corner, still solid
        trainee->strike(trainer, {-0.018f, 0.018f, 0.018f},
                        [&](const json& row) { return row["metal"]["molten"] > molten + 10; });
    const json then = trainer.now();
    CHECK(trainer.stop() == 0);
    const std::vector<std::string> row = lastRow(record);
    INFO("molten " << molten << " before; then " << then["metal"].dump() << then["headset"].dump() << "; torch at "
                   << row[1] << ' ' << row[2] << ' ' << row[3] << " mm, trigger " << row[8]);
    CHECK(melts);
    // The record is whole: one row a step, without a gap, readable to the end.
    const TorchRecording whole = readTorchCsv(record);
    const double step = whole.samples[1].time - whole.samples[0].time;
    for (size_t i = 1; i < whole.samples.size(); ++i)
        REQUIRE(whole.samples[i].time - whole.samples[i - 1].time == Approx(step).epsilon(0.01));
}

TEST_CASE("the panel opens and its buttons are pressed with the pointer's ray: reset, camera, tip, workshop here",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "panel";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.aim(glm::vec3(0.018f), 1.0f);
    REQUIRE(trainer.waitFor([](const json& row) { return row["metal"]["steps"] > 20; }));
    trainee.aim(glm::vec3(0.05f), 0.0f);

    trainee.showPanel(trainer, true);
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["places"].contains("headset.reset"); }));
    trainee.pointAtControl(trainer, "headset.reset", 0.0f);
    passFrames(trainer, 4);
    keepPicture(screenshot(), "panel.png");
    trainee.press(trainer, "headset.reset", [&](const json&) { return wasReset(trainer.rows()); });

    // The window shows the trainee's eye and follows the head, then a camera of its own that does not.
    showWindow("Meltpool");
    const auto turned = [&] {
        trainee.state.head = {glm::angleAxis(-0.3f, glm::vec3(1, 0, 0)), {0, 1.6f, 0}};
        trainee.send();
        passFrames(trainer, 8);
        const Image before = settledWindow(trainer);
        trainee.state.head = {glm::angleAxis(0.25f, glm::vec3(0, 1, 0)), {0.2f, 1.6f, 0}};
        trainee.send();
        passFrames(trainer, 8);
        const Image after = settledWindow(trainer);
        keepPicture(after, trainer.now()["headset"]["mirrored"] == true ? "mirror.png" : "camera.png");
        return compareImages(before, after, 24).farPixels;
    };
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["mirrored"] == true; }));
    // A message may come or go between two pictures; a faulty view never passes.
    CHECK(waitUntil([&] { return turned() > 0.1; }));
    trainee.press(trainer, "headset.page.headset",
                  [](const json& row) { return row["headset"]["places"].contains("headset.hand.left"); });
    trainee.press(trainer, "headset.desk_view.camera", [](const json& row) {
        return row["headset"]["state"] == "running" && row["headset"]["mirrored"] == false;
    });
    CHECK(waitUntil([&] { return turned() < 0.02; }));

    // A controller fixed to a real torch has 0.3 mm of noise: the tip is found, and stored.
    const glm::vec3 offset(0.012f, -0.03f, -0.18f), dent(0.2f, 1.0f, -0.3f);
    const auto reports = [](const char* words) {
        return [words](const json& row) {
            return row["headset"]["tip_report"].get<std::string>().find(words) != std::string::npos;
        };
    };
    trainee.press(trainer, "headset.tip", reports("Rest the tip"));
    std::mt19937 random(11);
    std::normal_distribution<float> noise(0.0f, 0.0003f);
    const auto begin = std::chrono::steady_clock::now();
    const fs::path kept = folder / "meltpool" / "torch-tip.txt";
    const auto swing = [&] {
        const float t = std::chrono::duration<float>(std::chrono::steady_clock::now() - begin).count();
        const glm::quat q = glm::angleAxis(0.7f * std::sin(1.9f * t), glm::vec3(1, 0, 0)) *
                            glm::angleAxis(0.7f * std::sin(1.3f * t), glm::vec3(0, 1, 0)) *
                            glm::angleAxis(0.8f * std::sin(0.7f * t), glm::vec3(0, 0, 1));
        const xr::Pose grip{q, dent - q * offset + glm::vec3(noise(random), noise(random), noise(random))};
        trainee.state.hands[1].pose = grip * handGeometry().grip.inverse();
        trainee.send();
    };
    waitUntil([&] {
        for (int i = 0; i < 100 && !fs::exists(kept); ++i) {
            swing();
            sleepFor(0.01);
        }
        // Too few of the poses may have reached the program.
        if (reports("was not found")(trainer.now())) trainee.press(trainer, "headset.tip", reports("Rest the tip"));
        return fs::exists(kept);
    });
    INFO(trainer.now()["headset"]["tip_report"]);
    REQUIRE(fs::exists(kept));
    const xr::TipCalibration tip = xr::readCalibration(kept);
    WARN("the tip was found to " << 1000 * glm::distance(tip.offset, offset) << " mm, residual " << tip.residualMm
                                 << " mm");
    CHECK(glm::distance(tip.offset, offset) < 0.0003f);
    trainee.press(trainer, "headset.own_tip", reports("its own tip again"));
    CHECK_FALSE(fs::exists(kept));

    // A recentre from another place puts the workshop before the eyes as before: the picture is equal.
    trainee.state.hands[1].active = false;
    trainee.state.head = {glm::angleAxis(-0.3f, glm::vec3(1, 0, 0)), {0, 1.6f, 0}};
    trainee.send();
    passFrames(trainer, 8);
    const Image first = settledEye(trainer, 0);
    trainee.state.head = {glm::angleAxis(0.7f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0)),
                          {0.5f, 1.6f, 0.3f}};
    trainee.send();
    CHECK(eyeComesTo(trainer, 0, first, [](double share) { return share > 0.1; }));
    trainee.holdStick(trainer);
    // The notice may give another speed of the metal.
    CHECK(eyeComesTo(trainer, 0, first, [](double share) { return share < 0.03; }));
    keepPicture(shownEye(screenshot(), 0), "recentred.png");
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("a minute of welding with panel, recentre, loss and return holds no misuse of the API", "[runtime][long]") {
    handGeometry();
    const fs::path folder = runFolder() / "minute";
    auto trainee = std::make_unique<Trainee>();
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));
    double worst = 0;
    const auto weld = [&](double seconds) {
        const auto begin = std::chrono::steady_clock::now();
        for (double t = 0; t < seconds;) {
            t = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            const auto angle = static_cast<float>(t);
            trainee->aim({0.018f * std::cos(angle), 0.018f, 0.018f * std::sin(angle)},
                         std::fmod(t, 5.0) < 4.0 ? 1.0f : 0.0f);
            sleepFor(0.02);
        }
        for (const json& row : trainer.rows())
            worst = std::max(worst, row["headset"]["busy_ms"].get<double>());
    };
    weld(60);
    trainee->state.hands[1].b = true;
    trainee->driver.send(trainee->state);
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["panel"] == true; }));
    trainee->state.hands[1].b = false;
    trainee->state.hands[0].thumbstickClick = true;
    trainee->driver.send(trainee->state);
    passFrames(trainer, 5);
    const json before = trainer.now();
    REQUIRE(kill(servicePid(), SIGKILL) == 0);
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["openings"] == 2; }));
    trainee = std::make_unique<Trainee>();
    trainee->letGo(trainer);
    weld(3);
    const json after = trainer.now();
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    WARN("frames " << after["frame"] << ", " << before["frames_per_second"] << " a second; steps "
                   << before["metal"]["steps"] << "; longest headset work of a frame " << worst << " ms");
}

TEST_CASE("without a headset the program says so when one was asked for", "[runtime]") {
    // The variable names a missing runtime, whatever the machine has.
    const std::string manifest = std::getenv("XR_RUNTIME_JSON");
    setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
    TrainerProcess trainer(runFolder() / "absent", {"--headset"});
    setenv("XR_RUNTIME_JSON", manifest.c_str(), 1);
    CHECK(trainer.finish() == 2);
    CHECK_THAT(readTextFile(runFolder() / "program.log"),
               containsText("no headset to use") && containsText("/nowhere/runtime.json does not exist"));
}
