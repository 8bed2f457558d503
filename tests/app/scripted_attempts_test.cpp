// Replays of twenty scripted attempts of all processes: each reaches the bits of its recording, and each seek the bits
// of a stepped weld, with one thread of the software driver and with two.
#include "app/activities/attempt_replay.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/app/attempt_scripts.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/newest_recording.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;

constexpr int kSeeks = 5;
constexpr int kMostFrames = 20'000; // far more than a seek takes
constexpr const char* kFolderKey = "MELTPOOL_SCRIPTED_ATTEMPTS";

using Hashes = std::map<size_t, std::uint64_t>; ///< hash of the metal by number of steps

fs::path folderOf(const fs::path& all, size_t number) {
    return all / (number < 10 ? "0" + std::to_string(number) : std::to_string(number));
}

/// Plays the attempt to its end as the window does, then seeks times all over it. Returns the metal's hashes there.
Hashes hashesBySeeking(const Lesson& lesson, unsigned seed) {
    Trainer trainer(shaders(), lesson);
    AttemptReplay replay;
    replay.begin(trainer, {"program", "driver"}, machineSeconds);
    while (!replay.line().over()) {
        replay.step(trainer, nullptr);
        replay.collect();
    }
    REQUIRE(replay.comparison());
    INFO(replay.comparison()->text);
    CHECK(replay.comparison()->verdict == ReplayEnd::Verdict::same);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moment(0, replay.line().duration());
    Hashes found;
    for (int i = 0; i < kSeeks; ++i) {
        const double wanted = moment(random);
        INFO("brought to " << wanted << " s");
        replay.line().seek(wanted);
        int frames = 0;
        while (!replay.seek(trainer, 1.0 / 45, nullptr) && ++frames < kMostFrames)
            replay.collect();
        CHECK(trainer.time() == Approx(wanted).margin(trainer.timeStep()));
        const std::uint64_t hash = trainer.result().stateHash;
        CHECK(found.emplace(trainer.steps(), hash).first->second == hash);
    }
    return found;
}

/// Steps fresh metal from the first step to the last and compares its hashes.
void stepThrough(const Lesson& lesson, const Hashes& sought) {
    Trainer trainer(shaders(), lesson);
    trainer.waitForFigures(true);
    Hashes stepped;
    size_t molten = 0;
    if (sought.contains(0)) stepped[0] = trainer.result().stateHash;
    while (trainer.steps() < lesson.recorded->rows) {
        trainer.advanceDemonstration(nullptr);
        molten = std::max(molten, trainer.figures().molten);
        if (sought.contains(trainer.steps())) stepped[trainer.steps()] = trainer.result().stateHash;
    }
    CHECK(stepped == sought);
    CHECK(formatHexadecimal(trainer.result().stateHash) == lesson.recorded->stateHash);
    CHECK(molten > 0); // a weld has molten metal
}

/// Replays all attempts of the folder in this process, with the driver's present number of threads.
void replayAll(const fs::path& all) {
    const auto scripts = attemptScripts();
    for (size_t i = 0; i < scripts.size(); ++i) {
        INFO(scripts[i].name);
        const fs::path file = newestRecording(folderOf(all, i));
        REQUIRE_FALSE(file.empty());
        Lesson lesson = lessonOf(scripts[i]);
        takeTorch(lesson, file);
        REQUIRE(lesson.recorded);
        REQUIRE(lesson.recorded->rows > 50);
        CHECK_FALSE(lesson.recorded->stateHash.empty());
        stepThrough(lesson, hashesBySeeking(lesson, static_cast<unsigned>(i)));
    }
}

/// Runs this program again for the test below and returns its exit code.
int replayAllWith(const std::string& threads, const fs::path& all) {
    const fs::path own = fs::read_symlink("/proc/self/exe");
    const std::string command = std::string(kFolderKey) + "='" + all.string() + "' LP_NUM_THREADS=" + threads + " '" +
                                own.string() + "' '[scripted-replay]'";
    return std::system(command.c_str());
}

} // namespace

TEST_CASE("twenty attempts replay to their bits from start and moments, with 1 and 2 threads", "[app][long]") {
    const fs::path all = scratchFolder("scripted-attempts");
    const auto scripts = attemptScripts();
    REQUIRE(scripts.size() == 20);
    for (size_t i = 0; i < scripts.size(); ++i) {
        INFO(scripts[i].name);
        const Recording recording = readRecording(recordAttempt(scripts[i], folderOf(all, i)));
        CHECK_FALSE(recording.damaged());
        CHECK(recording.seconds() >= scripts[i].seconds - 0.05);
        CHECK(recording.changes.size() >= scripts[i].changes.size());
        CHECK(readRecordedAttempt(recording.file)->redone == (scripts[i].redo == kNever ? 0 : 1));
    }
    CHECK(replayAllWith("1", all) == 0);
    CHECK(replayAllWith("2", all) == 0);
}

TEST_CASE("the attempts of a folder are replayed (by the test of twenty, in a program of its own)",
          "[app][long][scripted-replay]") {
    const char* folder = std::getenv(kFolderKey);
    if (folder != nullptr) replayAll(folder);
}
