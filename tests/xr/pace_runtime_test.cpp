// Tests the pace of the whole program on a real runtime: the metal's time is the hand's time at the display's rate,
// also on a machine with little time for the program; if it cannot be, a notice appears before the person's eyes.
// tests/xr/CMakeLists.txt runs it at other display rates too.
#include "core/base/text.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/little_time.hpp"
#include "tests/xr/trainee.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kHandSpeed = 0.01; ///< m/s in the workpiece's frame; 40 mm/s in the room at zoom 4

/// Moves the torch to and fro above the metal at constant speed, to its place at this moment.
void sweep(Trainee& trainee, Clock::time_point begin, float trigger) {
    constexpr double kWay = 0.05; // m in the workpiece's frame
    const double turns = std::chrono::duration<double>(Clock::now() - begin).count() * kHandSpeed / kWay;
    const double part = std::abs(std::remainder(turns, 2.0)); // 0..1..0
    trainee.aim({float(-0.02 + kWay * part), 0.03f, 0.018f}, trigger);
}

/// Differences between two rows of the telemetry.
struct Stretch {
    double real = 0;  ///< s
    double metal = 0; ///< s
    double way = 0;   ///< way of the torch along x in the metal's frame, to and fro added up, m
    double steps = 0, frames = 0;
    double ratio() const { return metal / real; }
    double speedInMetal() const { return way / metal; }
};

/// Collects the given rows, one after the other.
class Rows {
  public:
    void add(const json& row) {
        const json& metal = row["metal"];
        rows_.push_back({row["seconds"], metal["time"], 1e-3 * row["torch"]["tip_mm"][0].get<double>(), metal["steps"],
                         row["frame"]});
    }
    /// Returns the stretch of the last `seconds` of real time.
    Stretch last(double seconds) const {
        Stretch stretch;
        for (size_t i = rows_.size(); i-- > 1 && stretch.real < seconds;) {
            const Row &now = rows_[i], &before = rows_[i - 1];
            stretch.real += now.real - before.real;
            stretch.metal += now.metal - before.metal;
            stretch.way += std::abs(now.x - before.x);
            stretch.steps += now.steps - before.steps;
            stretch.frames += now.frames - before.frames;
        }
        return stretch;
    }

  private:
    struct Row {
        double real, metal, x, steps, frames;
    };
    std::vector<Row> rows_;
};

bool toldSlow(const json& row) {
    return row["headset"]["notice"].get<std::string>().find("too slow") != std::string::npos;
}

/// Returns true if a busy machine has no time for more: frames are few, each takes several steps all the same, and a
/// message says so.
bool machineIsBusy(const json& row, const Stretch& stretch) {
    return stretch.real >= 3 && stretch.steps > 3 * stretch.frames && toldSlow(row);
}

/// Returns the requested rate of this run's runtime, Hz.
double askedRate() {
    const char* rate = std::getenv("XRT_COMPOSITOR_DEFAULT_FRAMERATE");
    return rate != nullptr ? std::strtod(rate, nullptr) : 60;
}

} // namespace

TEST_CASE("the metal goes at the hand's speed at the display's rate; what it cannot is told before the eyes",
          "[runtime][pace]") {
    handGeometry();
    const fs::path folder = runFolder() / ("pace" + formatNumber(askedRate()));
    const fs::path record = folder / "weld.csv";
    Trainee trainee;
    TrainerProcess trainer(folder,
                           {"--headset", "--lesson", smallLesson(folder).string(), "--record", record.string()});
    REQUIRE(trainer.waitFor(ready));
    // A runtime that finds a program slow asks it for every second frame, or third ...
    const double frames = askedRate() / trainer.now()["headset"]["display_hz"].get<double>();
    CHECK(frames > 0.9);
    CHECK(frames == Approx(std::round(frames)).epsilon(0.03));
    const Clock::time_point begin = Clock::now();
    // After a frame of seconds the tip is far from its last place, which puts the heat out until the trigger is let go.
    const auto move = [&] { sweep(trainee, begin, trainer.now()["headset"]["trigger_locked"] == true ? 0.0f : 1.0f); };
    const auto signal = [&](int number) { trainer.signal(number); };
    // The torch's way in the metal's time equals the hand's in real time, as soon as the machine has time for three
    // seconds.
    const auto keepsUp = [&](const std::string& when) {
        Rows rows;
        Stretch stretch;
        BusyMachine machine;
        const char* why = "";
        const bool reached = trainer.waitFor(
            [&](const json& row) {
                rows.add(row);
                stretch = rows.last(3);
                why = "in time";
                if (row["metal"]["speed"] > 0.95 && !toldSlow(row) && stretch.real >= 3 && stretch.ratio() > 0.95 &&
                    std::abs(stretch.speedInMetal() / kHandSpeed - 1) < 0.1)
                    return true;
                why = "the machine is busy, which is told";
                if (machineIsBusy(row, stretch)) return true;
                why = "the machine is too busy to judge";
                return machine.excuses();
            },
            move);
        WARN(when << ", " << why << ": metal at " << stretch.ratio() << " of real time, the torch at "
                  << 1000 * stretch.speedInMetal() << " mm/s in it, "
                  << trainer.now()["frames_per_second"].get<double>() << " frames a second");
        CHECK(reached);
    };
    keepsUp("left alone");
    {
        const LittleTime fewFrames(signal, 0.085, 0.05);
        keepsUp("stopped for 50 of 85 ms");
    }
    {
        const LittleTime slow(signal, 1.2, 1.0);
        CHECK(trainer.waitFor([](const json& row) { return toldSlow(row) && row["metal"]["speed"] < 0.8; }, move));
    }
    Rows rows;
    BusyMachine machine;
    CHECK(trainer.waitFor(
        [&](const json& row) {
            rows.add(row);
            return !toldSlow(row) || machineIsBusy(row, rows.last(3)) || machine.excuses();
        },
        move));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    const auto attempt = readRecordedAttempt(record);
    REQUIRE(attempt);
    REQUIRE(attempt->realTime);
    CHECK(*attempt->realTime < 1);
    CHECK_THAT(readTextFile(record), containsText("# least_real_time 0."));
}
