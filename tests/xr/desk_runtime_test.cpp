// Tests teacher and trainee in one lesson on a real runtime: pause, questions, what each reads of the other, and the
// desk's view of the headset.
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/desk_window.hpp"
#include "tests/xr/trainee.hpp"

#include <algorithm>
#include <cstdlib>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

using Condition = std::function<bool(const json&)>;

auto notice(const std::string& part) {
    return
        [part](const json& row) { return row["headset"]["notice"].get<std::string>().find(part) != std::string::npos; };
}

auto message(const std::string& part) {
    return [part](const json& row) { return row["messages"].dump().find(part) != std::string::npos; };
}

bool burns(const json& row) {
    const std::string action = row["headset"]["tip"]["action"];
    return action == "burning" || action == "shorting";
}

bool paused(const json& row) {
    return row["mode"] == "view";
}

bool asks(const json& row) {
    return row["places"].contains("question.1");
}

/// Presses a key at the desk until `done(row)`: the window may be busy with a long frame.
bool deskKey(TrainerProcess& trainer, const std::string& symbol, const Condition& done) {
    pressKey("Meltpool", symbol);
    return trainer.waitFor(done);
}

long long steps(TrainerProcess& trainer) {
    return trainer.now()["metal"]["steps"];
}

/// Counts pixels of the accent colour, of sliders and chosen tabs, where the desk itself has none: left of its machine
/// panel, below its bar. Messages of the desk may come and go there.
int accentsLeftOfDesk(const Image& window) {
    constexpr int kAccent[] = {255, 138, 61}, kLike = 12, kBar = 48, kDeskBegins = 290;
    int count = 0;
    for (int y = kBar; y < window.height; ++y)
        for (int x = 0; x < kDeskBegins; ++x) {
            const auto* pixel = &window.rgb[(size_t(y) * size_t(window.width) + size_t(x)) * 3];
            count += std::equal(pixel, pixel + 3, kAccent, [](int a, int b) { return std::abs(a - b) < kLike; });
        }
    return count;
}

/// A trainee before a plate to weld, in real size.
struct Weld {
    fs::path folder, lesson, record;
    Trainee trainee;
    TrainerProcess trainer;
    static constexpr glm::vec3 kPlace{0, 0.003f, 0};

    explicit Weld(const std::string& name)
        : folder(runFolder() / name),
          lesson(plateLesson(folder)),
          record(folder / "weld.csv"),
          trainer(folder, {"--headset", "--lesson", lesson.string(), "--record", record.string()}) {
        trainee.bottom = makeWorkpiece(readLesson(lesson).workpiece).low.y;
        trainee.zoom = 1;
        trainee.take("gmaw");
        trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0)); // nearly straight down
        REQUIRE(trainer.waitFor(ready));
        trainee.lookDown();
    }

    bool strike() { return trainee.strike(trainer, kPlace, burns); }
};

} // namespace

TEST_CASE("the desk's pause key stops a weld in the headset: metal and arc are out for both until it goes on",
          "[runtime]") {
    handGeometry();
    Weld weld("pause");
    TrainerProcess& trainer = weld.trainer;
    // On a slow computer the arc may go out by itself between strike and pause; then it is struck again.
    bool putOut = false;
    for (int attempt = 0; attempt < 4 && !putOut; ++attempt) {
        REQUIRE(weld.strike());
        REQUIRE(deskKey(trainer, "v", [](const json& row) { return paused(row) && !burns(row); }));
        CHECK(trainer.waitFor(
            [](const json& row) { return notice("The lesson is paused")(row) && message("paused")(row); }));
        passFrames(trainer, 2); // a step that had begun still ends
        const long long stopped = steps(trainer);
        passFrames(trainer, 8);
        CHECK(steps(trainer) == stopped);

        // The trigger is still pulled: it goes on, but without an arc.
        REQUIRE(deskKey(trainer, "v", [&](const json& row) { return !paused(row); }));
        putOut = trainer.waitFor(notice("The lesson was paused: the arc is out.")); // for some seconds only
        CHECK(trainer.waitFor([&](const json& row) { return row["metal"]["steps"] > stopped + 10; }));
        CHECK_FALSE(burns(trainer.now()));
        weld.trainee.letGo(trainer);
    }
    CHECK(putOut);
    CHECK(weld.strike());

    // The trainee pauses and goes on at the panel.
    weld.trainee.aim({0, 0.06f, 0}, 0.0f);
    REQUIRE(trainer.waitFor([](const json& row) { return !burns(row); })); // an arc closes the panel
    weld.trainee.showPanel(trainer, true);
    weld.trainee.press(trainer, "headset.pause", paused);
    passFrames(trainer, 4);
    const long long again = steps(trainer);
    passFrames(trainer, 8);
    CHECK(steps(trainer) == again);
    weld.trainee.press(trainer, "headset.pause", [](const json& row) { return !paused(row); });
    CHECK(trainer.waitFor([&](const json& row) { return row["metal"]["steps"] > again + 5; }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    const std::string record = readTextFile(weld.record);
    for (const char* line : {"# event paused", "# event arc_out paused", "# event resumed"}) {
        INFO(line);
        CHECK(record.find(line) != std::string::npos);
    }
}

TEST_CASE("the desk asks before it ends a weld in the headset, and the trainee reads what the teacher did",
          "[runtime]") {
    handGeometry();
    Weld weld("seats");
    TrainerProcess& trainer = weld.trainer;
    // Before the first arc there is no weld to lose.
    REQUIRE(deskKey(trainer, "F5", [&](const json&) { return fs::exists(weld.folder / "weld-2.csv"); }));
    CHECK(trainer.waitFor(notice("The teacher began a new attempt.")));
    REQUIRE(trainer.waitFor(ready));
    weld.trainee.letGo(trainer);

    REQUIRE(weld.strike());
    REQUIRE(deskKey(trainer, "F5", asks));
    const long long asked = steps(trainer);
    CHECK(trainer.waitFor([&](const json& row) { return burns(row) && row["metal"]["steps"] > asked + 5; }));
    CHECK(trainer.now()["page"] == "running");
    CHECK_FALSE(fs::exists(weld.folder / "weld-3.csv")); // the weld goes on while the desk decides
    weld.trainee.aim({0, 0.06f, 0}, 0.0f);
    REQUIRE(trainer.waitFor([](const json& row) { return !burns(row); }));
    CHECK(asks(trainer.now())); // the begun weld is the trainee's still
    weld.trainee.showPanel(trainer, true);
    weld.trainee.press(trainer, "headset.restart", [](const json& row) { return row["page"] == "start"; });
    CHECK(trainer.waitFor(message("The trainee went to the lesson page.")));
    CHECK(trainer.waitFor([](const json& row) { return !asks(row); }));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    CHECK(readRecordedAttempt(weld.folder / "weld-2.csv")->ended == "start menu");
    CHECK(readTextFile(weld.record).find("# event asked_at_desk new_attempt") != std::string::npos);
}

TEST_CASE("the window shows the trainee's eye with the panel, and its own camera behind a dark visor or by the key",
          "[runtime]") {
    handGeometry();
    Weld weld("desk-view");
    TrainerProcess& trainer = weld.trainer;
    const auto mirrored = [](bool wanted) {
        return [wanted](const json& row) {
            return row["headset"]["state"] == "running" && row["headset"]["mirrored"] == wanted;
        };
    };
    REQUIRE(trainer.waitFor(mirrored(true)));
    showWindow("Meltpool");
    // A lesson begins with the panel open, to the left of the work.
    weld.trainee.showPanel(trainer, false);
    weld.trainee.state.head.orientation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0));
    weld.trainee.send();
    passFrames(trainer, 8);
    const Image without = settledWindow(trainer);
    weld.trainee.showPanel(trainer, true);
    passFrames(trainer, 8);
    const Image with = settledWindow(trainer);
    keepPicture(without, "mirror-without-panel.png");
    keepPicture(with, "mirror-with-panel.png");
    keepPicture(settledEye(trainer, 0), "mirror-eye.png");
    CHECK(accentsLeftOfDesk(without) == 0);
    CHECK(accentsLeftOfDesk(with) > 100);
    weld.trainee.showPanel(trainer, false);
    weld.trainee.lookDown();

    REQUIRE(weld.strike());
    CHECK(weld.trainee.strike(trainer, Weld::kPlace, mirrored(false)));
    weld.trainee.aim({0, 0.06f, 0}, 0.0f);
    CHECK(trainer.waitFor(mirrored(true)));
    CHECK(deskKey(trainer, "F6", mirrored(false)));
    CHECK(trainer.waitFor(message("its own camera")));
    CHECK(deskKey(trainer, "F6", mirrored(true)));
    CHECK(trainer.waitFor(message("the trainee's eye. F6")));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}
