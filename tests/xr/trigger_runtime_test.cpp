// Tests that the arc goes out before anything but the hand moves the torch, and strikes again only after the trigger's
// release: the whole program on a real runtime.
#include "app/headset/workshop_placing.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <algorithm>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

bool burns(const json& row) {
    return row["torch"]["trigger"] > 0;
}

bool isOut(const json& row) {
    return row["torch"]["trigger"] == 0 && row["headset"]["trigger_locked"] == true;
}

/// Checks that the arc is out, stays so for a while with the trigger pulled, and strikes again after its release.
void checkOutUntilLetGo(TrainerProcess& trainer, Trainee& trainee) {
    REQUIRE(trainer.waitFor([](const json& row) { return isOut(row) && row["headset"]["tracked"] == true; }));
    passFrames(trainer, 6);
    CHECK(isOut(trainer.now()));
    trainee.letGo(trainer);
    CHECK(trainee.pull(trainer, burns));
}

/// Puts the arc out for that reason; repeats it if the runtime did not answer just before, which is a reason too, and
/// the first one counts.
void putOutFor(const char* reason, TrainerProcess& trainer, Trainee& trainee, const fs::path& record,
               const std::function<void(int attempt)>& provoke) {
    const std::string event = std::string("# event arc_out ") + reason;
    for (int attempt = 0; attempt < 5; ++attempt) {
        REQUIRE(trainee.pull(trainer, burns));
        provoke(attempt);
        checkOutUntilLetGo(trainer, trainee);
        if (readTextFile(record).find(event) != std::string::npos) return;
    }
}

/// Longest way between two steps of the record with the trigger pulled in at least one of them, m in the workpiece's
/// frame.
float longestWayWithHeat(const TorchRecording& record) {
    float longest = 0;
    for (size_t i = 1; i < record.samples.size(); ++i) {
        const TorchSample &last = record.samples[i - 1], &now = record.samples[i];
        if (last.trigger > 0 || now.trigger > 0) longest = std::max(longest, glm::distance(last.tip, now.tip));
    }
    return longest;
}

} // namespace

TEST_CASE("zoom, other hand, lost controller: the arc is out first and until the trigger was let go", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "trigger", record = folder / "telemetry.csv";
    Trainee trainee;
    TrainerProcess trainer(folder,
                           {"--headset", "--lesson", smallLesson(folder).string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    const glm::vec3 place(0.018f);
    trainee.aim(place, 0.0f);
    passFrames(trainer, 4);
    const json before = trainer.now();
    const auto moved = [&](const json& row) {
        return std::abs(row["torch"]["tip_mm"][0].get<float>() - before["torch"]["tip_mm"][0].get<float>()) > 20;
    };

    // The head is at another place, half a metre away, and the stick is held: nothing moves while the arc burns.
    REQUIRE(trainee.pull(trainer, burns));
    trainee.state.head = {glm::angleAxis(0.5f, glm::vec3(0, 1, 0)), {0.4f, 1.6f, 0.2f}};
    trainee.state.hands[0].thumbstickClick = true;
    trainee.send();
    sleepFor(WorkshopPlacing::kHold + 1);
    passFrames(trainer, 4);
    CHECK_FALSE(moved(trainer.now()));
    trainee.state.hands[1].trigger = 0;
    trainee.send();
    REQUIRE(trainer.waitFor(moved));
    trainee.state.hands[0].thumbstickClick = false;
    trainee.send();
    passFrames(trainer, 4);
    trainee.letGo(trainer);

    // The controller goes off and comes back with its trigger pulled.
    putOutFor("torch_lost", trainer, trainee, record, [&](int) {
        trainee.state.hands[1].active = false;
        trainee.send();
        REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["tracked"] == false; }));
        passFrames(trainer, 4);
        trainee.state.hands[1].active = true;
        trainee.send();
    });

    // A thrown torch: no hand is so fast, however long a frame is, even seconds.
    putOutFor("jump", trainer, trainee, record, [&](int attempt) {
        trainee.state.hands[1].pose.position += glm::vec3(attempt % 2 == 0 ? -40 : 40, 0.2f, 0);
        trainee.send();
    });

    // The head returns to the first place.
    trainee.state.hands[1].trigger = 0;
    trainee.state.head = {{1, 0, 0, 0}, {0, 1.6f, 0}};
    trainee.holdStick(trainer);

    // The zoom changes: the other hand draws the panel's slider while the arc burns.
    trainee.aim(place, 0.0f);
    passFrames(trainer, 4);
    trainee.letGo(trainer);
    trainee.pointingHand = 0;
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "headset.page.headset",
                  [](const json& row) { return row["headset"]["places"].contains("headset.hand.left"); });
    putOutFor("zoomed", trainer, trainee, record, [&](int) {
        trainee.scrollTo(trainer, "headset.zoom");
        const bool changed = trainer.now()["headset"]["places"].contains("headset.zoom.back");
        trainee.press(trainer, changed ? "headset.zoom.back" : "headset.zoom", isOut);
    });
    trainee.showPanel(trainer, false);
    trainee.pointingHand = {};

    // The panel changes the torch's hand; the torch's hand points at it.
    trainee.state.hands[1].trigger = 0;
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "headset.hand.left",
                  [&](const json&) { return readTextFile(record).find("# event hand left") != std::string::npos; });
    trainee.hand = 0;
    trainee.aim(place, 0.0f);
    passFrames(trainer, 4);
    trainee.showPanel(trainer, false);
    REQUIRE(trainee.pull(trainer, burns));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    const std::string text = readTextFile(record);
    for (const char* event :
         {"# event zoom 4", "# event hand right", "# event torch_on controller", "# event recentred",
          "# event torch lost", "# event arc_out torch_lost", "# event torch seen", "# event arc_out jump",
          "# event arc_out zoomed", "# event hand left"}) {
        INFO(event);
        CHECK_THAT(text, containsText(event));
    }
    const TorchRecording whole = readTorchCsv(record);
    const float longest = longestWayWithHeat(whole);
    WARN("longest way between two steps with heat: " << 1000 * longest << " mm of " << whole.samples.size()
                                                     << " steps");
    CHECK(longest < 0.02f); // a hand's way in the workpiece's frame at zoom 4: 4.8 m/s
}
