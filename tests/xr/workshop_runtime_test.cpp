// Tests lessons in the headset from end to end: left-handed and seated, a real weld, the rod, the desk's part in it.
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

glm::vec3 vectorOf(const json& numbers) {
    return {numbers[0].get<float>(), numbers[1].get<float>(), numbers[2].get<float>()};
}

/// Returns a condition: the lesson's torch is at the aimed place (mm).
auto torchAt(const glm::vec3& mm) {
    return [mm](const json& row) { return glm::distance(vectorOf(row["torch"]["tip_mm"]), mm) < 0.5f; };
}

auto actionIs(const char* action) {
    return [action](const json& row) { return row["headset"]["tip"]["action"] == action; };
}

/// Returns true for an arc that melts wire: open or in short circuits.
bool welds(const json& row) {
    const std::string action = row["headset"]["tip"]["action"];
    return action == "burning" || action == "shorting";
}

/// Welds the record again without a headset and checks that every row has an equal arc.
void checkReplay(const fs::path& lesson, const fs::path& record, const fs::path& folder) {
    const TorchRecording live = readTorchCsv(record);
    REQUIRE(live.samples.size() > 20);
    REQUIRE(runTrainer({"run", lesson.string(), "--torch", record.string(), "--seconds",
                        formatNumber(live.samples.back().time), "--pictures", "0", "--size", "64x64", "--out",
                        folder.string()}) == 0);
    const TorchRecording again = readTorchCsv(folder / "telemetry.csv");
    const auto& names = live.furtherColumns;
    REQUIRE(names.back() == "real_time"); // a run without a person has none
    REQUIRE(std::vector(names.begin(), names.end() - 1) == again.furtherColumns);
    const size_t rows = std::min(live.samples.size(), again.samples.size());
    CHECK(rows + 1 >= live.samples.size());
    size_t burning = 0;
    for (const std::string name : {"molten", "mean_temperature_c", "max_temperature_c", "arc_length_mm", "current_a",
                                   "voltage_v", "arc_state"}) {
        const auto column = static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        REQUIRE(column < names.size());
        size_t differing = 0;
        for (size_t i = 0; i < rows; ++i) {
            differing += live.furtherCells[i][column] != again.furtherCells[i][column] ? 1 : 0;
            burning += live.furtherCells[i][column] == "burning" || live.furtherCells[i][column] == "shorting" ? 1 : 0;
        }
        INFO(name);
        CHECK(differing == 0);
    }
    CHECK(burning > 10);
}

/// Grip of the hand that holds a rod, in the session's space.
const xr::Pose kRodGrip{glm::angleAxis(0.3f, glm::vec3(0, 1, 0)), {-0.1f, 1.0f, -0.2f}};

void pressKey(const std::string& key) {
    REQUIRE(std::system(("xdotool search --name '^Meltpool$' windowfocus --sync key " + key).c_str()) == 0);
}

} // namespace

TEST_CASE("left hand, low table at a set height, another zoom: the tip is where it is held; the mouse takes over and "
          "gives back",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "left";
    Trainee trainee;
    trainee.hand = 0;
    trainee.zoom = 2;
    trainee.tableHeight = trainee.tableTop = 0.7f;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()},
                           "hand = \"left\"\ntable = \"set\"\nzoom = 2\ntable_height = 0.7\n");
    REQUIRE(trainer.waitFor(ready));
    const glm::vec3 corner(0.018f);
    CHECK(trainee.strike(trainer, corner, torchAt(corner * 1000.0f)));
    CHECK(trainee.strike(trainer, corner, [](const json& row) { return row["metal"]["hottest"] > 0.05; }));
    CHECK(glm::distance(vectorOf(trainer.now()["torch"]["axis"]), trainee.held * glm::vec3(0, 0, -1)) < 0.01f);
    trainee.aim({-0.01f, 0.03f, 0.02f}, 0.0f);
    CHECK(trainer.waitFor(torchAt({-10, 30, 20})));

    pressKey("c");
    REQUIRE(trainer.waitFor([](const json& row) { return row["captured"] == true; }));
    CHECK(trainer.waitFor([](const json& row) { return !torchAt({-10, 30, 20})(row); }));
    passFrames(trainer, 3);
    const glm::vec3 mouse = vectorOf(trainer.now()["torch"]["tip_mm"]);
    trainee.aim({0.01f, 0.03f, 0.02f}, 1.0f); // the hand leads nothing now
    passFrames(trainer, 8);
    CHECK(torchAt(mouse)(trainer.now()));
    CHECK(trainer.now()["torch"]["trigger"] == 0);
    CHECK(trainer.now()["headset"]["tip"]["amplitude"] == 0);
    CHECK(trainer.waitFor(running));
    pressKey("c");
    CHECK(trainer.waitFor(torchAt({10, 30, 20})));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("a bead is welded in the headset: the arc strikes, follows its length and goes out, wire arrives",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "weld";
    const fs::path file = plateLesson(folder), record = folder / "telemetry.csv";
    Trainee trainee;
    trainee.bottom = makeWorkpiece(readLesson(file).workpiece).low.y;
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0)); // nearly straight down
    TrainerProcess trainer(folder, {"--headset", "--lesson", file.string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.aim({0, 0.003f, 0}, 0.0f); // the tip is here before any wire
    REQUIRE(trainer.waitFor(torchAt({0, 3, 0})));
    CHECK(trainer.waitFor([](const json& row) {
        const json& ahead = row["headset"]["tip"]["ahead_mm"]; // null while there is no metal ahead
        return ahead.is_number() && std::abs(ahead.get<double>() - 3) < 0.5;
    }));
    CHECK(trainer.now()["headset"]["tip"]["action"] == "out");

    trainee.lookDown();
    const auto weldsUntil = [&](const std::function<bool(const json&)>& done) {
        return trainee.strike(trainer, {0, 0.003f, 0}, done);
    };
    CHECK(weldsUntil(welds));
    CHECK(weldsUntil([](const json& row) { return row["headset"]["tip"]["amplitude"] > 0.3; }));
    const int before = trainer.now()["metal"]["particles"];
    CHECK(weldsUntil([&](const json& row) { return row["metal"]["particles"] > before + 5; })); // wire
    CHECK(weldsUntil([](const json& row) { return row["metal"]["molten"] > 20; }));
    CHECK(weldsUntil([](const json& row) { return row["headset"]["tip"]["liquid"] > 0.5; })); // over the pool
    keepPicture(screenshot(), "welding.png");

    // The hand has no rod in it, as GMAW melts none.
    trainee.state.hands[0].pose = kRodGrip * handGeometry().grip.inverse();
    trainee.aim({0, 0.06f, 0}, 1.0f); // torn off: the arc is out until the wire has come down again
    CHECK(trainer.waitFor(actionIs("out")));
    passFrames(trainer, 8);
    CHECK_FALSE(trainer.now()["torch"].contains("rod_mm"));
    trainee.state.hands[0].active = false;
    trainee.aim({0, 0.003f, 0}, 0.0f);
    CHECK(trainer.waitFor(actionIs("out")));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    checkReplay(file, record, folder / "again");
}

TEST_CASE("a filler rod in a GTAW lesson is where the other hand holds it, and gone with the hand", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "rod";
    const fs::path file = plateLesson(folder);
    std::string text = readTextFile(file);
    const size_t from = text.find("process = \"gmaw\""), to = text.find("[surface]");
    REQUIRE(from < to);
    writeTextFileAtomically(file, text.replace(from, to - from, "process = \"gtaw\"\ncurrent = 100\n"));
    Trainee trainee;
    trainee.bottom = makeWorkpiece(readLesson(file).workpiece).low.y;
    trainee.zoom = 1;
    trainee.take("gtaw");
    TrainerProcess trainer(folder, {"--headset", "--lesson", file.string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.state.hands[0].pose = kRodGrip * handGeometry().grip.inverse();
    trainee.aim({0, 0.06f, 0}, 0.0f);
    REQUIRE(trainer.waitFor([](const json& row) { return row["torch"].contains("rod_mm"); }));
    const glm::vec3 tip = kRodGrip * glm::vec3(0, 0, -0.30f); // the rod's tip is 300 mm before the grip
    const glm::vec3 expected = (tip - trainee.inRoom(glm::vec3(0))) / trainee.zoom * 1000.0f;
    const auto rodThere = [&](const json& row) {
        return row["torch"].contains("rod_mm") && glm::distance(vectorOf(row["torch"]["rod_mm"]), expected) < 2.0f;
    };
    INFO("rod at " << trainer.now()["torch"].dump() << ", expected " << expected.x << ' ' << expected.y << ' '
                   << expected.z);
    CHECK(trainer.waitFor(rodThere)); // the grips of both scripted hands are alike to a mm or two
    trainee.state.hands[0].active = false;
    trainee.send();
    CHECK(trainer.waitFor([](const json& row) { return !row["torch"].contains("rod_mm"); }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("--desktop asks no runtime for anything", "[runtime]") {
    const fs::path folder = runFolder() / "desktop";
    RemoteDriver driver(driverPort());
    driver.send({});
    TrainerProcess trainer(folder, {"--desktop", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor([](const json& row) { return row["frame"] > 20; }));
    const long long begun = trainer.now()["frame"]; // a search would begin with the first frame
    REQUIRE(trainer.waitFor([&](const json& row) { return row["frame"] > begun + 60; }));
    CHECK(trainer.now()["headset"]["state"] == "off");
    CHECK(trainer.stop() == 0);
    CHECK_FALSE(fs::exists(folder / "validation.txt")); // the loader was never called
}
