// The section of a result: equal to validation's measurement, number by number, and present for every weld lesson.
#include "core/base/text.hpp"
#include "core/training/trainer/result_file.hpp"
#include "core/training/trainer/weld_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;
using Json = nlohmann::json;

namespace {

Lesson shipped(const std::string& name) {
    return findLesson(name, test::testFolder().parent_path() / "app" / "data" / "lessons");
}

/// Returns a small plate under a stationary torch over its middle.
Lesson smallBead() {
    Lesson lesson = shipped("gmaw-bead");
    lesson.workpiece.lengthMm = 20;
    lesson.workpiece.widthMm = 16;
    lesson.workpiece.thicknessMm = 4;
    return lesson;
}

Json written(Lesson& lesson, const std::optional<WeldSection>& section) {
    const auto file = test::scratchFolder("section") / "result.json";
    ResultContext context;
    context.section = section;
    writeResult(file, lesson, {}, context);
    return Json::parse(readTextFile(file));
}

} // namespace

TEST_CASE("result.json and validation measure the same section of the same metal", "[training]") {
    Lesson lesson = smallBead();
    WeldModel model(test::shaders(), lesson);
    const TorchSample torch{0, {0, 0.003F, 0}, glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0)), 1};
    for (double time = 0; time < 0.5; time += model.timeStep())
        model.step(torch, nullptr);
    const Json json = written(lesson, model.section(0.0)).at("section");
    const Material steel = workpieceMaterial(lesson.workpiece);
    const Section section = measureSection(model.metal().state(), makeWorkpiece(lesson.workpiece).seeds,
                                           sectionCut(steel, -kSectionLength / 2, kSectionLength / 2));
    REQUIRE(section.fusion.depth > 0);
    REQUIRE(section.heatAffected);
    REQUIRE(section.bead);
    REQUIRE(section.bead->toes);
    CHECK(json.at("layers") == 5);
    CHECK(json.at("fused_width_mm") == section.fusion.width * 1e3);
    CHECK(json.at("toe_width_mm") == section.bead->toeWidth() * 1e3);
    CHECK(json.at("reinforcement_mm2") == section.bead->reinforcement * 1e6);
    CHECK(json.at("edge_angle_left_deg").get<double>() ==
          Approx((*section.bead->toes)[0].angle * 180 / 3.14159265358979));
    CHECK(json.at("edge_angle_right_deg").get<double>() ==
          Approx((*section.bead->toes)[1].angle * 180 / 3.14159265358979));
    CHECK(json.at("overlap_left_mm") == section.bead->overlap(section.fusion.stretch)[0] * 1e3);
    CHECK(json.at("overlap_right_mm") == section.bead->overlap(section.fusion.stretch)[1] * 1e3);
    CHECK(json.at("penetration_mm") == section.fusion.depth * 1e3);
    CHECK(json.at("height_mm") == section.bead->height * 1e3);
    CHECK(json.at("deposited_mm2") == section.deposited * 1e6);
    CHECK(json.at("fused_plate_mm2") == section.fusion.area * 1e6);
    CHECK(json.at("heat_affected_width_mm") == section.heatAffected->width * 1e3);
    CHECK(json.at("heat_affected_depth_mm") == section.heatAffected->depth * 1e3);
    CHECK(json.at("fusion").at("depth_mm") == section.fusion.box.depth * 1e3);
}

TEST_CASE("every weld lesson has a section, whether or not a picture cuts it; only steel has a heat-affected zone",
          "[training]") {
    for (const std::string name : {"gmaw-bead", "tee-fillet", "solder-cube", "solder-bridge"}) {
        INFO(name);
        Lesson lesson = shipped(name);
        lesson.workpiece.spacingMm = 2;
        const bool steel = lesson.workpiece.metal == "s235";
        const Trainer trainer(test::shaders(), lesson);
        const auto section = trainer.section();
        REQUIRE(section);
        CHECK(section->cut.at() == Approx(name == "solder-cube" ? 0.014 : 0).margin(1e-6));
        CHECK(section->figures.layers > 0);
        CHECK(section->figures.fusion.area == 0); // no metal is welded yet
        const Json json = written(lesson, section).at("section");
        CHECK(json.contains("heat_affected") == steel);
        CHECK(json.contains("heat_affected_depth_mm") == steel);
        CHECK(json.contains("height_mm") == (name != "tee-fillet"));
        CHECK(json.contains("root_fusion_mm") == (name == "tee-fillet"));
        CHECK_FALSE(json.contains("leg_lying_mm")); // a corner without weld
        CHECK(json.at("fusion").size() == 4);
        lesson.pictures = {{"plain", lesson.look, lesson.camera}};
        CHECK(Trainer(test::shaders(), lesson).section()->cut.at() == Approx(0).margin(1e-6));
    }
    Lesson classic = shipped("classic");
    classic.setup.particles = 64;
    CHECK_FALSE(Trainer(test::shaders(), classic).section().has_value());
}
