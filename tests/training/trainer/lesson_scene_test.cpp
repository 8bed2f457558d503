// The scene of a lesson: surface, solids and particles of its metal, and the surface distance at the tip.
#include "core/training/trainer/lesson_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <limits>

using namespace meltpool;

namespace {

constexpr int kParticles = 2744; // 14 an axis: small enough for a software driver

Lesson smallLesson() {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = kParticles;
    lesson.metal.supportRadius = 0.1f;
    lesson.surface.cells = 16;
    return lesson;
}

TorchSample flameAt(float mm, float trigger) {
    const float metres = mm * 1e-3f;
    return {0, {metres, metres, metres}, {1, 0, 0, 0}, trigger};
}

void repeat(Trainer& trainer, const TorchSample& torch, int steps) {
    for (int i = 0; i < steps; ++i)
        trainer.advance(torch, nullptr);
}

/// Returns a torch that points straight down.
TorchSample upright(const glm::vec3& tip) {
    TorchSample torch;
    torch.tip = tip;
    torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
    return torch;
}

/// Returns the GMAW lesson on a plate of 24x20 mm.
Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 32;
    return lesson;
}

} // namespace

TEST_CASE("the scene carries the surface, the particles and the source", "[training]") {
    Trainer trainer(test::shaders(), smallLesson());
    LessonScene shown(test::shaders(), trainer);
    trainer.advance(flameAt(22, 1), nullptr);
    shown.updateSurface(nullptr);
    const SceneView scene = shown.view();
    CHECK(scene.particles.count == kParticles);
    CHECK(scene.mesh.vertices != nullptr);
    CHECK(scene.source.shown);
    CHECK(scene.source.on);
    CHECK(scene.source.position.x == Approx(0.55f));
}

TEST_CASE("a plate has a soapstone line, a joint marks at both ends of its length, the classic metal none",
          "[training]") {
    const auto chalk = [](const Lesson& lesson) {
        Trainer trainer(test::shaders(), lesson);
        return LessonScene(test::shaders(), trainer).view().chalk.size();
    };
    CHECK(chalk(smallBead()) > 4);
    CHECK(chalk(smallLesson()) == 0);
    Lesson tee = smallBead();
    tee.workpiece.kind = static_cast<int>(WorkpieceKind::Tee);
    tee.technique->lengthFromMm = -8;
    tee.technique->lengthToMm = 8;
    CHECK(chalk(tee) == 7); // two marks at each end, three strokes of an arrow
}

TEST_CASE("the arc wipes the soapstone line off under it; another attempt has it again", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    LessonScene scene(test::shaders(), trainer);
    const size_t all = scene.view().chalk.size();
    TorchSample torch = upright({0, 1e-3F, 0});
    torch.trigger = 1;
    for (int i = 0; i < 400 && !trainer.arc().burns(); ++i)
        trainer.advance(torch, nullptr);
    REQUIRE(trainer.arc().burns());
    scene.updateSurface(nullptr);
    CHECK(scene.view().chalk.size() < all);
    trainer.reset();
    scene.updateSurface(nullptr);
    CHECK(scene.view().chalk.size() == all);
}

TEST_CASE("the surface of the classic metal takes up only the metal that changed", "[training]") {
    Trainer trainer(test::shaders(), smallLesson());
    LessonScene scene(test::shaders(), trainer);
    repeat(trainer, flameAt(21, 1), 60);
    scene.updateSurface(nullptr);
    REQUIRE(scene.surface().statistics().rebuilt);
    const unsigned before = scene.surface().statistics().triangles;
    trainer.advance(flameAt(21, 1), nullptr);
    scene.updateSurface(nullptr);
    const SurfaceStatistics after = scene.surface().statistics();
    CHECK(after.particles > 0);
    CHECK(after.particles < kParticles / 2);
    CHECK(after.triangles > before / 2);
}

TEST_CASE("scenes come and go while a weld is stepped, whose bits stay", "[training]") {
    Trainer seen(test::shaders(), smallBead()), unseen(test::shaders(), smallBead());
    for (int i = 0; i < 3; ++i) {
        LessonScene scene(test::shaders(), seen);
        scene.updateSurface(nullptr);
        seen.advanceDemonstration(nullptr);
        unseen.advanceDemonstration(nullptr);
        CHECK_FALSE(scene.view().solids.empty());
    }
    seen.advanceDemonstration(nullptr);
    unseen.advanceDemonstration(nullptr);
    CHECK(seen.result().stateHash == unseen.result().stateHash);
}

TEST_CASE("oxide floats where GMAW melts hot-rolled steel, and a weld's ripples are those of its process",
          "[training]") {
    Lesson lesson = smallBead();
    const auto shown = [&] { return Trainer(test::shaders(), lesson).metal().model().makeScene()->view({}); };
    const SceneView wire = shown();
    CHECK(wire.oxideRadius > 0);
    CHECK(wire.rolled.count == 1);
    CHECK(wire.ripples.frequency == equipmentOf(lesson.process).ripples.frequency);
    lesson.process.choose<Gtaw>();
    const SceneView tungsten = shown();
    CHECK(tungsten.oxideRadius == 0);
    CHECK(tungsten.ripples.frequency < wire.ripples.frequency);
    lesson.process.choose<Gmaw>();
    lesson.workpiece.metal = "304";
    CHECK(shown().oxideRadius == 0);
}

TEST_CASE("the tip is told how far the metal is and whether it is liquid, in metres", "[training]") {
    Lesson lesson = smallLesson();
    lesson.surface.cells = 64;
    Trainer trainer(test::shaders(), lesson);
    LessonScene scene(test::shaders(), trainer);
    scene.updateSurface(nullptr);
    TorchSample over = upright({0, 0.03f, 0});
    // The cube reaches to 20 mm, and its surface at this iso level a grid cell of 1.25 mm farther.
    SurfaceDistance metal = scene.distanceNow(over);
    CHECK(metal.ahead == Approx(0.009).margin(0.0015));
    CHECK(metal.nearest == Approx(metal.ahead).epsilon(0.1));
    CHECK(metal.liquid == 0);
    CHECK(metal.normal.y > 0.9f);
    over.tip = {0, 0.2f, 0};
    CHECK(scene.distanceNow(over).ahead == std::numeric_limits<float>::infinity());
    repeat(trainer, flameAt(21, 1), 60);
    scene.updateSurface(nullptr);
    over.tip = {0.017f, 0.03f, 0.017f};
    metal = scene.distanceNow(over);
    CHECK(metal.liquid > 0.2f);
    trainer.setSurfaceDistance(metal);
    repeat(trainer, flameAt(21, 1), 1);
    CHECK(trainer.arc().action == ArcAction::burning);
    CHECK(trainer.arc().liquid == metal.liquid);
}

TEST_CASE("over a steel plate the shown surface is as far as the torch is held", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    LessonScene scene(test::shaders(), trainer);
    scene.updateSurface(nullptr);
    for (const float mm : {3.0f, -1.0f, 9.0f}) {
        const TorchSample torch = upright({0.001f, mm * 1e-3f, 0.002f});
        const SurfaceDistance metal = scene.distanceNow(torch);
        INFO("held at " << mm << " mm, " << metal.ahead * 1000 << " mm found");
        CHECK(metal.ahead * 1000 == Approx(mm).margin(0.3));
        CHECK(metal.liquid == 0);
    }
}
