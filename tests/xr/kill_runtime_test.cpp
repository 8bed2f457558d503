// A lesson in the headset ends without warning or on a signal: the record is whole and nearly all of the metal's time
// is in it.
#include "tests/support/catch.hpp"
#include "tests/support/record_check.hpp"
#include "tests/xr/trainee.hpp"

#include <csignal>
#include <random>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

/// s of the metal's time that may be missing in a record.
constexpr double kMayBeMissing = 0.2;

/// Welds in the headset, ends the program by the signal after `seconds`, and looks at the record.
void endInMidWeld(Trainee& trainee, int signal, double seconds, int number) {
    INFO("signal " << signal << " after " << seconds << " s");
    const std::filesystem::path folder = benchFolder() / ("ended " + std::to_string(number));
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
    trainee.aim(glm::vec3(0.06f), 0.0f);
}

void endAtRandomMoments(int count) {
    handGeometry();
    Trainee trainee;
    std::mt19937 random(20);
    std::uniform_real_distribution<double> moment(0, 2);
    int number = 0;
    for (int i = 0; i < count; ++i)
        for (const int signal : {SIGKILL, SIGTERM, SIGINT})
            endInMidWeld(trainee, signal, moment(random), ++number);
}

} // namespace

TEST_CASE("a lesson in the headset that is killed, ended or interrupted leaves a whole record", "[runtime]") {
    endAtRandomMoments(1);
}

TEST_CASE("a lesson in the headset ended at 51 random moments leaves a whole record", "[runtime][long]") {
    endAtRandomMoments(17);
}
