// The desk's person strikes each kind of arc with button and wheel alone, as the lesson's text says.
#include "app/session/lesson_session.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <string>

using namespace meltpool;

namespace {

/// A shipped lesson on a short piece, so that its steps take little time.
Lesson shortLesson(const std::string& name) {
    Lesson lesson = findLesson(name, test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 32;
    if (lesson.technique) lesson.technique->lengthFromMm = -6;
    return lesson;
}

} // namespace

TEST_CASE("each kind of arc is struck at the desk by button and wheel alone", "[app]") {
    const std::string name = GENERATE("gmaw-bead", "gtaw-bead", "smaw-bead", "smaw-tee");
    INFO(name);
    LessonSession session(test::shaders(), shortLesson(name), [] { return 0.0; });
    Controls controls;
    session.begin(controls);
    const double wanted = session.deskTorch().pose().distance;
    const bool touches = traitsOf(session.lesson().process).striking == Striking::touch;
    bool touched = false, burned = false;
    double since = 0; // s for which it burns
    InputFrame hand;
    for (int frame = 0; frame < 200 && since < 0.3; ++frame) {
        hand.leftHeld = frame > 4; // the lock of a lesson's begin wants a released button first
        hand.scroll = 0;
        const double now = session.deskTorch().pose().distance;
        if (touches && hand.leftHeld && !touched) hand.scroll = -1; // down to the metal
        if (touched && now < wanted) hand.scroll = 1;               // and up again
        controls.update(hand, 1.0 / 45);
        session.advance(controls, 1.0 / 45, nullptr);
        const ArcState& arc = session.run().arc();
        touched = touched || arc.noArc == NoArc::touching || arc.burns();
        burned = burned || arc.burns();
        since = arc.burns() ? since + 1.0 / 45 : 0;
    }
    CHECK(burned);
    CHECK(since >= 0.3);
    CHECK(touched);
}
