// The lesson's demonstration in the session: the expert's torch welds, stops, and goes to any time by itself.
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

/// A bead on a small plate of few particles.
Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 100; // length of the expert's path
    lesson.workpiece.widthMm = 14;
    lesson.workpiece.thicknessMm = 3;
    lesson.workpiece.spacingMm = 1.5f;
    lesson.surface.cells = 32;
    return lesson;
}

class Trainee {
  public:
    Trainee() : session(test::shaders(), smallBead(), [] { return 0.0; }) {}

    /// Runs frames of 1/45 s with the trainee's own torch far over the plate.
    void watch(double seconds) {
        constexpr double kFrame = 1.0 / 45;
        for (double time = 0; time < seconds; time += kFrame)
            session.advance(controls, kFrame, nullptr, [](int, int) { return TorchSample{0, {0, 0.2f, 0}}; });
    }
    double torchOff() const {
        const glm::vec3 expert = session.lesson().torch.sample(session.activities().demonstration.time()).tip;
        return static_cast<double>(glm::distance(session.run().torch().tip, expert));
    }

    Controls controls;
    LessonSession session;
};

} // namespace

TEST_CASE("a demonstration is played, paused, moved and begun again", "[app]") {
    Demonstration shown;
    CHECK_FALSE((shown.playing() || shown.welds()));
    shown.begin(4);
    CHECK((shown.playing() && shown.welds()));
    shown.reach(1.5);
    CHECK(shown.time() == 1.5);
    CHECK_FALSE(shown.takeMetalDue());
    shown.toggle();
    CHECK_FALSE(shown.playing());
    CHECK(shown.welds());
    shown.moveTo(3);
    CHECK_FALSE(shown.welds());
    CHECK(shown.takeMetalDue()); // the metal's first state, once
    CHECK_FALSE(shown.takeMetalDue());
    shown.moveTo(-2);
    CHECK(shown.time() == 0);
    shown.moveTo(9);
    CHECK(shown.time() == 4);
    CHECK_FALSE(shown.takeMetalDue());
    shown.toggle(); // at the demonstration's end
    CHECK((shown.playing() && shown.welds() && shown.time() == 0));
    CHECK(shown.takeMetalDue());
    shown.reach(5);
    CHECK(shown.time() == 4);
    CHECK_FALSE(shown.playing());
    shown.end();
    CHECK_FALSE((shown.playing() || shown.welds()));
}

TEST_CASE("the expert's torch welds in the demonstration; nothing of it is recorded, judged or the trainee's",
          "[app]") {
    const fs::path record = test::scratchFolder("demonstration") / "weld.csv";
    Trainee trainee;
    LessonSession& session = trainee.session;
    session.log().records().use(record, "program", "driver");
    session.demonstrate(trainee.controls);
    REQUIRE(session.running());
    trainee.watch(1.5);
    CHECK(session.run().steps() > 10);
    CHECK(trainee.torchOff() < 1e-4); // the trainee's hand does not lead the torch
    CHECK(session.leader() == TorchLeader::path);
    LessonFigures figures;
    fillFigures(figures, session);
    CHECK(figures.time == Approx(session.activities().demonstration.time()));
    CHECK(figures.time == Approx(1.5).margin(0.1));
    CHECK(session.run().arc().burns());
    CHECK_FALSE(session.judges());
    session.judge();
    CHECK_FALSE(session.attempt().judged());
    CHECK_FALSE(fs::exists(record));
    CHECK(session.log().records().attempt() == 0);
    Messages messages;
    Notices notices;
    TriggerLock lock;
    notices.update(session, figures, lock, 1, messages);
    CHECK(messages.shown().empty());

    SECTION("paused") {
        session.activities().demonstration.toggle();
        const size_t steps = session.run().steps();
        trainee.watch(0.5);
        CHECK(session.run().steps() == steps);
        session.activities().demonstration.toggle();
        trainee.watch(0.5);
        CHECK(session.run().steps() > steps);
        CHECK(session.activities().demonstration.time() < 2.1);
    }
    SECTION("moved: the torch goes there alone, over fresh metal, and plays on") {
        session.activities().demonstration.toggle();
        session.activities().demonstration.moveTo(4);
        trainee.watch(0.1);
        CHECK(session.run().steps() == 0);
        CHECK(trainee.torchOff() < 1e-6);
        fillFigures(figures, session);
        CHECK(figures.molten == 0);
        session.activities().demonstration.toggle();
        trainee.watch(1);
        CHECK(session.activities().demonstration.time() == Approx(5).margin(0.1));
        CHECK(trainee.torchOff() < 1e-6);
        CHECK(session.run().steps() == 0);
        session.activities().demonstration.again();
        trainee.watch(0.5);
        CHECK(session.run().steps() > 10);
        CHECK(session.activities().demonstration.time() < 0.6);
    }
    SECTION("one's own attempt follows with a record of its own, on fresh metal") {
        session.reset(trainee.controls);
        CHECK_FALSE(session.activities().at(session.activities().demonstration));
        CHECK(session.run().steps() == 0);
        CHECK(session.judges());
        trainee.watch(0.2);
        CHECK(session.leader() == TorchLeader::hand);
        CHECK(session.log().records().attempt() == 1);
        CHECK(fs::exists(record));
    }
    SECTION("an attempt for score is measured first") {
        session.sections().attempt.forScore = true;
        session.reset(trainee.controls);
        CHECK_FALSE(session.activities().at(session.activities().demonstration));
        CHECK(session.question().asked());
    }
}

TEST_CASE("a lesson without a torch path has no demonstration", "[app]") {
    Lesson lesson = smallBead();
    lesson.torch = {};
    LessonSession session(test::shaders(), std::move(lesson), [] { return 0.0; });
    Controls controls;
    session.demonstrate(controls);
    CHECK_FALSE(session.running());
}
