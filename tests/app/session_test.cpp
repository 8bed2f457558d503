// The lesson that window and headset share: attempts and their records, changes during an attempt, questions, and time.
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

Lesson smallLesson() {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = 1728;
    lesson.metal.supportRadius = 0.12f;
    lesson.surface.cells = 32;
    return lesson;
}

class Person {
  public:
    /// Steps take no measured time, however busy this machine is.
    explicit Person(const fs::path& record = {}) : session(test::shaders(), smallLesson(), [] { return 0.0; }) {
        session.log().records().use(record, "program", "driver");
    }

    /// Runs frames of 1/45 s with the flame at the corner.
    void weld(int frames) { frame(frames, 1.0 / 45); }

    void frame(int frames, double seconds) {
        const TorchSource torch = [](int, int) { return TorchSample{0, glm::vec3(0.021f), {1, 0, 0, 0}, 1}; };
        for (int i = 0; i < frames; ++i) {
            session.advance(controls, seconds, nullptr, torch);
            session.settle(controls);
        }
    }

    void answer(const std::string& wanted) {
        auto& answers = session.question().answers;
        const auto found = std::find_if(answers.begin(), answers.end(),
                                        [&](const std::string& text) { return text.find(wanted) == 0; });
        REQUIRE(found != answers.end());
        session.question().answered = static_cast<int>(found - answers.begin());
        session.settle(controls);
    }

    Controls controls;
    LessonSession session;
};

RecordedAttempt attemptIn(const fs::path& file) {
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    return *attempt;
}

std::string hashOfRepeat(const fs::path& file) {
    Lesson lesson = smallLesson();
    lesson.torch = TorchPath::read(file);
    repeatAttempt(lesson, attemptIn(file));
    Trainer trainer(test::shaders(), lesson);
    for (size_t i = 0; i < lesson.recorded->rows; ++i)
        trainer.advanceDemonstration(nullptr);
    return formatHexadecimal(trainer.result().stateHash);
}

} // namespace

TEST_CASE("no button ends or cuts a record: each attempt has its own file, which says why it ended", "[app]") {
    const fs::path folder = test::scratchFolder("attempts"), first = folder / "weld.csv";
    {
        Person person(first);
        person.session.begin(person.controls);
        person.weld(20);
        person.session.reset(person.controls);
        person.weld(30);
        person.session.end("start menu");
        person.session.begin(person.controls);
        person.weld(10);
        CHECK(person.session.log().records().attempt() == 3);
        CHECK_FALSE(person.session.log().records().lost());
    }
    const RecordedAttempt one = attemptIn(first), two = attemptIn(folder / "weld-2.csv"),
                          three = attemptIn(folder / "weld-3.csv");
    CHECK(one.ended == "reset");
    CHECK(two.ended == "start menu");
    CHECK(three.ended == "the program ended");
    CHECK(one.rows > 20);
    CHECK(two.rows > one.rows);
    CHECK(readTorchCsv(folder / "weld-2.csv").samples.front().time < 0.02);
    const std::string before = readTextFile(first);
    {
        Person another(first); // another start of the program with an equal record name
        another.session.begin(another.controls);
        another.weld(5);
    }
    CHECK(readTextFile(first) == before);
    CHECK(attemptIn(folder / "weld-4.csv").rows > 0);
}

TEST_CASE("every attempt replays to the same bits, whatever was changed while it ran", "[app]") {
    const fs::path folder = test::scratchFolder("attempt-changes"), file = folder / "weld.csv";
    Person person(file);
    person.session.begin(person.controls);
    const auto& live = person.session.sections().simulation.parameters;
    person.weld(10);
    setParameter(live, "heat_temperature", "0.3", "test");
    person.weld(10);
    setParameter(live, "viscosity", "4", "test");
    person.session.run().event("zoom", "2");
    person.weld(10);
    person.session.reset(person.controls);
    person.weld(15);
    setParameter(live, "heat_temperature", "0.1", "test");
    person.weld(15);
    person.session.end("start menu");
    for (const char* name : {"weld.csv", "weld-2.csv"}) {
        INFO(name);
        CHECK(hashOfRepeat(folder / name) == attemptIn(folder / name).stateHash);
    }
    CHECK(attemptIn(file).changes.size() == 2);
    CHECK(readTextFile(file).find("# event zoom 2\n") != std::string::npos);
    // The second attempt begins with the changed values of the first.
    const RecordedAttempt second = attemptIn(folder / "weld-2.csv");
    const auto value = std::find_if(second.values.begin(), second.values.end(),
                                    [](const RecordedChange& c) { return c.key == "heat_temperature"; });
    REQUIRE(value != second.values.end());
    CHECK(value->value == "0.3");
}

TEST_CASE("a record that cannot be written is asked about before the first step, and told in the end", "[app]") {
    for (const char* place : {"/proc/nowhere/weld.csv", "/dev/full"}) {
        if (std::string(place) == "/dev/full" && !fs::exists(place)) continue;
        INFO(place);
        Person person(place);
        person.session.begin(person.controls);
        REQUIRE(person.session.question().asked());
        CHECK(person.session.question().text.find(place) != std::string::npos);
        person.weld(10);
        CHECK(person.session.run().steps() == 0);
        CHECK_FALSE(person.session.log().records().lost());
        SECTION("the person agrees") {
            person.answer("Weld without a record");
            person.weld(10);
            CHECK(person.session.run().steps() > 5);
            CHECK(person.session.log().records().lost());
        }
        SECTION("the person does not") {
            person.answer("Back to the lesson page");
            CHECK_FALSE(person.session.running());
            CHECK_FALSE(person.session.log().records().lost());
        }
    }
}

TEST_CASE("another lesson is opened in the same session: its own values, the old attempt ended", "[app]") {
    const fs::path folder = test::scratchFolder("opened"), file = folder / "weld.csv";
    Person person(file);
    person.session.sections().attempt.forScore = true;
    setParameter(person.session.sections().start.parameters, "particles", "2000", "test");
    CHECK(person.session.values().workpieceChanged());
    person.session.sections().attempt.forScore = false;
    person.session.begin(person.controls);
    person.weld(10);
    person.session.sections().attempt.forScore = true;
    const fs::path lessons = test::testFolder().parent_path() / "app" / "data" / "lessons";
    person.session.open(findLesson("gmaw-bead", lessons));
    CHECK_FALSE(person.session.running());
    CHECK(attemptIn(file).ended == "another lesson was opened");
    CHECK(person.session.lesson().key == "gmaw-bead");
    CHECK_FALSE(person.session.values().workpieceChanged());
    LessonSections& sections = person.session.sections();
    CHECK_FALSE(sections.attempt.forScore); // a test does not stick to the next lesson
    setParameter(sections.simulation.parameters, "voltage", "24.5", "test");
    CHECK(person.session.lesson().process.of<Gmaw>().voltage == 24.5f);
    CHECK_FALSE(person.session.values().workpieceChanged()); // the trainee sets the machine
    setParameter(sections.start.parameters, "thickness_mm", "9", "test");
    CHECK(person.session.values().workpieceChanged());
    person.session.open(smallLesson());
    person.session.sections().attempt.forScore = false;
    person.session.begin(person.controls);
    person.weld(10);
    CHECK(person.session.run().steps() > 0);
}

TEST_CASE("steps follow the clock at 45 frames a second and at 12", "[app]") {
    for (const double rate : {45.0, 12.0}) {
        Person person;
        person.session.begin(person.controls);
        person.frame(1, 0);
        person.frame(static_cast<int>(2 * rate), 1 / rate);
        INFO(rate << " frames a second");
        LessonFigures figures;
        fillFigures(figures, person.session);
        CHECK(figures.time == Approx(2).margin(0.05));
        CHECK(figures.speed == Approx(1).margin(0.05));
    }
}

TEST_CASE("the record tells how much slower than the clock the metal was", "[app]") {
    const fs::path file = test::scratchFolder("slow") / "weld.csv";
    Person person(file);
    person.session.begin(person.controls);
    person.frame(40, 1.0); // a frame takes a second: more steps than can be made up
    person.session.end("start menu");
    const RecordedAttempt attempt = attemptIn(file);
    REQUIRE(attempt.realTime);
    CHECK(*attempt.realTime < 0.5);
    const TorchRecording rows = readTorchCsv(file);
    CHECK(std::stod(rows.furtherCells.back().back()) < 0.5);
}

TEST_CASE("a fault while the machine's speed is measured stops the measuring, and a reset begins it again", "[app]") {
    static bool broken = false;
    const Stopwatch clock = []() -> double { return broken ? throw RuntimeFault("the card was taken out") : 0.0; };
    LessonSession session(test::shaders(), smallLesson(), clock);
    Controls controls;
    session.sections().attempt.forScore = true;
    session.begin(controls);
    session.advance(controls, 1.0 / 45, nullptr);
    CHECK(session.run().fault().empty());
    CHECK(session.question().asked());
    broken = true;
    session.advance(controls, 1.0 / 45, nullptr);
    CHECK(session.run().fault() == "the card was taken out");
    CHECK_FALSE(session.question().asked());
    session.advance(controls, 1.0 / 45, nullptr);
    CHECK(session.run().steps() < 10);
    broken = false;
    session.reset(controls);
    CHECK(session.run().fault().empty());
    CHECK(session.question().asked()); // the measurement starts at once
    for (int i = 0; i < 110; ++i)
        session.advance(controls, 1.0 / 45, nullptr);
    CHECK_FALSE(session.question().asked());
    CHECK(session.leader() == TorchLeader::desk); // an attempt runs
}

TEST_CASE("an attempt for score starts where the machine keeps up, and else says what would help", "[app]") {
    const fs::path file = test::scratchFolder("score") / "weld.csv";
    Person person(file);
    person.session.sections().attempt.forScore = true;
    person.session.begin(person.controls);
    CHECK(person.session.question().asked());
    CHECK(person.session.question().answers.empty()); // the measurement runs
    person.frame(2, 1.0 / 45);
    person.session.reset(person.controls); // without an attempt to reset the measurement continues
    CHECK(person.session.question().asked());
    CHECK_FALSE(fs::exists(file));
    SECTION("it keeps up") {
        person.frame(100, 1.0 / 45);
        CHECK_FALSE(person.session.question().asked());
        CHECK(attemptIn(file).values.size() > 5);
        const size_t steps = person.session.run().steps();
        person.frame(10, 1.0 / 45);
        CHECK(person.session.run().steps() > steps);
        person.session.end("start menu");
        CHECK(readTextFile(file).find("# event for_score yes\n") != std::string::npos);
        CHECK(hashOfRepeat(file) == attemptIn(file).stateHash); // the measurement leaves no trace in the metal
    }
    SECTION("it does with a coarser surface") {
        const int cells = person.session.lesson().surface.cells;
        person.frame(2, 1.0);
        person.frame(100, 1.0 / 45);
        REQUIRE(person.session.question().answers.size() == 3);
        CHECK_FALSE(fs::exists(file));
        person.answer("Start the test so");
        CHECK(person.session.lesson().surface.cells == cells / 2);
        CHECK(person.session.question().answers.empty()); // a new measurement
        CHECK(person.session.running());
    }
    SECTION("it does not") {
        person.frame(20, 1.0);
        REQUIRE(person.session.question().answers.size() == 2); // no test is offered
        CHECK_FALSE(fs::exists(file));
        SECTION("practice") {
            person.answer("Practise");
            CHECK_FALSE(person.session.question().asked());
            person.frame(10, 1.0 / 45);
            CHECK(person.session.run().steps() > 0);
            CHECK(fs::exists(file));
        }
    }
}

TEST_CASE("an upright plate is in the picture, and the torch is led in the room", "[app]") {
    Lesson lesson;
    lesson.model = LessonModel::Weld;
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.widthMm = 20;
    lesson.workpiece.thicknessMm = 4;
    lesson.workpiece.position = static_cast<int>(WeldPosition::g3);
    lesson.surface.cells = 32;
    LessonSession session(test::shaders(), lesson, [] { return 0.0; });
    Controls controls;
    session.begin(controls);
    const auto frames = [&] {
        for (int i = 0; i < 4; ++i) {
            session.advance(controls, 1.0 / 45, nullptr);
            controls.update({}, 1.0 / 45);
        }
    };
    frames();
    REQUIRE(session.run().steps() > 0);
    const glm::mat3 turn = session.picture().fixture().turn;
    const glm::vec3 before = turn * session.run().torch().tip;
    CHECK(glm::distance(turn * session.run().torch().axis(), glm::vec3(0, 0, -1)) < 1e-5F); // towards the upright plate
    controls.captureMouse();
    InputFrame hand;
    hand.mouseMove = {0, -100}; // the vertical seam runs up the screen
    controls.update(hand, 1.0 / 45);
    frames();
    const glm::vec3 way = turn * session.run().torch().tip - before;
    CHECK(glm::distance(way, glm::vec3(0, controls.parameters.torchMouse * 1e-3F, 0)) < 1e-5F);
    CHECK(glm::distance(turn * glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)) < 1e-6F); // its face points to the welder
    // The seam is vertical; 15 mm of it and 6 mm of supports are below the middle.
    CHECK(session.picture().bottom() == Approx(-0.021F));
    // 5 mm of metal lie before the wall of the upright plate, and the box ends above them.
    const glm::vec3 tip = session.run().torch().tip;
    CHECK(session.picture().toMetal(tip) < 0.005F);
    CHECK(session.picture().toMetal(tip + glm::vec3(0, 0.3F, 0)) == Approx(0.29F).margin(0.02F));
}

namespace {

/// A bead on a small plate with a voltage to choose and a machine that starts too low.
Lesson beadToSet() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.widthMm = 18;
    lesson.workpiece.thicknessMm = 4;
    lesson.surface.cells = 32;
    lesson.choose = {{"voltage", 20, 26, 15.0}};
    return lesson;
}

void set(LessonSession& session, const char* key, const char* value) {
    setParameter(session.sections().simulation.parameters, key, value, "test");
}

std::string valueOf(LessonSession& session, const char* key) {
    return parameterText(*findParameter(session.sections().simulation.parameters, key));
}

} // namespace

TEST_CASE("a machine that stands outside of a lesson's limits is set before the weld", "[app]") {
    const fs::path file = test::scratchFolder("unset") / "weld.csv";
    Controls controls;
    LessonSession session(test::shaders(), beadToSet(), [] { return 0.0; });
    session.log().records().use(file, "program", "driver");
    CHECK(valueOf(session, "voltage") == "15");
    session.begin(controls);
    CHECK_FALSE(session.running());
    CHECK_THAT(session.question().text, test::containsText("voltage 20 to 26 V (now 15)"));
    REQUIRE(session.question().answers.size() == 1);
    session.question().answered = 0;
    session.settle(controls);
    CHECK_FALSE(session.question().asked());
    session.sections().restoreDefaults(); // a value that may not be chosen is no default to restore
    CHECK(valueOf(session, "voltage") == "15");

    session.demonstrate(controls); // shows the lesson's own settings, not those of the machine
    REQUIRE(session.running());
    session.advance(controls, 1.0 / 45, nullptr);
    session.reset(controls);
    CHECK_FALSE(session.running());
    CHECK(session.question().asked());
    session.question().answered = 0;
    session.settle(controls);

    CHECK_THROWS_AS(set(session, "voltage", "27"), InputError);
    set(session, "voltage", "21.5");
    session.begin(controls);
    CHECK(session.running());
    CHECK_FALSE(session.question().asked());
    session.end("start menu");
    const std::string record = readTextFile(file);
    CHECK(record.find("# value voltage 21.5\n") != std::string::npos);
    CHECK(record.find("# chosen voltage\n") != std::string::npos);
    CHECK(record.find("# chosen wire_feed_m_min\n") == std::string::npos);
    CHECK(session.values().chosenText() == "voltage 21.5 V");
}

TEST_CASE("for score what a lesson gives stays the lesson's", "[app]") {
    Controls controls;
    LessonSession session(test::shaders(), beadToSet(), [] { return 0.0; });
    LessonSections& sections = session.sections();
    const auto given = [&](const char* key) {
        return sections.simulation.isGiven(*findParameter(sections.simulation.parameters, key));
    };
    CHECK_FALSE(given("wire_feed_m_min"));
    set(session, "voltage", "22");
    set(session, "wire_feed_m_min", "6");
    CHECK(session.values().settingsChanged());
    sections.restoreGiven(); // practice gives no values
    CHECK(valueOf(session, "wire_feed_m_min") == "6");
    sections.attempt.forScore = true;
    CHECK(given("wire_feed_m_min"));
    CHECK_FALSE(given("voltage"));
    session.begin(controls);
    CHECK(valueOf(session, "wire_feed_m_min") == "3.6");
    CHECK(valueOf(session, "voltage") == "22");
    CHECK_FALSE(session.values().settingsChanged());
    session.end("start menu");
}
