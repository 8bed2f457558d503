// Checkpoints of the whole metal in a recording: from each of them the attempt continues to its own bits.
#include "core/training/attempt/recorded_checkpoints.hpp"

#include "core/training/attempt/checkpoint_ring.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/judging/judgement.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/attempt/checkpoint_bench.hpp"

#include <chrono>
#include <thread>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

/// Welds to this step; every ten steps a checkpoint is stored before the weld continues.
void weld(CheckpointRing& moments, Trainer& trainer, const std::string& process, size_t step) {
    while (trainer.steps() < step) {
        test::runTo(trainer, process, trainer.steps() + 1);
        if (trainer.steps() % 10 != 0 || !moments.due(trainer.time())) continue;
        const size_t count = moments.count();
        trainer.capture(moments.capture(), moments.historyTo());
        moments.begun(trainer.time(), trainer.technique() ? trainer.technique()->steps().size() : 0);
        for (int i = 0; i < 6000 && moments.count() == count; ++i) {
            moments.update();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        REQUIRE(moments.count() == count + 1);
    }
}

/// Records an attempt of 80 steps with a change of voltage and one return, and a checkpoint every ten steps.
fs::path recordedAttempt(const std::string& process) {
    const fs::path file = test::scratchFolder("recorded-moments-" + process) / "a.meltrec";
    Trainer trainer(test::shaders(), test::checkpointLesson(process));
    const auto writer = std::make_shared<RecordingWriter>(file, trainer.attemptHead());
    trainer.recordInto(writer);
    CheckpointRing moments({0.01, size_t(1) << 30});
    size_t first = 0, bytes = 0, count = 0;
    moments.clear([&](const PackedCheckpoint& moment) {
        (first == 0 ? first : bytes) += moment.bytes.size();
        ++count;
        writer->checkpoint(moment.step, {moment.bytes.begin(), moment.bytes.end()});
    });
    weld(moments, trainer, process, 35);
    if (process == "gmaw") {
        trainer.change("voltage", "23", "the test");
        trainer.event("torch", "lost");
        weld(moments, trainer, process, 60);
        trainer.event("torch", "seen");
        const auto moment = moments.before(trainer.time() - 1e-6 - 9 * trainer.timeStep());
        REQUIRE(moment);
        REQUIRE(moment->step == 50);
        trainer.redo(*moment);
        moments.branch(moment->step);
    }
    weld(moments, trainer, process, 80);
    moments.clear();
    trainer.stopRecord("the test ended");
    writer->wait();
    REQUIRE(writer->fault().empty());
    WARN(process << ": the first moment takes " << first << " bytes, the others " << bytes / (count - 1)
                 << " on average");
    return file;
}

std::optional<Technique> techniqueFor(const Lesson& lesson) {
    if (lesson.model != LessonModel::Weld) return std::nullopt;
    return techniqueOf(lesson.workpiece, lesson.process, lesson.technique);
}

void demonstrateTo(Trainer& trainer, size_t step) {
    while (trainer.steps() < step)
        trainer.advanceDemonstration(nullptr);
}

} // namespace

TEST_CASE("from each moment of a recording the attempt goes on to its own bits", "[training]") {
    for (const std::string process : {"gmaw", "classic"}) {
        INFO(process);
        const fs::path file = recordedAttempt(process);
        Lesson lesson = test::checkpointLesson(process);
        takeTorch(lesson, file);
        const Recording recording = readSoundRecording(file);
        CHECK(recording.checkpoints.size() == 8);
        CHECK(recording.redone == (process == "gmaw" ? 1 : 0));
        RecordedCheckpoints moments(recording, techniqueFor(lesson));
        REQUIRE(moments.count() == recording.checkpoints.size());
        CHECK_FALSE(moments.beforeStep(9));
        CHECK_FALSE(moments.timeBefore(0));
        CHECK_FALSE(moments.before(0));
        Trainer stepped(test::shaders(), lesson), sought(test::shaders(), lesson);
        for (const size_t step : {size_t(14), size_t(43), size_t(55), size_t(80)}) {
            demonstrateTo(stepped, step);
            const auto moment = moments.beforeStep(step);
            REQUIRE(moment);
            CHECK(moment->step == step / 10 * 10);
            CHECK(moments.timeBefore(stepped.time() + 1e-9) == moment->time);
            sought.restore(*moment);
            demonstrateTo(sought, step);
            CHECK(test::endOf(sought) == test::endOf(stepped));
        }
        CHECK(sameEnd(*lesson.recorded, sought.steps(), sought.result().stateHash) == true);
        const auto back = moments.before(recording.steps[24].torch.time);
        REQUIRE(back);
        CHECK(back->step == 20);
        sought.restore(*back);
        demonstrateTo(sought, 80);
        CHECK(test::endOf(sought) == test::endOf(stepped));
    }
}
