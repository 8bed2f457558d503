// Vibration in the whole program: it depends on the metal at the tip, never on the button alone.
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <cmath>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

json tipOf(TrainerProcess& trainer) {
    return trainer.now()["headset"]["tip"];
}

/// Waits until the probe's answer about the tip's new place has come.
bool reaches(TrainerProcess& trainer, const char* action) {
    return trainer.waitFor([&](const json& row) { return row["headset"]["tip"]["action"] == action; });
}

} // namespace

TEST_CASE("a touch knocks without heat, the flame hums where metal takes its heat, and silence is kept", "[runtime]") {
    handGeometry();
    const std::filesystem::path folder = benchFolder() / "feel";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));

    // The trigger far from the metal: nothing.
    trainee.aim({0.0f, 0.06f, 0.02f}, 1.0f);
    CHECK(trainer.waitFor([](const json& row) {
        const json& nearest = row["headset"]["tip"]["nearest_mm"]; // null while no metal is near
        return row["torch"]["trigger"] == 1 && nearest.is_number() && std::abs(nearest.get<double>() - 40) < 8;
    }));
    passFrames(trainer, 8);
    CHECK(tipOf(trainer)["action"] == "out");
    CHECK(tipOf(trainer)["pulses"] == 0);

    // Down onto the cube's upper face (20 mm over its middle, shown up to a coarse cell of 2.5 mm farther), no heat.
    for (const float mm : {35.0f, 30.0f, 26.0f}) {
        trainee.aim({0.0f, mm * 1e-3f, 0.0f}, 0.0f);
        passFrames(trainer, 2);
    }
    CHECK(tipOf(trainer)["touches"] == 0);
    CHECK(tipOf(trainer)["pulses"] == 0);
    trainee.aim({0.0f, 0.016f, 0.0f}, 0.0f);
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tip"]["touches"] == 1; }));
    // A knock ends, though the tip stays.
    CHECK(trainer.waitFor([](const json& row) {
        const json& tip = row["headset"]["tip"];
        return tip["pulses"] >= 1 && tip["amplitude"] == 0;
    }));
    const json still = tipOf(trainer);
    CHECK(still["touching"] == true);
    CHECK(still["touches"] == 1);
    CHECK(still["pulses"] >= 1);
    double knock = 0;
    for (const json& row : trainer.rows())
        knock = std::max(knock, row["headset"]["tip"]["amplitude"].get<double>());
    WARN("knock of amplitude " << knock << " in " << still["pulses"] << " pulses");

    // Heat hums, and ends with the trigger.
    trainee.aim({0.0f, 0.021f, 0.0f}, 1.0f);
    REQUIRE(reaches(trainer, "burning"));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["tip"]["amplitude"] > 0.3; }));
    CHECK(tipOf(trainer)["frequency"] > 100);
    trainee.aim({0.0f, 0.021f, 0.0f}, 0.0f);
    REQUIRE(reaches(trainer, "out"));
    const json quiet = tipOf(trainer);
    passFrames(trainer, 5);
    CHECK(tipOf(trainer)["pulses"] == quiet["pulses"]);
    CHECK(tipOf(trainer)["amplitude"] == 0);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}
