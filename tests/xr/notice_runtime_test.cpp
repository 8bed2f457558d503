// Tests the notice in the whole program on a real runtime: warnings appear before the eyes, welds start at real size,
// another zoom is shown.
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

auto notice(const std::string& part) {
    return
        [part](const json& row) { return row["headset"]["notice"].get<std::string>().find(part) != std::string::npos; };
}

auto noNotice(const std::string& part) {
    return
        [part](const json& row) { return row["headset"]["notice"].get<std::string>().find(part) == std::string::npos; };
}

/// Takes a picture of the left eye some frames later.
Image leftEye(TrainerProcess& trainer) {
    passFrames(trainer, 8);
    return shownEye(screenshot(), 0);
}

bool saysTrigger(const json& row) {
    return row["messages"].dump().find("trigger") != std::string::npos;
}

/// Returns the zoom in the notice; 0 if it has none.
float zoomToldIn(const json& row) {
    const std::string text = row["headset"]["notice"].is_string() ? row["headset"]["notice"].get<std::string>() : "";
    const size_t at = text.find("Zoom ");
    return at == std::string::npos ? 0 : std::strtof(text.c_str() + at + 5, nullptr);
}

} // namespace

TEST_CASE("a lost torch and a locked trigger are told before the eyes and in the window, in the same words",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "notices";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));
    for (const json& row : trainer.rows()) // the runtime shows the trainer before it enables the controllers
        CHECK(row["messages"].dump().find("something else") == std::string::npos);
    trainee.aim({0.03f, 0.04f, 0.03f}, 0.0f);
    trainee.lookDown();
    REQUIRE(trainer.waitFor([](const json& row) { return notice("Zoom 4")(row) && noNotice("arc")(row); }));
    const Image without = settledEye(trainer, 0);

    trainee.state.hands[1].active = false;
    trainee.send();
    REQUIRE(trainer.waitFor(notice("out of sight")));
    CHECK_THAT(trainer.now()["messages"].dump(), containsText("out of sight"));
    CHECK(eyeComesTo(trainer, 0, without, [](double share) { return share > 0.005; }));
    keepPicture(leftEye(trainer), "notice.png");

    trainee.state.hands[1].active = true;
    trainee.state.hands[1].trigger = 1;
    trainee.send();
    REQUIRE(trainer.waitFor(notice("Let the trigger go")));
    CHECK(trainer.waitFor(saysTrigger));
    keepPicture(leftEye(trainer), "notice-locked.png");
    trainee.letGo(trainer);
    CHECK(trainer.waitFor([](const json& row) { return noNotice("arc")(row) && !saysTrigger(row); }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("a weld starts at real size whatever the settings say; another zoom puts the arc out and is shown",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "zoom";
    const fs::path file = plateLesson(folder), record = folder / "telemetry.csv";
    Trainee trainee;
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.bottom = makeWorkpiece(readLesson(file).workpiece).low.y;
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0));
    TrainerProcess trainer(folder, {"--headset", "--lesson", file.string(), "--record", record.string()},
                           "weld_zoom = 3\n");
    REQUIRE(trainer.waitFor(ready));
    trainee.aim({0.005f, 0.02f, 0}, 0.0f);
    const auto torchAt = [](const glm::vec3& mm) {
        return [mm](const json& row) {
            const json& tip = row["torch"]["tip_mm"];
            return glm::distance(glm::vec3(tip[0].get<float>(), tip[1].get<float>(), tip[2].get<float>()), mm) < 1;
        };
    };
    CHECK(trainer.waitFor(torchAt({5, 20, 0})));
    CHECK(noNotice("Zoom")(trainer.now()));
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "headset.page.headset",
                  [](const json& row) { return row["headset"]["places"].contains("headset.hand.left"); });
    // The press goes to the middle of the slider; versions of Dear ImGui differ by a hundredth in the value of one
    // pixel.
    trainee.press(trainer, "headset.weld_zoom",
                  [](const json& row) { return std::abs(zoomToldIn(row) - 5.5f) < 0.1f; });
    trainee.zoom = zoomToldIn(trainer.now());
    trainee.showPanel(trainer, false);
    trainee.aim({0.005f, 0.02f, 0}, 0.0f);
    CHECK(trainer.waitFor(torchAt({5, 20, 0})));
    keepPicture(leftEye(trainer), "notice-zoom.png");
    CHECK(trainer.stop() == 0);
    const std::string kept = readTextFile(record);
    constexpr std::string_view kEvent = "# event zoom ";
    CHECK_THAT(kept, containsText("# event zoom 1\n"));
    const size_t last = kept.rfind(kEvent);
    REQUIRE(last != std::string::npos);
    CHECK(std::strtof(kept.c_str() + last + kEvent.size(), nullptr) == Approx(trainee.zoom).margin(0.01));
    CHECK(trainer.misuses() == "");
}

TEST_CASE("a question is answered in the headset: the panel opens by itself, and no step is made before", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "question";
    const fs::path lesson = smallLesson(folder);
    Trainee trainee;
    // A record below a file cannot be written.
    TrainerProcess trainer(folder,
                           {"--headset", "--lesson", lesson.string(), "--record", (lesson / "record.csv").string()});
    REQUIRE(trainer.waitFor([](const json& row) {
        return row["headset"]["panel"] == true && row["headset"]["places"].contains("question.0");
    }));
    CHECK(trainer.now()["metal"]["steps"] == 0);
    trainee.lookDown();
    keepPicture(leftEye(trainer), "question.png");
    trainee.press(trainer, "question.0", [](const json& row) { return row["metal"]["steps"] > 0; });
    CHECK(trainer.waitFor([](const json& row) { return row["metal"]["steps"] > 5; }));
    trainer.stop();
    CHECK(trainer.misuses() == "");
}
