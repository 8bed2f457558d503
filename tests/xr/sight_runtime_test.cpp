// Takes pictures of both eyes at work: each process with its arc burning, seen by three persons and a left-handed one.
// Not among the ordinary tests: somebody has to look at the pictures, where the pool must be free.
// Full size needs MELTPOOL_XR_SCREEN=2560x1440x24 and XRT_COMPOSITOR_XCB_FULLSCREEN=1 in the environment:
//   MELTPOOL_XR_PICTURES=FOLDER tests/xr/run_on_monado.sh build/release/bin/test_xr_runtime "[pictures]"
// MELTPOOL_XR_LESSON names one of its lessons alone.
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"
#include "tests/xr/trainee.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

struct Person {
    const char* name;
    float eyes; ///< height of the eyes over the floor, m
    size_t hand;
};

/// Returns the torch's orientation along the path's axis, with the handle on the side of the person's hand.
glm::quat heldAlong(const TorchSample& sample, size_t hand) {
    const glm::vec3 back = -sample.axis(), aside(hand == 1 ? 0.75F : -0.75F, 0, 0.65F);
    const glm::vec3 down = -glm::normalize(aside - back * glm::dot(aside, back));
    return glm::quat_cast(glm::mat3(glm::cross(down, back), down, back));
}

/// Follows the expert's path in the metal's own time.
void follow(Trainee& trainee, TrainerProcess& trainer, const TorchPath& path, double from, double to) {
    const double begin = trainer.now()["metal"]["time"];
    constexpr double kStride = 0.05;
    for (double at = from; at < to; at += kStride) {
        const TorchSample sample = path.sample(at);
        trainee.held = heldAlong(sample, trainee.hand);
        trainee.aim(sample.tip, sample.trigger);
        REQUIRE(trainer.waitFor([&](const json& row) { return row["metal"]["time"] >= begin + at - from; }));
        INFO(at << " s of the path: " << trainer.now()["headset"].dump() << trainer.now()["torch"].dump());
        // A gap of the runtime puts the arc out.
        if (trainer.now()["headset"]["trigger_locked"] == false) continue;
        const bool freed = trainee.strike(trainer, sample.tip,
                                          [](const json& row) { return row["headset"]["trigger_locked"] == false; });
        if (!freed) keepPicture(screenshot(), "sight-locked.png");
        REQUIRE(freed);
    }
}

/// Lifts a covered electrode off the place that it touches until its arc burns; where frames are slow it may stick
/// first.
void liftElectrode(Trainee& trainee, TrainerProcess& trainer, const glm::vec3& lifted) {
    const auto burns = [](const json& row) { return row["headset"]["tip"]["action"] == "burning"; };
    const auto hold = [&](float over, float trigger) {
        trainee.aim(lifted + glm::vec3(0, over, 0), trigger);
        passFrames(trainer, 2);
    };
    for (int attempt = 0; attempt < 10; ++attempt) {
        hold(0.005F, 0);
        hold(0.001F, 1);
        trainee.aim(lifted - glm::vec3(0, 0.0032F, 0), 1);
        sleepFor(0.12); // one or two frames
        trainee.aim(lifted, 1);
        if (comesTrue(trainer, 6, burns)) return;
        INFO(trainer.now()["headset"]["tip"].dump() << trainer.now()["headset"]["notice"]);
        CHECK(attempt < 9);
    }
}

glm::vec3 placeIn(const json& row, const char* name) {
    const json& at = row["headset"][name];
    return {at[0].get<float>(), at[1].get<float>(), at[2].get<float>()};
}

/// Checks that notice and caption hang above the end of the torch, to which an electrode has burned: the cues' board, a
/// gap and half the notice's height above it, in shares of the distance from the head.
void checkNotice(const json& row, const xr::Pose& head) {
    if (row["headset"]["tip"]["action"] == "out") return; // a slow frame put the arc out
    const glm::vec3 notice = placeIn(row, "notice_at"), end = placeIn(row, "end_at");
    constexpr float kRaise = 0.306F;
    CHECK(glm::distance(notice, end) / glm::distance(head.position, end) == Approx(kRaise).margin(0.01));
}

} // namespace

TEST_CASE("pictures of both eyes at work, in each process, from three persons' heads", "[by_hand][pictures]") {
    handGeometry();
    const std::string name = GENERATE("gmaw-bead", "tee-fillet", "gtaw-bead", "smaw-bead", "solder-joint");
    const Person person =
        GENERATE(Person{"155", 1.44F, 1}, Person{"195", 1.83F, 1}, Person{"seated", 1.2F, 1}, Person{"left", 1.6F, 0});
    if (const char* only = std::getenv("MELTPOOL_XR_LESSON"); only != nullptr && name != only) return;
    const Lesson lesson = readLesson(test::sourceFolder() / "app" / "data" / "lessons" / (name + ".toml"));
    Trainee trainee;
    trainee.hand = person.hand;
    trainee.bottom = makeWorkpiece(lesson.workpiece).floorHeight;
    trainee.zoom = 1;
    trainee.fixture = beforeFace(fixtureOf(lesson.workpiece));
    trainee.stance = stanceFor(trainee.fixture, lesson.torch);
    trainee.torch = torchGeometry(lesson.process);
    trainee.tableTop = trainee.tableHeight = person.eyes - Workshop::kDrop;
    trainee.state.head.position = {0, person.eyes, 0};
    const double strike = lesson.torch.firstPull().value();
    trainee.held = heldAlong(lesson.torch.sample(strike), person.hand);
    trainee.aim({0.08F, 0.1F, 0.08F}, 0);
    const std::string run = name + "-" + person.name;
    TrainerProcess trainer(runFolder() / run, {"--headset", "--lesson", name},
                           std::string("resolution_scale = 1\nsamples = 2\n") +
                               (person.hand == 0 ? "hand = \"left\"\n" : ""),
                           {}, "[sound]\ncaptions = true\n");
    REQUIRE(trainer.waitFor(ready));
    trainee.state.head.position = {0, person.eyes - 0.05F, -0.03F};
    trainee.state.head.orientation = glm::angleAxis(-0.8F, glm::vec3(1, 0, 0));
    follow(trainee, trainer, lesson.torch, std::max(0.0, strike - 0.5), strike);
    keepPicture(screenshot(), "sight-" + run + "-before.png");
    double from = strike;
    if (traitsOf(lesson.process).torch == TorchShape::electrodeHolder) {
        constexpr double kLifted = 0.25; // s after the pull
        from += kLifted;
        trainee.held = heldAlong(lesson.torch.sample(from), person.hand);
        liftElectrode(trainee, trainer, lesson.torch.sample(from).tip);
    }
    follow(trainee, trainer, lesson.torch, from, strike + 2.5);
    const json row = trainer.now();
    WARN(run << ": " << row["headset"].dump() << row["torch"].dump());
    checkNotice(row, trainee.state.head);
    keepPicture(screenshot(), "sight-" + run + ".png");
    CHECK(trainer.stop() == 0);
}
