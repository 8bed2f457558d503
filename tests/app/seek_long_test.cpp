// Time of a seek within a two-minute attempt and size of its recording on the disk; MELTPOOL_KEEP=FOLDER leaves the
// recording there.
#include "app/platform/program_info.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

constexpr double kFrame = 1.0 / 45;
constexpr double kSeconds = 120;
constexpr double kPeriod = 12, kArcTime = 5; ///< s: beads of 40 mm, with pauses in which the plate cools

Lesson shippedBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.choose.clear();
    return lesson;
}

/// A path of beads, each next to the last.
TorchSample torchAt(double time) {
    const double bead = std::floor(time / kPeriod), since = time - bead * kPeriod;
    TorchSample torch;
    torch.tip = {static_cast<float>(-0.020 + 8e-3 * std::min(since, kArcTime)), 0.003F,
                 static_cast<float>(0.003 * (std::fmod(bead, 5) - 2))};
    torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
    torch.trigger = since < kArcTime ? 1.0F : 0.0F;
    return torch;
}

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

fs::path recordedIn(const fs::path& folder) {
    LessonSession session(test::shaders(), shippedBead(), now); // checkpoints are closer together on a slow machine
    session.log().recordings().use(folder, thisMachine().program, thisMachine().driver);
    Controls controls;
    session.begin(controls);
    const double step = 1.0 / 90;
    const TorchSource lead = [&](int ahead, int) {
        return torchAt(static_cast<double>(session.run().steps() + static_cast<size_t>(ahead)) * step);
    };
    while (session.run().torch().time < kSeconds && session.run().fault().empty())
        session.advance(controls, kFrame, nullptr, lead);
    CHECK(session.run().fault().empty());
    session.end("the test ended");
    session.log().recordings().finish();
    CHECK(session.log().recordings().lost() == "");
    return session.log().recordings().file();
}

} // namespace

TEST_CASE("any second of a two-minute attempt is come to from the moments of its recording", "[app][seek][long]") {
    const char* kept = std::getenv("MELTPOOL_KEEP");
    const fs::path folder =
        kept != nullptr && *kept != 0 ? fs::path(kept) / "two-minutes" : test::scratchFolder("two-minutes");
    const fs::path file = recordedIn(folder);
    const Recording recording = readSoundRecording(file);
    REQUIRE(recording.seconds() >= kSeconds - 0.1);
    CHECK(static_cast<double>(recording.checkpoints.size()) > kSeconds / 1.5);
    WARN(recording.checkpoints.size() << " moments; the recording takes "
                                      << static_cast<double>(fs::file_size(file)) / recording.seconds() * 60 / 1e6
                                      << " MB a minute");

    Lesson lesson = shippedBead();
    takeTorch(lesson, file);
    LessonSession session(test::shaders(), shippedBead(), [] { return 0.0; });
    Controls controls;
    session.openReplay(lesson, controls);
    ReplayTimeline& line = session.activities().replay.line();
    line.toggle(); // stops playing between the seeks
    std::mt19937 random(7);
    std::uniform_real_distribution<double> second(1, kSeconds - 1);
    double longest = 0, sum = 0;
    constexpr int kSeeks = 16;
    for (int i = 0; i < kSeeks; ++i) {
        const double wanted = second(random), began = now();
        line.seek(wanted);
        do
            session.advance(controls, kFrame, nullptr, {});
        while (line.seeking());
        glFinish();
        const double took = now() - began;
        CHECK(session.run().torch().time == Approx(wanted).margin(0.05));
        longest = std::max(longest, took);
        sum += took;
    }
    CHECK(session.run().fault().empty());
    WARN("without drawing a seek took " << sum / kSeeks << " s on average, " << longest << " s at most");
}
