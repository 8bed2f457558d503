// Tests that a lesson in the headset, ended without warning or by a signal, leaves a complete record and recording with
// nearly all of the metal's time.
#include "core/training/attempt/recording_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/newest_recording.hpp"
#include "tests/support/record_check.hpp"
#include "tests/xr/trainee.hpp"

#include <csignal>
#include <initializer_list>
#include <random>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

/// Metal's time that may be missing in a record or a recording, s.
constexpr double kMayBeMissing = 0.2;

/// Welds in the headset, ends the program by the signal after `seconds`, and checks the record.
void endInMidWeld(Trainee& trainee, int signal, double seconds, int number) {
    INFO("signal " << signal << " after " << seconds << " s");
    const std::filesystem::path folder = runFolder() / ("ended " + std::to_string(number));
    std::filesystem::remove_all(folder); // another test's rows there would count as this one's
    const std::filesystem::path record = folder / "record.csv";
    TrainerProcess trainer(folder,
                           {"--headset", "--lesson", smallLesson(folder).string(), "--record", record.string()});
    REQUIRE(trainer.waitFor([](const json& row) { return running(row) && row["metal"]["steps"] > 2; }));
    trainee.aim(glm::vec3(0.018f), 1.0f);
    sleepFor(seconds);
    trainer.signal(signal);
    CHECK(trainer.finish() == (signal == SIGKILL ? 128 + SIGKILL : 0));
    const double time = trainer.now()["metal"]["time"];
    const RecordCheck check = checkRecord(record);
    for (const std::string& line : check.broken)
        UNSCOPED_INFO(line);
    CHECK(check.whole());
    CHECK(check.lastTime >= time - kMayBeMissing);
    CHECK(check.ended.empty() == (signal == SIGKILL));
    const Recording recording = readRecording(newestRecording(folder / "meltpool" / "recordings"));
    UNSCOPED_INFO(recording.stateSentence());
    CHECK_FALSE(recording.damaged());
    CHECK(recording.seconds() >= time - kMayBeMissing);
    CHECK(recording.end.has_value() == (signal != SIGKILL));
    // The recording contains the person in the headset too.
    REQUIRE_FALSE(recording.people.empty());
    CHECK(recording.people.back().head.has_value());
    CHECK((recording.people.back().left.has_value() || recording.people.back().right.has_value()));
    trainee.aim(glm::vec3(0.06f), 0.0f);
}

void endAtRandomMoments(int count, std::initializer_list<int> signals, unsigned seed = 20) {
    handGeometry();
    Trainee trainee;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moment(0, 2);
    int number = 0;
    for (int i = 0; i < count; ++i)
        for (const int signal : signals)
            endInMidWeld(trainee, signal, moment(random), ++number);
}

} // namespace

TEST_CASE("a lesson in the headset that is killed, ended or interrupted leaves a whole record", "[runtime]") {
    endAtRandomMoments(1, {SIGKILL, SIGTERM, SIGINT});
}

TEST_CASE("a lesson in the headset killed at 50 random moments leaves record and recording whole", "[runtime][long]") {
    endAtRandomMoments(50, {SIGKILL}, 21);
}

TEST_CASE("a lesson in the headset ended at 34 random moments leaves a whole record", "[runtime][long]") {
    endAtRandomMoments(17, {SIGTERM, SIGINT}, 22);
}
