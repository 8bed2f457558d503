// Return to an earlier checkpoint of the attempt: the metal is restored, the record contains both branches and replays
// the last one, and the attempt counts as practice.
#include "app/library/kept_attempts.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace meltpool;

namespace {

/// A torch that points straight down, 3 mm over the plate, at 3 mm/s.
TorchSample torchAt(size_t step, double timeStep) {
    TorchSample torch;
    torch.tip = {-0.008F + 3e-3F * static_cast<float>(static_cast<double>(step) * timeStep), 0.003F, 0};
    torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
    torch.trigger = 1;
    return torch;
}

class Welder {
  public:
    explicit Welder(const std::filesystem::path& record = {}, Lesson lesson = test::plainBead())
        : session(test::shaders(), std::move(lesson), [] { return 0.0; }) {
        session.log().records().use(record, "program", "driver");
    }

    /// Runs frames of 1/45 s, in each of which a pending checkpoint has time to be stored.
    void weld(int frames) {
        const TorchSource torch = [&](int step, int) {
            TorchSample sample = torchAt(session.run().steps() + static_cast<size_t>(step), 1.0 / 90);
            sample.trigger = trigger;
            return sample;
        };
        for (int i = 0; i < frames; ++i) {
            session.advance(controls, 1.0 / 45, nullptr, torch);
            if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    Controls controls;
    LessonSession session;
    float trigger = 1;
};

std::string hashOfRepeat(const std::filesystem::path& file) {
    Lesson lesson = test::plainBead();
    takeTorch(lesson, file);
    Trainer trainer(test::shaders(), lesson);
    for (size_t i = 0; i < lesson.recorded->rows; ++i)
        trainer.advanceDemonstration(nullptr);
    return formatHexadecimal(trainer.result().stateHash);
}

} // namespace

TEST_CASE("an attempt goes back three seconds and on to another end, which its record repeats", "[app]") {
    const auto file = test::scratchFolder("redo") / "attempt.csv";
    {
        Welder welder(file);
        welder.session.begin(welder.controls);
        CHECK_FALSE(welder.session.redoes());
        welder.weld(200);
        REQUIRE(welder.session.redoes());
        CHECK(welder.session.log().redo().redone() == 0);
        const double before = welder.session.run().torch().time;
        const size_t steps = welder.session.run().steps();
        welder.controls.update({}, 1.0 / 45); // opens the lock at the lesson's start
        welder.session.redo(welder.controls);
        REQUIRE(welder.session.run().steps() < steps);
        CHECK(welder.session.run().torch().time <= before - Redo::kBack + 1e-6);
        CHECK(welder.session.log().redo().redone() == 1);
        CHECK(welder.controls.triggerLock().locked());
        CHECK(welder.controls.triggerLock().reason() == ArcOut::redone);
        welder.weld(30);
        CHECK(welder.session.run().fault().empty());
        welder.session.end("the test ended");
    }
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    CHECK(attempt->redone == 1);
    const auto mark = std::find_if(attempt->notes.begin(), attempt->notes.end(),
                                   [](const RecordedEvent& note) { return note.name == "redo"; });
    REQUIRE(mark != attempt->notes.end()); // note of a replay's time line
    CHECK(std::stoul(mark->value) < mark->steps);
    CHECK(attempt->stateHash == hashOfRepeat(file));
}

TEST_CASE("an attempt that passed stays as it is, and what is redone is another attempt", "[app]") {
    const auto folder = test::scratchFolder("redo-fork");
    const auto record = folder / "weld.csv";
    Lesson lesson = test::plainBead();
    lesson.acceptance.reset(); // a scored weld without limits has passed
    lesson.technique->lengthFromMm = -6;
    lesson.technique->lengthToMm = -1;
    {
        Welder welder(record, lesson);
        AttemptLog& log = welder.session.log();
        log.recordings().use(folder / "recordings", "program", "driver");
        welder.session.begin(welder.controls);
        welder.weld(200);
        welder.trigger = 0;
        welder.weld(60);
        REQUIRE(welder.session.attempt().judged());
        REQUIRE(welder.session.attempt().judged()->judgement.score->scored);
        log.redo().choose(-0.003);
        welder.session.redo(welder.controls);
        CHECK(log.redo().redone() == 1);
        CHECK(log.records().attempt() == 2);
        CHECK_FALSE(welder.session.question().asked());
        welder.trigger = 1;
        welder.weld(40);
        welder.trigger = 0;
        welder.weld(60);
        const std::uint64_t checkpoints = log.redo().bytes();
        CHECK(checkpoints > 0);
        log.redo().choose(-0.003);
        welder.session.redo(welder.controls); // what is practice already stays one attempt
        welder.weld(10);
        welder.session.end("the test ended");
        log.recordings().finish();
        CHECK(log.recordings().lost().empty());
    }
    const std::vector<KeptAttempt> kept = keptRecordings(folder / "recordings");
    REQUIRE(kept.size() == 2); // the newest first
    CHECK_FALSE(kept[1].practice);
    CHECK(kept[1].score);
    CHECK(kept[0].practice);
    const Recording first = readSoundRecording(kept[1].file), second = readSoundRecording(kept[0].file);
    CHECK(first.end->reason == "another attempt began");
    CHECK(first.head.attempt == 1);
    CHECK(second.head.attempt == 2);
    CHECK(first.head.values == second.head.values);
    CHECK(first.steps.size() > second.steps.size());
    CHECK_FALSE(second.checkpoints.empty());
    for (const KeptAttempt& each : kept)
        CHECK(readSoundRecording(each.file).end->stateHash == hashOfRepeat(each.file));
    const auto csv = readRecordedAttempt(record), redoneCsv = readRecordedAttempt(folder / "weld-2.csv");
    REQUIRE(csv);
    REQUIRE(redoneCsv);
    CHECK(csv->redone == 0);
    CHECK(redoneCsv->redone >= 1);
    CHECK(csv->stateHash == hashOfRepeat(record));
    CHECK(redoneCsv->stateHash == hashOfRepeat(folder / "weld-2.csv"));
}

TEST_CASE("one goes back before a fault by its place, and another attempt knows of nothing earlier", "[app]") {
    Welder welder;
    welder.session.begin(welder.controls);
    welder.weld(200);
    CHECK_FALSE(firstTimeAt(Technique(seamOf(test::plainBead().workpiece)), 0));
    REQUIRE(welder.session.redoes());
    welder.session.log().redo().choose(-0.002); // torch position after 2 s
    welder.session.redo(welder.controls);
    CHECK(welder.session.run().torch().time < 1.2);
    welder.session.reset(welder.controls);
    CHECK(welder.session.log().redo().redone() == 0);
    CHECK_FALSE(welder.session.redoes());
    welder.session.redo(welder.controls);
    CHECK(welder.session.run().steps() == 0);
}

TEST_CASE("an attempt that goes back ten times from the same place takes no more memory", "[app]") {
    Welder welder;
    welder.session.begin(welder.controls);
    welder.weld(60);
    size_t first = 0;
    for (int i = 0; i < 10; ++i) {
        welder.weld(30);
        REQUIRE(welder.session.redoes());
        welder.session.log().redo().choose(-0.0078);
        welder.session.redo(welder.controls);
        CHECK(welder.session.log().redo().redone() == static_cast<size_t>(i) + 1);
        if (i == 1) first = welder.session.log().redo().bytes();
    }
    CHECK(welder.session.log().redo().bytes() < first + first / 4);
}

TEST_CASE("a record that goes back where it cannot is refused with its line", "[app]") {
    const auto folder = test::scratchFolder("redo-lines");
    const std::string head = "# meltpool record 1\n# lesson gmaw-bead\n"
                             "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n0.1,0,3,0,0,0,0,1,0\n0.2,1,3,0,0,0,0,1,0\n";
    const auto file = folder / "attempt.csv";
    writeTextFileAtomically(file, head + "# event redo 1\n0.15,9,3,0,0,0,0,1,1\n");
    CHECK(TorchPath::read(file).duration() == Approx(0.15));
    CHECK(readRecordedAttempt(file)->rows == 2);
    for (const std::string step : {"3", "-1", "1.5", "soon"}) {
        writeTextFileAtomically(file, head + "# event redo " + step + "\n");
        CHECK_THROWS_WITH(TorchPath::read(file), test::containsText("attempt.csv:6"));
        CHECK_THROWS_WITH(readRecordedAttempt(file), test::containsText("attempt.csv:6"));
    }
}
