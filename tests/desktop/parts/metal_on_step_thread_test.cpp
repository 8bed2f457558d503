// Tests the metal in a context of its own, on the steps' thread: its weld equals that of one context, and the surface
// shows the metal of its moment while further steps run.
#include "app/desktop/step_thread.hpp"
#include "core/training/trainer/lesson_scene.hpp"
#include "shaders/shared/surface.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstring>

namespace meltpool {

namespace {

Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 32;
    return lesson;
}

Lesson smallClassic() {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = 2744;
    lesson.surface.cells = 16;
    return lesson;
}

/// Holds a windowless context in addition to that of the tests, which stays current here.
struct Elsewhere {
    Elsewhere() : thread(std::make_unique<HeadlessStepContext>(test::shaders().root())) { REQUIRE(thread.usable()); }
    StepThread thread;
};

void weld(Trainer& trainer, int steps) {
    for (int i = 0; i < steps; ++i)
        trainer.advanceDemonstration(nullptr);
}

/// Returns the corners of all triangles.
std::vector<SurfaceVertex> trianglesOf(const SurfaceMesh& mesh) {
    const auto indices = mesh.indices->read<std::uint32_t>(mesh.drawCommand->read<std::uint32_t>(1)[0]);
    const auto vertices = mesh.vertices->read<SurfaceVertex>(mesh.vertices->bytes() / sizeof(SurfaceVertex));
    std::vector<SurfaceVertex> corners;
    for (const std::uint32_t index : indices)
        corners.push_back(vertices.at(index));
    return corners;
}

bool same(const std::vector<SurfaceVertex>& a, const std::vector<SurfaceVertex>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(SurfaceVertex)) == 0;
}

} // namespace

TEST_CASE("a weld whose metal lies in another context has the bits of one in the window's") {
    test::context();
    Elsewhere elsewhere;
    const Lesson lesson = GENERATE(0, 1) == 0 ? smallBead() : smallClassic();
    Trainer here(test::shaders(), lesson), there(test::shaders(), lesson, &elsewhere.thread);
    LessonScene seenHere(test::shaders(), here), seenThere(test::shaders(), there);
    weld(here, 40);
    elsewhere.thread.begin([&] { weld(there, 30); });
    elsewhere.thread.wait();
    weld(there, 10); // the calling thread requests each step
    CHECK(there.result().stateHash == here.result().stateHash);
    CHECK(there.result().metal.maxTemperature == here.result().metal.maxTemperature);
    CHECK(there.result().metalBytes > here.result().metalBytes); // includes the data of the picture
    seenHere.updateSurface(nullptr);
    seenThere.updateSurface(nullptr);
    CHECK(same(trianglesOf(seenThere.surface().mesh()), trianglesOf(seenHere.surface().mesh())));
    there.reset();
    here.reset();
    CHECK(there.result().stateHash == here.result().stateHash);
}

TEST_CASE("a surface that is made beside steps is of the metal before them") {
    test::context();
    Elsewhere elsewhere;
    Trainer here(test::shaders(), smallBead()), there(test::shaders(), smallBead(), &elsewhere.thread);
    LessonScene seenHere(test::shaders(), here), seenThere(test::shaders(), there);
    for (int frame = 0; frame < 4; ++frame) {
        weld(here, 3);
        weld(there, 3);
        seenHere.updateSurface(nullptr);
        seenThere.noteMetal();
        elsewhere.thread.begin([&] { weld(there, 6); });
        seenThere.makeSurface(nullptr);
        const auto shown = trianglesOf(seenThere.surface().mesh());
        elsewhere.thread.wait();
        REQUIRE(shown.size() > 1000);
        CHECK(same(shown, trianglesOf(seenHere.surface().mesh())));
        weld(here, 6);
        seenThere.makeSurface(nullptr); // nothing was noted since
        CHECK(same(shown, trianglesOf(seenThere.surface().mesh())));
    }
}

TEST_CASE("what is saved of a metal in one context goes on in the other") {
    test::context();
    Elsewhere elsewhere;
    const Lesson lesson = GENERATE(0, 1) == 0 ? smallBead() : smallClassic();
    Trainer here(test::shaders(), lesson), there(test::shaders(), lesson, &elsewhere.thread);
    weld(there, 8);
    const Checkpoint saved = there.save();
    weld(there, 4);
    here.restore(saved);
    CHECK(here.steps() == 8);
    const Checkpoint again = here.save();
    CHECK(again.bytes == saved.bytes);
    weld(here, 4);
    CHECK(here.result().stateHash == there.result().stateHash);
    elsewhere.thread.begin([&] { there.restore(again); }); // a moved replay does this
    elsewhere.thread.wait();
    weld(there, 4);
    CHECK(here.result().stateHash == there.result().stateHash);
}

TEST_CASE("passes of a metal elsewhere are timed within the frame of the calling thread") {
    test::context();
    Elsewhere elsewhere;
    Trainer trainer(test::shaders(), smallBead(), &elsewhere.thread);
    LessonScene scene(test::shaders(), trainer);
    gl::Profiler profiler;
    for (int frame = 0; frame < 3; ++frame) {
        profiler.beginFrame();
        {
            const gl::Scope all(&profiler, "steps");
            trainer.advanceDemonstration(&profiler);
            trainer.advanceDemonstration(&profiler);
        }
        scene.updateSurface(&profiler);
        profiler.endFrame();
    }
    profiler.finish();
    for (const char* name : {"steps", "heat", "heat lattice metal", "flow", "surface"}) {
        INFO(name);
        const gl::PassTime* pass = profiler.find(name);
        REQUIRE(pass != nullptr);
        CHECK(pass->frames == 3);
        CHECK(pass->lastMs > 0);
    }
    CHECK(profiler.find("heat")->depth == 1);
    CHECK(profiler.find("heat lattice metal")->depth == 2);
}

TEST_CASE("metal that cannot be made elsewhere is refused as here") {
    test::context();
    Elsewhere elsewhere;
    Lesson lesson = smallClassic();
    lesson.setup.particles = 0;
    CHECK_THROWS_AS(Trainer(test::shaders(), lesson), std::runtime_error);
    CHECK_THROWS_AS(Trainer(test::shaders(), lesson, &elsewhere.thread), std::runtime_error);
}

} // namespace meltpool
