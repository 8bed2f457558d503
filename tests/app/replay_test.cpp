// Replay of a recorded attempt in the session: it reproduces the bits of its record, also after seeks.
#include "app/activities/attempt_lesson.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <chrono>
#include <thread>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

constexpr double kFrame = 1.0 / 45;

/// Records a weld of `seconds` on a small plate by a torch that travels along it. The voltage changes on the way.
fs::path recordedWeld(const std::string& name, double seconds) {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 14;
    lesson.workpiece.thicknessMm = 3;
    lesson.workpiece.spacingMm = 1.5f;
    lesson.surface.cells = 32;
    const fs::path file = test::scratchFolder(name) / "record.csv";
    Trainer trainer(test::shaders(), std::move(lesson));
    trainer.record(file, {1, "some program", "some driver"});
    bool changed = false;
    while (trainer.time() < seconds) {
        TorchSample torch;
        torch.tip = {-0.008f + 0.008f * static_cast<float>(trainer.time() / seconds), 0.003f, 0};
        torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
        torch.trigger = trainer.time() > 0.1 ? 1 : 0;
        if (!changed && trainer.time() > 0.5 * seconds) trainer.change("voltage", "25", "a menu");
        changed = changed || trainer.time() > 0.5 * seconds;
        trainer.advance(torch, nullptr);
    }
    trainer.stopRecord();
    return file;
}

class Viewer {
  public:
    Viewer() : session(test::shaders(), loadLesson("gmaw-bead"), [] { return 0.0; }) {}

    void frames(int count) {
        for (int frame = 0; frame < count; ++frame)
            session.advance(controls, kFrame, nullptr, [](int, int) { return TorchSample{0, {0, 0.2f, 0}}; });
    }
    /// Runs frames until the replay stops; returns false if it never does.
    bool untilStill() {
        const ReplayTimeline& line = session.activities().replay.line();
        for (int frame = 0; frame < 3000 && (line.playing() || line.seeking()); ++frame)
            frames(1);
        return !line.playing() && !line.seeking();
    }
    /// Frames until so many checkpoints are stored; false if they never are. They come from the GPU, and a thread
    /// that may have to wait for a processor packs them.
    bool untilMoments(size_t count) {
        const AttemptReplay& replay = session.activities().replay;
        for (int frame = 0; frame < 1000 && replay.moments() < count; ++frame) {
            frames(1);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return replay.moments() >= count;
    }
    /// Seeks a time and waits until the replay is there.
    void bringTo(double time) {
        session.activities().replay.line().seek(time);
        for (int frame = 0; frame < 3000 && session.activities().replay.line().seeking(); ++frame)
            frames(1);
    }
    ReplayEnd::Verdict verdict() const {
        const auto& end = session.activities().replay.comparison();
        return end ? end->verdict : ReplayEnd::Verdict::unknown;
    }

    Controls controls;
    LessonSession session;
};

} // namespace

TEST_CASE("an attempt played again has its bits at the end, from the start and after being brought to other moments",
          "[app]") {
    const fs::path file = recordedWeld("replay", 1.6);
    Viewer viewer;
    LessonSession& session = viewer.session;
    AttemptReplay& replay = session.activities().replay;
    session.openReplay(lessonOfAttempt(file), viewer.controls);
    REQUIRE(session.running());
    CHECK(session.leader() == TorchLeader::path);
    CHECK_FALSE(session.judges());
    CHECK(session.log().records().attempt() == 0);
    CHECK(replay.marks().size() == 1);
    viewer.frames(10);
    CHECK(session.leader() != TorchLeader::hand); // the viewer's own torch does not lead it
    CHECK(session.run().steps() > 3);
    CHECK_FALSE(replay.comparison());
    REQUIRE(viewer.untilStill());
    CHECK(replay.line().over());
    CHECK(viewer.verdict() == ReplayEnd::Verdict::same);
    CHECK(viewer.untilMoments(2)); // one in each half second
    CHECK(replay.distance().most() > 0);
    const size_t steps = session.run().steps();

    SECTION("back and on, from the start and from moments that were kept") {
        for (const double time : {0.7, 1.3, 0.0, 1.05}) {
            INFO(time);
            viewer.bringTo(time);
            CHECK_FALSE(replay.comparison());
            CHECK(replay.line().time() == Approx(time).margin(0.02));
            CHECK(session.run().torch().time == Approx(replay.line().time()));
            CHECK(session.run().fault().empty());
        }
        replay.line().toggle();
        REQUIRE(viewer.untilStill());
        CHECK(session.run().steps() == steps);
        CHECK(viewer.verdict() == ReplayEnd::Verdict::same);
    }
    SECTION("at its end Play begins again") {
        replay.line().toggle();
        viewer.frames(3);
        CHECK(session.run().steps() < steps / 2);
        REQUIRE(viewer.untilStill());
        CHECK(viewer.verdict() == ReplayEnd::Verdict::same);
    }
    SECTION("forward, and paused meanwhile") {
        viewer.bringTo(0);
        CHECK(session.run().steps() == 0);
        viewer.bringTo(1.2);
        CHECK_FALSE(replay.line().playing()); // unchanged
        const size_t there = session.run().steps();
        viewer.frames(5);
        CHECK(session.run().steps() == there);
    }
    SECTION("one's own attempt follows") {
        session.reset(viewer.controls);
        CHECK(session.leader() == TorchLeader::desk);
        CHECK_FALSE(session.run().fault().size() > 0);
    }
}

TEST_CASE("half the speed makes half the steps", "[app]") {
    const fs::path file = recordedWeld("replay-speed", 1);
    Viewer viewer;
    viewer.session.openReplay(lessonOfAttempt(file), viewer.controls);
    viewer.session.activities().replay.line().setSpeed(0.5);
    viewer.frames(24); // the first frame only starts the clock
    CHECK(viewer.session.activities().replay.line().time() == Approx(23 * kFrame / 2).margin(0.02));
    CHECK(viewer.session.activities().replay.line().speed() * viewer.session.run().clock().speed() ==
          Approx(0.5).margin(0.05));
}

TEST_CASE("a recording whose metal was another is told to be simulated, with both machines", "[app]") {
    const fs::path file = recordedWeld("replay-other", 0.3);
    std::string text = readTextFile(file);
    const size_t at = text.find("# state_hash ");
    REQUIRE(at != std::string::npos);
    const size_t digit = at + std::string("# state_hash ").size();
    text[digit] = text[digit] == '0' ? '1' : '0';
    writeTextFileAtomically(file, text);
    Viewer viewer;
    viewer.session.openReplay(lessonOfAttempt(file), viewer.controls);
    REQUIRE(viewer.untilStill());
    REQUIRE(viewer.session.activities().replay.comparison());
    CHECK(viewer.verdict() == ReplayEnd::Verdict::different);
    CHECK_THAT(viewer.session.activities().replay.comparison()->text,
               test::containsText("simulation of the recording") && test::containsText("some program on some driver"));
}

TEST_CASE("what names no lesson is refused, unless one is named for it", "[app]") {
    const fs::path path = test::testFolder() / "paths" / "recorded.csv";
    CHECK_THROWS_WITH(lessonOfAttempt(path), test::containsText("recorded.csv: names no lesson; expected"));
    CHECK(lessonOfAttempt(path, "classic").torch.duration() == 2);
    CHECK_THROWS_AS(lessonOfAttempt("nowhere.csv"), InputError);
}
