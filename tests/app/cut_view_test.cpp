// The cut weld in the session: place, stations, camera, and the metal's pause.
#include "app/session/cut_stand.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/render/picture_target.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

constexpr double kFrame = 1.0 / 45;

class Welder {
  public:
    Welder() : session(test::shaders(), test::smallBead(), [] { return 0.0; }) { session.begin(controls); }

    /// Leads the torch along the seam for `seconds`, 3 mm over the plate, at 8 mm/s while the trigger is pulled.
    void lead(double seconds, float trigger) {
        for (double time = 0; time < seconds; time += kFrame)
            session.advance(controls, kFrame, nullptr, [&](int, int steps) {
                if (trigger > 0) x_ += 8e-3f * static_cast<float>(kFrame / steps);
                TorchSample torch;
                torch.tip = {x_, 0.003f, 0};
                torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
                torch.trigger = trigger;
                return torch;
            });
    }

    /// Runs a frame at the desk with this input.
    void frame(const InputFrame& input) {
        controls.update(input, kFrame);
        session.advance(controls, kFrame, nullptr);
    }

    Controls controls;
    LessonSession session;

  private:
    float x_ = -0.010f; ///< m
};

const WeldStation* stationNear(const LessonSession& session, double place) {
    const auto& stations = session.attempt().judged()->judgement.weld->stations;
    const auto found = std::min_element(stations.begin(), stations.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.place - place) < std::abs(b.place - place);
    });
    return &*found;
}

const SectionMark* markOf(const CutView& cut, const std::string& words) {
    for (const SectionMark& mark : cut.marks())
        if (mark.label.rfind(words, 0) == 0 && mark.kind == SectionMark::Kind::length) return &mark;
    return nullptr;
}

} // namespace

TEST_CASE("the judged weld is cut open with the verdict's own stations, and the metal waits", "[app]") {
    Welder welder;
    LessonSession& session = welder.session;
    CutView& cut = session.picture().cut();
    welder.lead(2, 1);
    CHECK_FALSE(session.cuts()); // the arc burns
    session.toggleCut(welder.controls);
    CHECK_FALSE(cut.shown());
    welder.lead(1.5, 0);
    REQUIRE(session.attempt().judged());
    const OrbitCamera before = welder.controls.orbitCamera();
    session.toggleCut(welder.controls);
    REQUIRE(cut.shown());
    CHECK(cut.judged());
    REQUIRE(cut.station() != nullptr);
    const size_t steps = session.run().steps();

    // The slider acts through the session: station and picture follow it.
    for (const double wanted : {-4e-3, 0.0, 3e-3}) {
        INFO(wanted);
        cut.moveTo(wanted);
        welder.frame({});
        REQUIRE(cut.station() != nullptr);
        const WeldStation* station = stationNear(session, wanted);
        CHECK(cut.station()->place == station->place);
        CHECK(cut.station()->toeWidth == station->toeWidth);
        CHECK(session.picture().scene(nullptr).section.shown);
        CHECK(static_cast<double>(session.picture().scene(nullptr).section.at) == Approx(wanted).margin(1e-7));
        REQUIRE(session.picture().scene(nullptr).section.map != nullptr);
        const SectionMark* toes = markOf(cut, "toe to toe");
        REQUIRE(toes != nullptr);
        CHECK(static_cast<double>(glm::distance(toes->from, toes->to)) == Approx(*station->toeWidth));
    }
    CHECK(session.run().steps() == steps);
    CHECK(session.attempt().judged()); // the judgement remains

    // Arrow keys and a dragged mouse move the cut.
    InputFrame input;
    input.pressed = {Key::left, Key::left};
    welder.frame(input);
    CHECK(cut.place() == Approx(1e-3));
    input = {};
    input.dragMove = {25, 0};
    welder.frame(input);
    CHECK(cut.place() == Approx(3.5e-3));
    cut.moveTo(1);
    CHECK(cut.place() == Approx(15e-3)); // the plate's end
    welder.frame({});
    CHECK(cut.station() == nullptr); // the place is outside the judged seam
    CHECK(cut.marks().empty());

    // The camera looks squarely at the cut, from the side that is removed.
    const glm::vec3 forward = welder.controls.orbitCamera().forward();
    CHECK(glm::distance(forward, glm::vec3(-1, 0, 0)) < 1e-4f);
    session.toggleCut(welder.controls);
    CHECK_FALSE(cut.shown());
    CHECK_FALSE(session.picture().scene(nullptr).section.shown);
    CHECK(glm::distance(welder.controls.orbitCamera().forward(), before.forward()) < 1e-5f);
    welder.lead(0.2, 0);
    CHECK(session.run().steps() > steps);

    session.toggleCut(welder.controls);
    session.reset(welder.controls);
    CHECK_FALSE(cut.shown());
    CHECK(glm::distance(welder.controls.orbitCamera().forward(), before.forward()) < 1e-5f);
    welder.lead(0.2, 0);
    CHECK(session.run().steps() > 0);
}

TEST_CASE("a weld that is not judged is cut with the figures of the cut itself; a pause lets it be cut in between",
          "[app]") {
    Welder welder;
    LessonSession& session = welder.session;
    welder.lead(1.2, 1);
    REQUIRE(session.run().arc().burns());
    CHECK_FALSE(session.cuts());
    Notices notices;
    const auto toldSlow = [&] {
        LessonFigures figures;
        Messages messages;
        for (int i = 0; i < 10; ++i) {
            figures.speed = 0.1;
            notices.update(session, figures, {}, 0.1, messages);
        }
        return !figures.slow.empty();
    };
    CHECK(toldSlow());
    welder.controls.setMode(Mode::view);
    welder.frame({});
    REQUIRE(session.cuts());
    CHECK_FALSE(toldSlow()); // paused metal counts as full speed
    session.toggleCut(welder.controls);
    REQUIRE(session.picture().cut().shown());
    CHECK(welder.controls.mode() == Mode::interact); // the cut has its own camera
    CHECK_FALSE(session.picture().cut().judged());
    session.picture().cut().moveTo(-5e-3);
    welder.frame({});
    CHECK_FALSE(toldSlow());
    REQUIRE(session.picture().cut().station() != nullptr);
    CHECK(*session.picture().cut().station()->penetration > 0);
    CHECK_THAT(cutNote(session.picture().cut()), test::containsText("not judged yet"));
    session.toggleCut(welder.controls);
    CHECK(welder.controls.mode() == Mode::view);
}

TEST_CASE("the headset turns the section to the reader, large enough, upright and clear of the table", "[app]") {
    const float table = 0.9f;
    const glm::mat4 lies = glm::translate(glm::mat4(1), glm::vec3(0.1f, table + 0.01f, -0.05f)); // workpiece at size 1
    const CutFace face{0.004f, {0, 1}, 0.006f, {-0.03f, -0.01f, -0.02f}, {0.03f, 0.014f, 0.02f}};
    const glm::mat4 stand = standOfCut(lies, face, table);
    const auto at = [&](float x, float y, float z) { return glm::vec3(stand * glm::vec4(x, y, z, 1)); };
    CHECK(glm::distance(at(0.004f, 0, 0.003f), at(0.004f, 0, -0.003f)) == Approx(0.12f));
    const glm::vec3 out = glm::normalize(at(1, 0, 0) - at(0, 0, 0)), up = at(0, 1, 0) - at(0, 0, 0);
    CHECK(out.z > 0.9f); // towards the person in front of the table
    CHECK(out.y > 0.2f); // the person's eyes are higher
    CHECK(up.y > 0);
    CHECK(up.x == Approx(0).margin(1e-6));
    CHECK(at(0, 0, 1).x < at(0, 0, 0).x); // not mirrored: the welder's side is on the left, as at the desk
    for (const float x : {face.low.x, face.at})
        for (const float y : {face.low.y, face.high.y})
            for (const float z : {face.low.z, face.high.z})
                CHECK(at(x, y, z).y > table);
    // An enlarged workpiece does not change its size.
    const glm::mat4 large = standOfCut(glm::scale(lies, glm::vec3(25)), face, table);
    CHECK(glm::length(glm::vec3(large[0])) == Approx(25));
}

TEST_CASE("neither a classic lesson nor a pipe is cut open", "[app]") {
    Lesson lesson = test::smallBead();
    CHECK(CutView::canCut(lesson));
    lesson.workpiece.kind = static_cast<int>(WorkpieceKind::Pipe);
    CHECK_FALSE(CutView::canCut(lesson));
    lesson.model = LessonModel::Classic;
    lesson.workpiece.kind = static_cast<int>(WorkpieceKind::Plate);
    CHECK_FALSE(CutView::canCut(lesson));
}
