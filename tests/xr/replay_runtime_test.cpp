// Tests attempts of a scripted hand in the headset: replays of their recordings without a headset have equal bits.
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/newest_recording.hpp"
#include "tests/xr/trainee.hpp"

#include <algorithm>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Reads the recording of the attempt that a program of this folder has ended; it must be complete and contain both
/// hands.
Recording recordingIn(const fs::path& folder) {
    Recording recording = readRecording(newestRecording(folder / "meltpool" / "recordings"));
    INFO(recording.stateSentence());
    CHECK_FALSE(recording.damaged());
    REQUIRE(recording.end);
    CHECK(recording.end->steps == recording.steps.size());
    CHECK(recording.steps.size() > 50);
    REQUIRE_FALSE(recording.people.empty());
    CHECK(recording.people.back().head.has_value());
    return recording;
}

/// Replays it without a headset; the result must have the recording's hash.
void checkReplay(const Recording& recording, const fs::path& lesson, const fs::path& out) {
    REQUIRE(runTrainer({"replay", recording.file.string(), "--lesson", lesson.string(), "--pictures", "0", "--size",
                        "64x64", "--out", out.string()}) == 0);
    const json result = json::parse(readTextFile(out / "result.json"));
    CHECK(result["state_hash"] == recording.end->stateHash);
    CHECK(result["recorded"]["same"] == true);
    CHECK(result["steps"] == recording.steps.size());
}

bool tells(const Recording& recording, const std::string& name, const std::string& value) {
    return std::any_of(recording.events.begin(), recording.events.end(),
                       [&](const RecordingNote& note) { return note.name == name && note.value == value; });
}

/// Returns true for an arc that melts wire: open or in short circuits.
bool welds(const json& row) {
    const std::string action = row["headset"]["tip"]["action"];
    return action == "burning" || action == "shorting";
}

/// Waits until `seconds` more of the metal's time have passed.
void passMetalTime(TrainerProcess& trainer, double seconds) {
    const double end = trainer.now()["metal"]["time"].get<double>() + seconds;
    REQUIRE(trainer.waitFor([end](const json& row) { return row["metal"]["time"] >= end; }));
}

} // namespace

TEST_CASE("a flame led by a tracked hand is replayed to the bits of its recording", "[runtime][long]") {
    handGeometry();
    const fs::path folder = runFolder() / "replay-flame";
    const fs::path lesson = smallLesson(folder);
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", lesson.string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.lookDown();
    for (int i = 0; i <= 20; ++i) {
        trainee.aim(glm::mix(glm::vec3(0.04f), glm::vec3(0.018f), float(i) / 20), i > 10 ? 1.0f : 0.0f);
        passMetalTime(trainer, 0.03);
    }
    CHECK(trainee.strike(trainer, glm::vec3(0.018f), [](const json& row) { return row["metal"]["molten"] > 100; }));
    trainee.aim(glm::vec3(0.018f), 0.0f);
    passMetalTime(trainer, 0.3);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    checkReplay(recordingIn(folder), lesson, folder / "again");
}

TEST_CASE("a bead whose torch was lost on the way is replayed to the bits of its recording", "[runtime][long]") {
    handGeometry();
    const fs::path folder = runFolder() / "replay-bead";
    const fs::path lesson = plateLesson(folder);
    constexpr float kMm = 1e-3f;
    Trainee trainee;
    trainee.bottom = makeWorkpiece(readLesson(lesson).workpiece).low.y;
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0)); // nearly straight down
    TrainerProcess trainer(folder, {"--headset", "--lesson", lesson.string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.lookDown();
    REQUIRE(
        trainee.strike(trainer, {-6 * kMm, 3 * kMm, 0}, [](const json& row) { return row["metal"]["molten"] > 20; }));
    for (int i = 0; i <= 20; ++i) { // 8 mm to and fro across the seam
        trainee.aim({(-6 + 0.4f * float(i)) * kMm, 3 * kMm, (i % 4 < 2 ? 0.7f : -0.7f) * kMm}, 1.0f);
        passMetalTime(trainer, 0.06);
    }
    trainee.state.hands[1].active = false;
    trainee.send();
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == false; }));
    passMetalTime(trainer, 0.1);
    trainee.state.hands[1].active = true;
    trainee.aim({2 * kMm, 3 * kMm, 0}, 0.0f);
    REQUIRE(trainer.waitFor(ready));
    CHECK(trainee.strike(trainer, {2 * kMm, 3 * kMm, 0}, welds));
    passMetalTime(trainer, 0.4);
    trainee.letGo(trainer);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    const Recording recording = recordingIn(folder);
    CHECK(tells(recording, "torch", "lost"));
    CHECK(tells(recording, "torch", "seen"));
    checkReplay(recording, lesson, folder / "again");
}
