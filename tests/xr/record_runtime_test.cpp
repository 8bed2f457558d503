// Tests the whole program on a real runtime: every button of the panel that ends or cuts a record notes that in it.
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/record_check.hpp"
#include "tests/xr/trainee.hpp"

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Waits until the attempt's metal has made some steps.
void weldALittle(TrainerProcess& trainer) {
    REQUIRE(trainer.waitFor([](const json& row) { return running(row) && row["metal"]["steps"] > 15; }));
}

std::string endOf(const fs::path& record) {
    INFO(record);
    const auto attempt = readRecordedAttempt(record);
    REQUIRE(attempt);
    CHECK(attempt->rows > 10);
    CHECK(checkRecord(record).whole());
    return attempt->ended;
}

} // namespace

TEST_CASE("Reset, Start menu and Start in the headset leave a whole record of each attempt", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "attempts";
    Trainee trainee;
    TrainerProcess trainer(
        folder, {"--headset", "--lesson", smallLesson(folder).string(), "--record", (folder / "weld.csv").string()});
    REQUIRE(trainer.waitFor(ready));
    trainee.aim(glm::vec3(0.05f), 0.0f);
    trainee.showPanel(trainer, true);
    weldALittle(trainer);
    trainee.press(trainer, "headset.reset", [&](const json&) { return fs::exists(folder / "weld-2.csv"); });
    weldALittle(trainer);
    trainee.press(trainer, "headset.restart", [](const json& row) { return row["page"] == "start"; });
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["places"].contains("headset.start"); }));
    trainee.press(trainer, "headset.start", [](const json& row) { return row["page"] == "running"; });
    weldALittle(trainer);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    CHECK(endOf(folder / "weld.csv") == "reset");
    CHECK(endOf(folder / "weld-2.csv") == "start menu");
    CHECK(endOf(folder / "weld-3.csv") == "the program ended");
}
