// The ghost in the session: drawn next to the torch in an attempt, noted in the record and the score, absent from a
// test, and without effect on the metal.
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/base/text.hpp"
#include "core/scene/ghost_model.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/app/seam_hand.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

class Welder {
  public:
    explicit Welder(GhostChoice ghost, const fs::path& record = {}, const Lesson& lesson = test::smallBead())
        : session(test::shaders(), lesson, [] { return 0.0; }) {
        session.log().records().use(record, "program", "driver");
        session.attempt().ghost().parameters.ghost = static_cast<int>(ghost);
        session.attempt().ghost().findBestBy([this](const std::string& key) {
            asked = key;
            return best;
        });
    }

    void lead(double seconds, float trigger) { hand_.lead(session, controls, seconds, trigger); }
    void frame(double seconds, float trigger) { hand_.frame(session, controls, seconds, trigger); }
    void begin() { session.begin(controls); }
    /// Starts another attempt at the seam's beginning.
    void again() {
        session.reset(controls);
        hand_.goBack();
    }
    std::vector<Marker> ghost() {
        const SceneView scene = session.picture().scene(nullptr);
        const auto markers = session.picture().ghostMarkers(scene, controls.view(1.5F));
        return {markers.begin(), markers.end()};
    }
    /// Number of dark grounds of words and name beside the ghost.
    std::ptrdiff_t grounds() {
        const std::vector<Marker> markers = ghost();
        return std::count_if(markers.begin(), markers.end(), [](const Marker& m) { return m.colour.g < 0.1F; });
    }
    std::string words() const {
        std::string all;
        for (size_t i = 0; i < session.attempt().ghost().words().lines(); ++i)
            all += std::string(session.attempt().ghost().words().line(i)) + "\n";
        return all;
    }
    std::string fault() const { return std::string(session.attempt().ghost().fault()); }
    double place() const { return static_cast<double>(hand_.place()); }

    std::string asked; ///< lesson that the best attempt was requested for
    fs::path best;
    Controls controls;
    LessonSession session;

  private:
    test::SeamHand hand_;
};

} // namespace

TEST_CASE("the expert's ghost stands at the torch's place, is told to the record, and a test has none", "[app]") {
    const fs::path folder = test::scratchFolder("ghost"), first = folder / "weld.csv";
    Welder welder(GhostChoice::expert, first);
    welder.begin();
    welder.lead(0.1, 0);
    CHECK(welder.ghost().size() > 3);
    CHECK(welder.session.attempt().ghost().used().empty()); // no arc yet
    welder.lead(1.2, 1);
    REQUIRE(welder.session.attempt().ghost().moment());
    CHECK(welder.session.attempt().ghost().moment()->place ==
          Approx(welder.place()).margin(2e-3)); // the ghost follows with a small delay
    CHECK(welder.session.attempt().ghost().used() == "expert");
    INFO(welder.words());
    CHECK_THAT(welder.words(), test::containsText("travel angle 10\xC2\xB0 less\n"));
    CHECK(welder.grounds() == 2); // words and name
    welder.session.sections().attempt.forScore = true;
    welder.again();
    welder.lead(0.3, 1);
    CHECK(welder.session.run().arc().burns());
    CHECK(welder.ghost().empty());
    CHECK(welder.session.attempt().ghost().used().empty());
    welder.session.sections().attempt.forScore = false;
    welder.session.demonstrate(welder.controls);
    welder.lead(0.1, 0);
    CHECK(welder.ghost().empty());
    welder.session.end("done");
    CHECK_THAT(readTextFile(first), test::containsText("# event ghost expert place\n"));
    CHECK(readTextFile(folder / "weld-2.csv").find("event ghost") == std::string::npos);
}

TEST_CASE("a ghost changes no bit of the metal", "[app]") {
    const fs::path folder = test::scratchFolder("ghost-bits");
    std::vector<std::string> hashes;
    for (const GhostChoice choice : {GhostChoice::none, GhostChoice::expert}) {
        const fs::path record = folder / (std::string(ghostName(choice)) + ".csv");
        Welder welder(choice, record);
        welder.begin();
        welder.lead(0.5, 1);
        CHECK(welder.ghost().empty() == (choice == GhostChoice::none));
        welder.session.end("done");
        const auto attempt = readRecordedAttempt(record);
        REQUIRE(attempt);
        REQUIRE_FALSE(attempt->stateHash.empty());
        hashes.push_back(attempt->stateHash);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a ghost fades as cues do, and a master has none", "[app]") {
    Welder welder(GhostChoice::expert);
    CueSkill skill;
    for (const CuedQuantity& cued : cuedQuantities())
        skill.setGood(cued.quantity, CueSkill::kMastered / 2);
    welder.session.attempt().cues().setSkill(skill);
    welder.begin();
    welder.lead(0.1, 1);
    REQUIRE_FALSE(welder.ghost().empty());
    CHECK(welder.ghost().front().opacity == Approx(kGhostOpacity / 2));
    for (const CuedQuantity& cued : cuedQuantities())
        skill.setGood(cued.quantity, CueSkill::kMastered);
    welder.session.attempt().cues().setSkill(skill);
    welder.again();
    welder.lead(0.1, 1);
    CHECK(welder.ghost().empty());
    CHECK(welder.session.attempt().ghost().used().empty());
}

TEST_CASE("the best kept attempt and a named file are ghosts too; what is missing is told for a while", "[app]") {
    const fs::path folder = test::scratchFolder("ghost-files"), kept = folder / "kept.csv";
    {
        Welder welder(GhostChoice::none, kept);
        welder.begin();
        welder.lead(0.3, 1);
        CHECK(welder.ghost().empty());
    }
    REQUIRE(readRecordedAttempt(kept));
    Welder welder(GhostChoice::best);
    welder.begin();
    welder.lead(0.05, 1);
    CHECK(welder.asked == "gmaw-bead");
    CHECK_THAT(welder.fault(), test::containsText("no scored attempt"));
    Notices notices;
    Messages messages;
    LessonFigures figures;
    const TriggerLock unlocked;
    notices.update(welder.session, figures, unlocked, 0.1, messages);
    REQUIRE(messages.shown().size() == 1);
    CHECK_THAT(messages.shown().front().text, test::containsText("There is no ghost"));
    welder.frame(9, 0); // s; the metal simulates only a part of them
    notices.update(welder.session, figures, unlocked, 0.1, messages);
    CHECK(messages.shown().empty());

    welder.best = kept;
    welder.again();
    welder.lead(0.3, 1);
    CHECK(welder.fault().empty());
    CHECK_FALSE(welder.ghost().empty());
    CHECK(welder.session.attempt().ghost().used() == "best");
    CHECK(welder.grounds() >= 1);

    welder.session.attempt().ghost().choose(folder / "nowhere.csv"); // changes the ghost during the attempt
    welder.lead(0.05, 1);
    CHECK(welder.ghost().empty());
    CHECK_THAT(welder.fault(), test::containsText("next attempt"));
    welder.again();
    welder.lead(0.05, 1);
    CHECK_THAT(welder.fault(), test::containsText("nowhere.csv"));
    welder.session.attempt().ghost().choose(kept);
    welder.again();
    welder.lead(0.3, 1);
    CHECK_FALSE(welder.ghost().empty());
    CHECK(welder.session.attempt().ghost().used() == "file");
    welder.session.attempt().ghost().parameters.ghost = static_cast<int>(GhostChoice::none); // takes effect at once
    welder.lead(0.05, 1);
    CHECK(welder.ghost().empty());
    CHECK(welder.fault().empty());
}

TEST_CASE("paced by time the ghost goes its own way from the strike on", "[app]") {
    Welder welder(GhostChoice::expert);
    welder.session.attempt().ghost().parameters.pace = static_cast<int>(GhostPace::time);
    welder.begin();
    welder.lead(0.1, 0);
    REQUIRE(welder.session.attempt().ghost().moment());
    const double waits = welder.session.attempt().ghost().moment()->torch.time;
    CHECK(waits < 1); // place of the strike, before the plate
    welder.lead(0.6, 1);
    REQUIRE(welder.session.run().arc().burns());
    const double since = welder.session.attempt().ghost().moment()->torch.time - waits;
    CHECK(since > 0.1);
    CHECK(since < 0.65);
    CHECK_THAT(welder.words(), test::containsText("mm ahead\n"));
}

TEST_CASE("a lesson that allows no ghost shows none, and menus do not offer it", "[app]") {
    Lesson lesson = test::smallBead();
    lesson.ghost = false;
    Welder welder(GhostChoice::expert, {}, lesson);
    welder.begin();
    welder.lead(0.1, 1);
    CHECK(welder.ghost().empty());
    CHECK(welder.fault().empty());
    const auto offered = [&] {
        const ParameterSection& section = welder.session.help().ghost;
        return std::count_if(section.parameters.begin(), section.parameters.end(),
                             [&](const Parameter& parameter) { return section.shows(parameter); });
    };
    CHECK(offered() == 0);
    welder.session.open(test::smallBead());
    CHECK(offered() == 3);
    welder.session.open(findLesson("classic", test::shippedLessons()));
    CHECK(offered() == 0);
}
