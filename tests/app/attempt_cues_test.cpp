// Cues in the session: drawn next to the torch in an attempt, noted in the record and the score, absent from a test.
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/base/text.hpp"
#include "tests/app/seam_hand.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

class Welder {
  public:
    explicit Welder(const fs::path& record = {}) : session(test::shaders(), test::smallBead(), [] { return 0.0; }) {
        session.log().records().use(record, "program", "driver");
        session.begin(controls);
    }

    void lead(double seconds, float trigger, float height = test::SeamHand::kHeight) {
        hand_.lead(session, controls, seconds, trigger, height);
    }
    /// Starts another attempt at the seam's beginning.
    void again() {
        session.reset(controls);
        hand_.goBack();
    }
    size_t markers(CueNaming naming = CueNaming::none) {
        const SceneView scene = session.picture().scene(nullptr);
        return session.picture().cueMarkers(scene, controls.view(1.5F), naming).size();
    }

    Controls controls;
    LessonSession session;

  private:
    test::SeamHand hand_;
};

} // namespace

TEST_CASE("an attempt's record and help tell its cues: all, those left on, and none in a test", "[app]") {
    const fs::path folder = test::scratchFolder("cues"), first = folder / "weld.csv";
    Welder welder(first);
    welder.lead(0.1, 0);
    CHECK(welder.markers() > 5);
    CHECK(welder.session.attempt().cues().used().empty()); // no arc yet
    welder.lead(1, 1);
    CHECK(welder.markers() > 10);
    CHECK(welder.session.attempt().cues().used() == CueSet::all());
    setParameter(welder.session.help().cues.parameters, "seam", "false", "test");
    setParameter(welder.session.help().cues.parameters, "aim", "false", "test");
    welder.lead(0.1, 1);
    welder.again();
    welder.lead(0.3, 1);
    CHECK(welder.session.attempt().cues().used().names() == "speed angles distance arc");

    welder.session.sections().attempt.forScore = true;
    welder.again();
    welder.lead(0.5, 1);
    CHECK(welder.session.run().arc().burns());
    CHECK(welder.markers() == 0);
    CHECK(welder.session.attempt().cues().used().empty());
    welder.session.end("done");
    const std::string one = readTextFile(first), two = readTextFile(folder / "weld-2.csv"),
                      three = readTextFile(folder / "weld-3.csv");
    CHECK_THAT(one, test::containsText("# event cues speed angles distance aim seam arc\n"));
    CHECK_THAT(one, test::containsText("# event cues speed angles distance arc\n"));
    CHECK_THAT(two, test::containsText("# event cues speed angles distance arc\n"));
    CHECK(three.find("event cues") == std::string::npos);
}

TEST_CASE("cues fade with the trainee's skill from the next attempt on; each attempt counts once", "[app]") {
    Welder welder;
    welder.lead(2, 1);
    welder.lead(1.2, 0);
    REQUIRE(welder.session.attempt().judged());
    REQUIRE(welder.session.attempt().judged()->judgement.score);
    const CueSkill expected = CueSkill().after(*welder.session.attempt().judged()->judgement.score);
    CHECK(welder.session.attempt().cues().skill() == expected);
    CHECK(expected.good(TechniqueQuantity::travelSpeed) == 1);
    welder.session.judge(); // judges the same attempt once more
    CHECK(welder.session.attempt().cues().skill() == expected);

    CueSkill master;
    for (const CuedQuantity& cued : cuedQuantities())
        master.setGood(cued.quantity, CueSkill::kMastered);
    welder.session.attempt().cues().setSkill(master);
    welder.again();
    welder.lead(0.5, 1);
    CHECK(welder.markers() == 0);
    CHECK(welder.session.attempt().cues().used().names() == "arc");

    AttemptCues& cues = welder.session.attempt().cues();
    CHECK(cues.faded().names() == "speed angles distance aim seam");
    cues.toggleFaded();
    welder.lead(0.2, 1);
    CHECK(welder.markers() > 5);
    CHECK(cues.used() == CueSet::all());
    cues.toggleFaded();
    welder.lead(0.2, 1);
    CHECK(welder.markers() == 0);
    cues.toggleFaded();
    welder.again(); // hidden again in the next attempt
    welder.lead(0.2, 1);
    CHECK(welder.markers() == 0);
    welder.session.open(test::smallBead()); // another lesson starts without knowledge of the trainee
    CHECK(welder.session.attempt().cues().skill() == CueSkill());
}

TEST_CASE("hidden cues are told before the arc at the desk, until they are shown", "[app]") {
    Welder welder;
    CueSkill skill;
    skill.setGood(TechniqueQuantity::distance, CueSkill::kMastered);
    welder.session.attempt().cues().setSkill(skill);
    welder.again();
    Notices notices;
    Messages messages;
    LessonFigures figures;
    const TriggerLock unlocked;
    const auto told = [&] {
        welder.session.advance(welder.controls, 0.1, nullptr);
        notices.update(welder.session, figures, unlocked, 0.1, messages);
        std::string all;
        for (const Message& message : messages.shown())
            all += message.text;
        return all;
    };
    CHECK_THAT(told(), test::containsText("Hidden") && test::containsText("distance"));
    CHECK(told().find("speed") == std::string::npos);
    welder.session.attempt().cues().toggleFaded();
    CHECK(told().find("Hidden") == std::string::npos);
}

TEST_CASE("the fields on the board have their names until the person has made progress with all", "[app]") {
    Welder welder;
    const auto named = [&] {
        welder.lead(0.4, 1);
        welder.session.picture().atDesk(welder.controls, 1.5F, {}, false, nullptr);
        CueSet names;
        for (const NamedCue& cue : welder.session.picture().namedCues()) {
            names.set(cue.kind);
            CHECK(cue.width > 0);
        }
        return names.names();
    };
    CHECK(named() == "speed angles distance aim");
    CHECK(welder.markers(CueNaming::whileNew) > welder.markers(CueNaming::none) + 40); // a letter has several
    CueSkill skill;
    skill.setGood(TechniqueQuantity::aim, 1);
    skill.setGood(TechniqueQuantity::workAngle, 1); // the travel angle is new
    welder.session.attempt().cues().setSkill(skill);
    CHECK(named() == "speed angles distance aim");
    for (const TechniqueQuantity each :
         {TechniqueQuantity::travelSpeed, TechniqueQuantity::travelAngle, TechniqueQuantity::distance})
        skill.setGood(each, 1);
    welder.session.attempt().cues().setSkill(skill);
    CHECK(named() == "");
    CHECK(welder.markers(CueNaming::whileNew) == welder.markers(CueNaming::none));
}

TEST_CASE("a lesson shows the cues that it allows and can measure, and menus only those", "[app]") {
    Lesson lesson = test::smallBead();
    lesson.cues = {};
    lesson.cues.set(CueKind::aim);
    lesson.cues.set(CueKind::speed);
    std::erase_if(lesson.technique->bands,
                  [](const TechniqueBand& band) { return band.quantity == TechniqueQuantity::travelSpeed; });
    Welder welder;
    welder.session.open(lesson);
    welder.session.begin(welder.controls);
    welder.lead(0.3, 1);
    CHECK(welder.session.attempt().cues().used().names() == "aim");
    size_t shown = 0;
    for (const Parameter& parameter : welder.session.help().cues.parameters)
        shown += welder.session.help().cues.shows(parameter) ? 1 : 0;
    CHECK(shown == 1);
    welder.session.open(findLesson("classic", test::shippedLessons()));
    for (const Parameter& parameter : welder.session.help().cues.parameters)
        CHECK_FALSE(welder.session.help().cues.shows(parameter));
}

TEST_CASE("why the arc is out is told unless that cue is off; a demonstration has no cues", "[app]") {
    Welder welder;
    const TriggerLock unlocked;
    const auto told = [&] {
        Notices notices;
        Messages messages;
        LessonFigures figures;
        for (int i = 0; i < 10; ++i)
            notices.update(welder.session, figures, unlocked, 0.1, messages);
        return !messages.shown().empty();
    };
    welder.lead(0.5, 1);
    REQUIRE(welder.session.run().arc().burns());
    welder.lead(0.4, 1, 40e-3F);
    REQUIRE_FALSE(welder.session.run().arc().burns());
    const size_t sign = welder.markers();
    INFO(noArcName(welder.session.run().arc().noArc));
    CHECK(told());
    setParameter(welder.session.help().cues.parameters, "arc", "false", "test");
    welder.lead(0.03, 1, 40e-3F);
    CHECK_FALSE(told());
    CHECK(welder.markers() < sign);
    welder.session.demonstrate(welder.controls);
    welder.lead(0.3, 0);
    CHECK(welder.markers() == 0);
}
