// The judgement of a real attempt: technique, measured weld and verdict of one metal, and their form in result.json.
#include "core/base/text.hpp"
#include "core/training/trainer/result_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace meltpool;
using Json = nlohmann::json;

namespace {

constexpr float kSpeed = 6e-3f; // m/s

/// Returns a bead on a small plate, with bands for the torch of `torchAt`.
Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.widthMm = 18;
    lesson.workpiece.thicknessMm = 4;
    TechniqueBands bands;
    bands.lengthFromMm = -10;
    bands.lengthToMm = 10;
    bands.bands = {{TechniqueQuantity::aim, 0, 0.5, 2, 1}, {TechniqueQuantity::travelSpeed, 6, 0.5, 2, 1}};
    lesson.technique = bands;
    return lesson;
}

/// Returns a torch straight down, 3 mm over the plate, from x = -10 mm on; `aside` m from the seam.
TorchSample torchAt(double time, float speed, float aside) {
    TorchSample torch;
    torch.time = time;
    torch.tip = {-0.010f + speed * static_cast<float>(time), 0.003f, aside};
    torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
    torch.trigger = torch.tip.x < 0.010f ? 1.0f : 0.0f;
    return torch;
}

void weld(Trainer& trainer, float speed, float aside) {
    for (double time = 0; time * static_cast<double>(speed) < 0.0205; time += trainer.timeStep())
        trainer.advance(torchAt(time, speed, aside), nullptr);
}

Json written(Trainer& trainer, const Judgement& judgement) {
    const auto file = test::scratchFolder("judgement") / "result.json";
    ResultContext context;
    context.judgement = judgement;
    writeResult(file, trainer.lesson(), {}, context);
    return Json::parse(readTextFile(file));
}

} // namespace

TEST_CASE("an attempt is judged: the hand by the lesson's bands, the weld by the acceptance's limits", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    weld(trainer, kSpeed, 0);
    const Judgement judged = trainer.judge();
    REQUIRE(judged.score);
    CHECK(judged.score->scored);
    CHECK(judged.score->total > 90);
    CHECK(judged.score->find(TechniqueQuantity::travelSpeed)->mean == Approx(6).margin(0.1));
    REQUIRE(judged.weld);
    REQUIRE(judged.weld->stations.size() >= 5);
    REQUIRE(judged.weld->mean.height);
    CHECK(*judged.weld->mean.height > 1e-3);
    REQUIRE(judged.verdict);

    const Json json = written(trainer, judged);
    CHECK(json.at("score").at("total") == judged.score->total);
    CHECK(json.at("score").at("scored") == true);
    CHECK(json.at("score").at("parameters").at("travel_speed") ==
          judged.score->find(TechniqueQuantity::travelSpeed)->score);
    CHECK(json.at("score").at("parameters").size() == 2);
    CHECK(json.at("verdict").at("standard") == "ISO 5817");
    CHECK(json.at("verdict").at("level") == "C");
    CHECK(json.at("verdict").at("accepted") == judged.verdict->accepted);
    REQUIRE(json.at("verdict").at("items").size() == judged.verdict->items.size());
    CHECK(json.at("verdict").at("items")[0].at("name") == judged.verdict->items[0].name);
    for (const Json& item : json.at("verdict").at("items")) {
        CHECK(item.contains("rule") == (item.at("state") == "estimated"));
        if (item.at("name") != "surface_pore") continue;
        CHECK(item.at("state") == "estimated");
        CHECK(item.at("value") == 0); // 15 mm from the plate, upright
        CHECK(item.at("limit").is_null());
        CHECK_THAT(item.at("rule").get<std::string>(), test::containsText("18 mm"));
    }
    // EN 1011-1: k U I / v, with means over the time of the arc.
    const Json& arc = json.at("arc");
    CHECK(arc.at("process") == "gmaw");
    CHECK(arc.at("efficiency_en_1011_1") == 0.8);
    CHECK(arc.at("travel_speed_mm_s").get<double>() ==
          Approx(arc.at("seam_mm").get<double>() / arc.at("seconds").get<double>()));
    CHECK(arc.at("heat_input_kj_mm").get<double>() ==
          Approx(0.8 * arc.at("mean_voltage_v").get<double>() * arc.at("mean_current_a").get<double>() /
                 arc.at("travel_speed_mm_s").get<double>() * 1e-3));
    CHECK(json.at("score").at("values").at("travel_speed").at("lost_points") ==
          judged.score->find(TechniqueQuantity::travelSpeed)->lost);
    CHECK(json.at("score").at("wanted_mm") == 20);
    CHECK(json.at("weld").at("height_mm").get<double>() == Approx(*judged.weld->mean.height * 1e3));
    CHECK(json.at("weld").contains("penetration_mm"));
    CHECK_FALSE(json.at("weld").contains("leg1_mm")); // a key of fillets

    SECTION("another attempt begins without the first") {
        trainer.reset();
        CHECK(trainer.technique()->steps().empty());
        const Judgement none = trainer.judge();
        CHECK_FALSE(none.score->scored); // no arc was lit
        const Json unscored = written(trainer, none).at("score");
        CHECK(unscored.at("total").is_null());
        CHECK(unscored.at("parameters").at("travel_speed").is_null());
        CHECK(unscored.at("values").at("travel_speed").at("lost_points").is_null());
        CHECK(unscored.at("values").at("travel_speed").at("worst_at_mm").is_null());
        CHECK(unscored.at("lost_to_length_points").is_null());
    }
}

TEST_CASE("a torch beside the seam and too fast is marked down for that", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    weld(trainer, 1.5f * kSpeed, 0.0015f);
    const Judgement judged = trainer.judge();
    REQUIRE(judged.score);
    CHECK(judged.score->total < 30);
    CHECK(judged.score->find(TechniqueQuantity::aim)->mean == Approx(1.5).margin(0.05));
    CHECK(judged.score->find(TechniqueQuantity::travelSpeed)->mean == Approx(9).margin(0.2));
    REQUIRE(judged.corrections.size() == 2);
    CHECK(judged.corrections[0].quantity == TechniqueQuantity::travelSpeed);
}

TEST_CASE("an attempt in which tracking was lost under the arc is not scored, and the result says why", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    const double step = trainer.timeStep();
    for (double time = 0; time < 1.5; time += step) {
        if (std::abs(time - 0.7) < step / 2) trainer.event("torch", "lost");
        trainer.advance(torchAt(time, kSpeed, 0), nullptr);
    }
    const Judgement judged = trainer.judge();
    REQUIRE(judged.score);
    CHECK_FALSE(judged.score->scored);
    const Json json = written(trainer, judged);
    CHECK(json.at("score").at("scored") == false);
    CHECK(json.at("score").at("total").is_null());
    CHECK_THAT(json.at("score").at("reason").get<std::string>(), test::containsText("racking"));
}
