// Tests vibration in the whole program: it depends on the metal at the tip, never on the button alone.
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

auto actionIs(const char* action) {
    return [action](const json& row) { return row["headset"]["tip"]["action"] == action; };
}

/// Returns true if the runtime answered in every frame from that one on. During a gap the torch is out of sight, and
/// touches again after it.
bool answeredSince(TrainerProcess& trainer, long long frame) {
    for (const json& row : trainer.rows())
        if (row["frame"] >= frame && (row["headset"]["state"] != "running" || row["headset"]["tracked"] == false))
            return false;
    return true;
}

/// Lowers the tip from above onto the cube's upper face (20 mm over its middle, shown up to a coarse cell of 2.5 mm
/// farther), without heat: it knocks once, and no sooner. Returns false if the runtime did not answer meanwhile.
bool knocksOnce(TrainerProcess& trainer, Trainee& trainee) {
    trainee.aim({0.0f, 0.04f, 0.0f}, 0.0f);
    passFrames(trainer, 8);
    const json before = trainer.now(), tip = before["headset"]["tip"];
    const int touches = tip["touches"], pulses = tip["pulses"];
    for (const float mm : {35.0f, 30.0f, 26.0f}) {
        trainee.aim({0.0f, mm * 1e-3f, 0.0f}, 0.0f);
        passFrames(trainer, 2);
    }
    const json above = tipOf(trainer);
    trainee.aim({0.0f, 0.016f, 0.0f}, 0.0f);
    CHECK(trainer.waitFor([&](const json& row) { return row["headset"]["tip"]["touches"] > touches; }));
    // A knock ends even while the tip stays.
    CHECK(trainer.waitFor([&](const json& row) {
        const json& now = row["headset"]["tip"];
        return now["pulses"] > pulses && now["amplitude"] == 0;
    }));
    const json still = tipOf(trainer);
    if (!answeredSince(trainer, before["frame"])) return false;
    CHECK(above["touches"] == touches);
    CHECK(above["pulses"] == pulses);
    CHECK(still["touching"] == true);
    CHECK(still["touches"] == touches + 1);
    return true;
}

} // namespace

TEST_CASE("a touch knocks without heat, the flame hums where metal takes its heat, and silence is kept", "[runtime]") {
    handGeometry();
    const std::filesystem::path folder = runFolder() / "feel";
    Trainee trainee;
    TrainerProcess trainer(folder, {"--headset", "--lesson", smallLesson(folder).string()});
    REQUIRE(trainer.waitFor(ready));

    // The trigger far from the metal has no effect.
    CHECK(trainee.strike(trainer, {0.0f, 0.06f, 0.02f}, [](const json& row) {
        const json& nearest = row["headset"]["tip"]["nearest_mm"]; // null while no metal is near
        return row["torch"]["trigger"] == 1 && nearest.is_number() && std::abs(nearest.get<double>() - 40) < 8;
    }));
    passFrames(trainer, 8);
    CHECK(tipOf(trainer)["action"] == "out");
    CHECK(tipOf(trainer)["pulses"] == 0);

    bool knocked = false;
    for (int attempt = 0; attempt < 10 && !knocked; ++attempt)
        knocked = knocksOnce(trainer, trainee);
    CHECK(knocked);
    const json still = tipOf(trainer);
    double knock = 0;
    for (const json& row : trainer.rows())
        knock = std::max(knock, row["headset"]["tip"]["amplitude"].get<double>());
    WARN("knock of amplitude " << knock << " in " << still["pulses"] << " pulses");

    // Heat hums, and the hum ends with the trigger.
    const glm::vec3 near(0.0f, 0.021f, 0.0f);
    trainee.aim(near, 0.0f);
    passFrames(trainer, 4);
    REQUIRE(trainee.strike(trainer, near, actionIs("burning")));
    CHECK(trainee.strike(trainer, near, [](const json& row) {
        const json& tip = row["headset"]["tip"];
        return tip["amplitude"] > 0.3 && tip["frequency"] > 100;
    }));
    trainee.aim(near, 0.0f);
    REQUIRE(trainer.waitFor(actionIs("out")));
    passFrames(trainer, 5); // the runtime takes the last pulses
    const json quiet = tipOf(trainer);
    passFrames(trainer, 5);
    CHECK(tipOf(trainer)["pulses"] == quiet["pulses"]);
    CHECK(tipOf(trainer)["amplitude"] == 0);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}
