// The Trainer on the classic lesson: only the heated corner melts and freezes again, and runs repeat bit by bit.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/trainer/classic_model.hpp"
#include "core/training/trainer/trainer.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/vec4.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

constexpr int kParticles = 2744; // 14 an axis: small enough for a software driver

Lesson smallLesson() {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = kParticles;
    lesson.metal.supportRadius = 0.1f;
    lesson.surface.cells = 16;
    return lesson;
}

TorchSample flameAt(float mm, float trigger) {
    const float metres = mm * 1e-3f;
    return {0, {metres, metres, metres}, {1, 0, 0, 0}, trigger};
}

void repeat(Trainer& trainer, const TorchSample& torch, int steps) {
    for (int i = 0; i < steps; ++i)
        trainer.advance(torch, nullptr);
}

/// Returns the hottest particle in the octant of the box that `side` points into, by the start's places.
float hottestNear(const Trainer& trainer, float side) {
    const ParticleView particles = trainer.metal().particles();
    float hottest = 0;
    for (const glm::vec4& p : particles.positions->read<glm::vec4>(particles.count))
        if (p.x * side > 0.2f && p.y * side > 0.2f && p.z * side > 0.2f) hottest = std::max(hottest, p.w);
    return hottest;
}

/// Returns a torch that points straight down.
TorchSample upright(const glm::vec3& tip) {
    TorchSample torch;
    torch.tip = tip;
    torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
    return torch;
}

/// Returns the GMAW lesson on a plate of 24x20 mm.
Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 32;
    return lesson;
}

} // namespace

TEST_CASE("the flame melts the corner under it, the opposite corner stays cold, and it freezes again", "[training]") {
    Lesson lesson = smallLesson();
    lesson.metal.solidifyRate = 0.01f;
    Trainer trainer(test::shaders(), lesson);
    trainer.waitForFigures(true);
    CHECK(trainer.figures().molten == 0);
    repeat(trainer, flameAt(21, 1), 60);
    CHECK(trainer.figures().molten > 10);
    CHECK(trainer.figures().molten < kParticles / 2);
    CHECK(hottestNear(trainer, 1) > 0.5f);
    CHECK(hottestNear(trainer, -1) == 0);
    repeat(trainer, flameAt(36, 0), 105);
    CHECK(trainer.figures().molten == 0);
    CHECK(trainer.figures().maxTemperature == 0);
    CHECK(trainer.figures().lost == 0);
    CHECK(trainer.figures().nonFinite == 0);
    CHECK(trainer.steps() == 165);
    CHECK(trainer.time() == Approx(165.0 / 60));
}

TEST_CASE("the trigger's pull is the source's strength", "[training]") {
    Lesson lesson = smallLesson();
    lesson.metal.solidifyRate = 0;
    const auto heatAfterOneStep = [&](float trigger) {
        Trainer trainer(test::shaders(), lesson);
        trainer.waitForFigures(true);
        trainer.advance(flameAt(20, trigger), nullptr);
        return trainer.figures().maxTemperature;
    };
    CHECK(heatAfterOneStep(0) == 0);
    CHECK(heatAfterOneStep(0.5f) == Approx(0.5 * heatAfterOneStep(1)));
}

TEST_CASE("a cold source takes back what a hot one gave", "[training]") {
    Lesson lesson = smallLesson();
    lesson.metal.solidifyRate = 0;
    Trainer trainer(test::shaders(), lesson);
    trainer.waitForFigures(true);
    repeat(trainer, flameAt(21, 1), 20);
    const double before = trainer.figures().meanTemperature;
    trainer.lesson().source.kind = 1;
    repeat(trainer, flameAt(21, 1), 10);
    CHECK(trainer.figures().meanTemperature < before);
}

TEST_CASE("reset, a second trainer and a replay of the record all give the same bits", "[training]") {
    const auto folder = test::scratchFolder("trainer");
    Trainer trainer(test::shaders(), smallLesson());
    const auto run = [](Trainer& t) {
        for (int i = 0; i < 50; ++i)
            t.advance(t.demonstration(), nullptr);
        return t.result().stateHash;
    };
    trainer.record(folder / "first.csv");
    const auto first = run(trainer);
    trainer.reset();
    CHECK(trainer.time() == 0);
    CHECK(trainer.steps() == 0);
    CHECK_FALSE(trainer.writesCsvRecord());
    CHECK(run(trainer) == first);

    Trainer second(test::shaders(), smallLesson());
    CHECK(run(second) == first);

    Lesson replayed = smallLesson();
    replayed.torch = TorchPath::read(folder / "first.csv");
    Trainer replay(test::shaders(), replayed);
    CHECK(run(replay) == first);
    replay.advance(flameAt(21, 1), nullptr);
    CHECK(replay.result().stateHash != first);
}

TEST_CASE("each row of a record has the figures of its own step", "[training]") {
    const auto file = test::scratchFolder("figures") / "record.csv";
    Trainer trainer(test::shaders(), smallLesson());
    trainer.record(file);
    std::vector<std::string> means;
    for (int i = 0; i < 60; ++i) {
        trainer.advance(flameAt(21, 1), nullptr);
        means.push_back(formatNumber(trainer.result().metal.meanTemperature));
    }
    trainer.stopRecord();
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.furtherColumns[2] == "mean_temperature");
    REQUIRE(recording.samples.size() == means.size());
    for (size_t i = 0; i < means.size(); ++i)
        CHECK(recording.furtherCells[i][2] == means[i]);
    CHECK(means.back() != means[means.size() - 2]); // late figures would be detected
}

TEST_CASE("an attempt whose values changed on the way is repeated from its record to the same bits", "[training]") {
    const auto file = test::scratchFolder("changes") / "record.csv";
    Trainer trainer(test::shaders(), smallLesson());
    trainer.change("solidify_rate", "0", "a menu"); // before the record: a start value
    trainer.record(file);
    for (int i = 0; i < 60; ++i) {
        if (i == 20) trainer.change("heat_temperature", "0.2", "a menu");
        if (i == 30) trainer.event("recentred");
        if (i == 40) trainer.change("time_step", "0.01", "a menu");
        trainer.advance(flameAt(21, 1), nullptr);
    }
    trainer.stopRecord("reset");
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    CHECK(attempt->changes.size() == 2);
    CHECK(attempt->ended == "reset");

    Lesson again = smallLesson();
    again.torch = TorchPath::read(file);
    repeatAttempt(again, *attempt);
    Trainer replay(test::shaders(), again);
    for (size_t i = 0; i < again.recorded->rows; ++i)
        replay.advanceDemonstration(nullptr);
    CHECK(replay.time() == trainer.time());
    CHECK(replay.result().stateHash == trainer.result().stateHash);
    CHECK(formatHexadecimal(replay.result().stateHash) == attempt->stateHash);

    Lesson without = again;
    without.recorded->changes.clear();
    Trainer other(test::shaders(), without);
    for (size_t i = 0; i < again.recorded->rows; ++i)
        other.advanceDemonstration(nullptr);
    CHECK(other.result().stateHash != trainer.result().stateHash);
}

TEST_CASE("a weld whose current changed under the arc is repeated to the same bits, and resets to its start",
          "[training]") {
    Lesson lesson = smallBead();
    lesson.choose.clear();
    lesson.process.choose<Gtaw>().current = 120;
    const auto file = test::scratchFolder("weld-changes") / "record.csv";
    TorchSample torch = upright({0, 0.002f, 0});
    torch.trigger = 1;
    Trainer trainer(test::shaders(), lesson);
    trainer.record(file);
    repeat(trainer, torch, 30);
    trainer.change("current", "180", "a menu");
    repeat(trainer, torch, 30);
    trainer.stopRecord();
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    Lesson again = lesson;
    again.torch = TorchPath::read(file);
    repeatAttempt(again, *attempt);
    Trainer replay(test::shaders(), again);
    for (int run = 0; run < 2; ++run) {
        for (size_t i = 0; i < again.recorded->rows; ++i)
            replay.advanceDemonstration(nullptr);
        CHECK(formatHexadecimal(replay.result().stateHash) == attempt->stateHash);
        replay.reset(); // takes back the recorded change
    }
}

TEST_CASE("a replay of an attempt that lost its torch or samples is not scored, with the attempt's reason",
          "[training]") {
    const bool tracking = GENERATE(true, false);
    const auto file = test::scratchFolder("lost-replay") / "record.csv";
    TorchSample torch = upright({0, 0.003f, 0});
    torch.trigger = 1;
    Trainer trainer(test::shaders(), smallBead());
    trainer.record(file);
    repeat(trainer, torch, 40);
    REQUIRE(trainer.arc().burns());
    if (tracking)
        trainer.event("torch", "lost");
    else
        trainer.event("samples", "dropped");
    repeat(trainer, torch, 9);
    if (tracking) trainer.event("torch", "seen");
    repeat(trainer, torch, 11);
    trainer.stopRecord();
    const TechniqueFaults& faults = trainer.technique()->faults();
    CHECK(faults.lostSeconds == (tracking ? Approx(9 * trainer.timeStep()) : Approx(0)));
    CHECK(faults.dropped == (tracking ? 0 : 1));
    CHECK_FALSE(unknownPlaces(*trainer.technique()).empty());

    Lesson again = smallBead();
    again.torch = TorchPath::read(file);
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    CHECK(attempt->events.size() == (tracking ? 2 : 1));
    repeatAttempt(again, *attempt);
    Trainer replay(test::shaders(), again);
    const auto copy = file.parent_path() / "copy.csv";
    replay.record(copy);
    for (size_t i = 0; i < again.recorded->rows; ++i)
        replay.advanceDemonstration(nullptr);
    replay.stopRecord();
    CHECK(replay.technique()->faults().lostSeconds == Approx(faults.lostSeconds));
    CHECK(replay.technique()->faults().dropped == faults.dropped);
    CHECK(unknownPlaces(*replay.technique()) == unknownPlaces(*trainer.technique()));
    const Judgement first = trainer.judge(), second = replay.judge();
    REQUIRE((first.score && second.score));
    CHECK_FALSE(first.score->scored);
    CHECK_FALSE(second.score->scored);
    CHECK(second.score->reason == first.score->reason);
    CHECK(readRecordedAttempt(copy)->events.size() == attempt->events.size()); // the replay's record has them too
}

TEST_CASE("a disk that is full in mid-attempt ends the record, not the weld", "[training]") {
    const char* full = "/dev/full";
    if (!std::filesystem::exists(full)) return;
    Trainer trainer(test::shaders(), smallLesson());
    CHECK_THROWS_AS(trainer.record(full), RuntimeFault);
    CHECK_FALSE(trainer.writesCsvRecord());
    repeat(trainer, flameAt(21, 1), 3);
    CHECK(trainer.steps() == 3);
}

TEST_CASE("the classic source stays inside its box", "[training]") {
    CHECK(classicSourcePosition({0.02f, -0.01f, 0}) == glm::vec3(0.5f, -0.25f, 0));
    CHECK(classicSourcePosition({1, -1, 0.05f}) == glm::vec3(1, -1, 1));
}

TEST_CASE("an arc that goes out stands in the record with the process's reason, before the next step", "[training]") {
    Lesson lesson = smallBead();
    lesson.process.choose<Gtaw>().current = 130;
    Trainer trainer(test::shaders(), lesson);
    const auto file = test::scratchFolder("arc-out-record") / "telemetry.csv";
    trainer.record(file);
    const auto hold = [&](float mm, float trigger, int steps) {
        TorchSample torch = upright({0, mm * 1e-3f, 0});
        torch.trigger = trigger;
        repeat(trainer, torch, steps);
    };
    hold(3, 1, 20);
    REQUIRE(trainer.arc().burns());
    hold(3, 0, 5); // the release is not an event
    hold(3, 1, 5);
    hold(20, 1, 10);
    CHECK(trainer.arc().noArc == NoArc::tooLong);
    hold(3, 0, 5);
    hold(3, 1, 5);
    hold(0, 1, 10);
    trainer.stopRecord();
    const std::string text = readTextFile(file);
    const size_t tooLong = text.find("# event arc_out too_long\n"), touched = text.find("# event arc_out touched\n");
    REQUIRE(tooLong < touched);
    REQUIRE(touched != std::string::npos);
    CHECK(text.find("# event arc_out", touched + 1) == std::string::npos);
    // The row before the event is the first without an arc.
    CHECK(text.rfind(",out,", tooLong) > text.rfind("burning", tooLong));
    CHECK(text.rfind('\n', text.rfind(",out,", tooLong)) > text.rfind("burning", tooLong));
}

TEST_CASE("a weld's record has the arc of each step", "[training]") {
    Trainer trainer(test::shaders(), smallBead());
    const auto file = test::scratchFolder("arc-record") / "telemetry.csv";
    trainer.record(file);
    TorchSample torch = upright({0, 0.003f, 0});
    torch.trigger = 1;
    std::vector<ArcState> arcs;
    for (int i = 0; i < 40; ++i) {
        trainer.advance(torch, nullptr);
        arcs.push_back(trainer.arc());
    }
    trainer.stopRecord();
    CHECK(arcs.back().burns());
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.samples.size() == arcs.size());
    const auto column = [&](std::string_view name) {
        const auto& names = recording.furtherColumns;
        const auto found = std::find(names.begin(), names.end(), name);
        REQUIRE(found != names.end());
        return static_cast<size_t>(found - names.begin());
    };
    const size_t length = column("arc_length_mm"), current = column("current_a"), voltage = column("voltage_v"),
                 state = column("arc_state");
    for (size_t i = 0; i < arcs.size(); ++i) {
        const auto& cells = recording.furtherCells[i];
        CHECK(std::stod(cells[length]) == Approx(double(arcs[i].length) * 1e3));
        CHECK(std::stod(cells[current]) == Approx(double(arcs[i].current)));
        CHECK(std::stod(cells[voltage]) == Approx(double(arcs[i].voltage)));
        CHECK(cells[state] == arcActionName(arcs[i].action));
    }
}
