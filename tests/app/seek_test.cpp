// Checkpoints in a session's recordings: a replay seeks them at once, reaches the bits of a replay without them,
// refuses those of another program or driver, and repeats the last branch of an attempt that went back.
#include "app/activities/file_checkpoints.hpp"
#include "app/activities/replay_end.hpp"
#include "app/library/best_kept.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/platform/program_info.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/checkpoint_schedule.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/app/program.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <thread>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

constexpr double kFrame = 1.0 / 45;

/// Welds at 3 mm/s in a session that records its attempts.
class Welder {
  public:
    explicit Welder(const fs::path& folder) : session(test::shaders(), test::plainBead(), [] { return 0.0; }) {
        session.log().recordings().use(folder, thisMachine().program, thisMachine().driver);
        session.begin(controls);
    }

    /// Runs frames in each of which a pending checkpoint has time to be stored.
    void weld(int frames) {
        const TorchSource lead = [&](int step, int) {
            TorchSample torch;
            const double time = static_cast<double>(session.run().steps() + static_cast<size_t>(step)) / 90;
            torch.tip = {-0.008F + 3e-3F * static_cast<float>(time), 0.003F, 0};
            torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
            torch.trigger = 1;
            return torch;
        };
        for (int i = 0; i < frames; ++i) {
            session.advance(controls, kFrame, nullptr, lead);
            if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        CHECK(session.run().fault().empty());
    }

    fs::path end() {
        session.end("the test ended");
        session.log().recordings().finish();
        CHECK(session.log().recordings().lost() == "");
        return session.log().recordings().file();
    }

    Controls controls;
    LessonSession session;
};

Lesson attemptIn(const fs::path& file) {
    Lesson lesson = test::plainBead();
    takeTorch(lesson, file);
    return lesson;
}

/// Returns a copy without its checkpoints.
fs::path withoutMoments(const fs::path& file) {
    test::RecordingBytes copy;
    FrameReader frames(file);
    RecordingFrame frame;
    while (frames.next(frame))
        if (!frame.is(FrameKind::checkpoint)) copy.add(frame.kind, frame.content);
    const fs::path stripped = file.parent_path() / "without.meltrec";
    std::ofstream(stripped, std::ios::binary) << copy.bytes();
    return stripped;
}

/// Returns the hash of the metal at this second, from the program's own seek.
std::string hashAt(const fs::path& file, const std::string& second, const std::string& told) {
    const fs::path folder = test::scratchFolder("seek-run");
    const test::Outcome outcome = test::runMeltpool("replay '" + file.string() + "' --seek " + second +
                                                    " --size 64x36 --out '" + folder.string() + "'");
    INFO(outcome.errors << outcome.output);
    REQUIRE(outcome.code == 0);
    CHECK((outcome.output.find("It begins at") != std::string::npos) == !told.empty());
    return nlohmann::json::parse(readTextFile(folder / "result.json")).at("state_hash");
}

void seekInWindow(const fs::path& file, const Recording& recording) {
    LessonSession session(test::shaders(), test::plainBead(), [] { return 0.0; });
    Controls controls;
    session.openReplay(attemptIn(file), controls);
    AttemptReplay& replay = session.activities().replay;
    CHECK(replay.recordedMoments() == recording.checkpoints.size());
    CHECK(replay.momentsRefused().empty());
    const auto frame = [&] { session.advance(controls, kFrame, nullptr, {}); };
    const double last = recording.steps[recording.checkpoints.back().steps - 1].torch.time;
    replay.line().seek(recording.seconds() - 0.05);
    frame();
    CHECK(session.run().torch().time >= last);
    for (int i = 0; i < 3000 && (replay.line().playing() || replay.line().seeking()); ++i)
        frame();
    REQUIRE(replay.comparison());
    CHECK(replay.comparison()->verdict == ReplayEnd::Verdict::same);
    CHECK(session.run().fault().empty());
}

void seekByCommand(const fs::path& file, const Recording& recording) {
    const fs::path stripped = withoutMoments(file);
    const std::string second = formatNumber(static_cast<float>(recording.seconds() - 0.2));
    CHECK(hashAt(file, second, "from a moment") == hashAt(stripped, second, ""));
}

void refuseForeignMoments(const fs::path& file) {
    const Lesson lesson = attemptIn(file);
    CHECK(fileCheckpoints(lesson, thisMachine()).moments);
    CHECK(fileCheckpoints(lesson, thisMachine()).refused.empty());
    ReplayMachine other = thisMachine();
    other.program += "x";
    CHECK_FALSE(fileCheckpoints(lesson, other).moments);
    CHECK_THAT(fileCheckpoints(lesson, other).refused, containsText("another version, " + programBuild()));
    other = thisMachine();
    other.driver += "x";
    CHECK_THAT(fileCheckpoints(lesson, other).refused, containsText("another driver"));
    Lesson changed = lesson;
    changed.recorded->head.lessonHash = "0123456789abcdef";
    CHECK_THAT(fileCheckpoints(changed, thisMachine()).refused, containsText("version of its lesson"));
}

void makePageOfHand(const fs::path& file) {
    const fs::path page = test::scratchFolder("seek-page") / "page.html";
    const test::Outcome outcome = test::runMeltpool("report '" + file.string() + "' --out '" + page.string() + "'");
    INFO(outcome.errors << outcome.output);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(readTextFile(page), containsText("holds the hand and the arc but no metal"));
}

} // namespace

TEST_CASE("a replay goes to the moments that its recording holds, and to the same bits as without", "[app][seek]") {
    Welder welder(test::scratchFolder("seek"));
    welder.weld(240); // longer than five seconds
    const fs::path file = welder.end();
    const Recording recording = readSoundRecording(file);
    REQUIRE(recording.checkpoints.size() >= 2);
    WARN(recording.checkpoints.size() << " moments in " << recording.seconds() << " s; the recording takes "
                                      << static_cast<double>(fs::file_size(file)) / recording.seconds() * 60 / 1e6
                                      << " MB a minute, of them at first "
                                      << static_cast<double>(recording.checkpoints[0].size) / 1e6 << " MB once");
    const double seconds = recording.seconds();
    constexpr double kSteps = 16e3; // bytes a second, and some for the head
    CHECK(static_cast<double>(fs::file_size(file) - recording.checkpoints[0].size) <
          CheckpointSchedule::kAtOnce + (CheckpointSchedule::kBytesPerSecond + kSteps) * seconds + 1e5);

    seekInWindow(file, recording);
    seekByCommand(file, recording);
    refuseForeignMoments(file);
    makePageOfHand(file);
}

TEST_CASE("the recording of an attempt that went back repeats its last end and is practice", "[app][seek]") {
    const fs::path folder = test::scratchFolder("seek-redo");
    Welder welder(folder);
    welder.weld(200);
    REQUIRE(welder.session.redoes());
    welder.session.redo(welder.controls);
    REQUIRE(welder.session.log().redo().redone() == 1);
    welder.weld(80);
    const fs::path file = welder.end();
    const Lesson lesson = attemptIn(file);
    REQUIRE(lesson.recorded);
    CHECK(lesson.recorded->redone == 1);
    Trainer trainer(test::shaders(), lesson);
    for (size_t i = 0; i < lesson.recorded->rows; ++i)
        trainer.advanceDemonstration(nullptr);
    CHECK(formatHexadecimal(trainer.result().stateHash) == lesson.recorded->stateHash);
    const FileCheckpoints recorded = fileCheckpoints(lesson, thisMachine());
    REQUIRE(recorded.moments);
    const auto moment = recorded.moments->before(lesson.torch.duration());
    REQUIRE(moment);
    trainer.restore(*moment);
    while (trainer.steps() < lesson.recorded->rows)
        trainer.advanceDemonstration(nullptr);
    CHECK(formatHexadecimal(trainer.result().stateHash) == lesson.recorded->stateHash);
    const auto kept = keptRecordings(folder);
    REQUIRE(kept.size() == 1);
    CHECK(kept[0].practice);
    CHECK(bestKept(folder, "gmaw-bead").empty());
}
