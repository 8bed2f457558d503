// Checkpoints: an attempt that continues from one ends in the bits of the uninterrupted attempt, with every process, in
// used and in new metal; damaged or foreign checkpoints are refused.
#include "core/base/error.hpp"
#include "core/training/attempt/packing.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/resident_bytes.hpp"
#include "tests/training/attempt/checkpoint_bench.hpp"

#include <chrono>

using namespace meltpool;

namespace {

constexpr size_t kSaved = 50; ///< number of steps before a checkpoint; not a whole number of the fragments' cycles
constexpr size_t kEnd = 90;

/// Returns the milliseconds that `work` takes.
template <class Work>
double milliseconds(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

TEST_CASE("every process goes on from a checkpoint with the same bits, in its own metal and in a new one",
          "[training]") {
    for (const std::string& process : test::checkpointProcesses()) {
        INFO(process);
        Trainer trainer(test::shaders(), test::checkpointLesson(process));
        test::runTo(trainer, process, kSaved);
        const std::string atSave = test::endOf(trainer);
        const Checkpoint checkpoint = trainer.save();
        CHECK(checkpoint.step == kSaved);
        CHECK(checkpoint.time == trainer.time());
        CHECK(test::endOf(trainer) == atSave);
        test::runTo(trainer, process, kEnd);
        const std::string end = test::endOf(trainer);
        REQUIRE(end != atSave);

        trainer.restore(checkpoint);
        CHECK(test::endOf(trainer) == atSave);
        CHECK(trainer.save().hash == checkpoint.hash);
        test::runTo(trainer, process, kEnd);
        CHECK(test::endOf(trainer) == end);

        Trainer fresh(test::shaders(), test::checkpointLesson(process));
        fresh.restore(checkpoint);
        CHECK(test::endOf(fresh) == atSave);
        test::runTo(fresh, process, kEnd);
        CHECK(test::endOf(fresh) == end);
    }
}

TEST_CASE("the metal that is saved is a weld: it has a pool, and filler in it", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    const size_t cold = trainer.result().metal.particles;
    test::runTo(trainer, "gmaw", kSaved);
    CHECK(trainer.result().metal.molten > 10);
    CHECK(trainer.result().metal.particles > cold);
    CHECK(trainer.arc().burns());
}

TEST_CASE("a checkpoint of the start brings welded metal back to it, and one of later leads a new attempt there",
          "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    const Checkpoint start = trainer.save();
    test::runTo(trainer, "gmaw", 30);
    const Checkpoint later = trainer.save();
    const std::string end = test::endOf(trainer);
    trainer.restore(start);
    CHECK(trainer.steps() == 0);
    test::runTo(trainer, "gmaw", 30);
    CHECK(test::endOf(trainer) == end);
    trainer.reset();
    trainer.restore(later);
    CHECK(test::endOf(trainer) == end);
    trainer.restore(start);
    trainer.reset();
    test::runTo(trainer, "gmaw", 30);
    CHECK(test::endOf(trainer) == end);
}

TEST_CASE("values that were changed on the way are those of the checkpoint again", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    trainer.change("voltage", "21", "the test");
    test::runTo(trainer, "gmaw", 20);
    const Checkpoint checkpoint = trainer.save();
    test::runTo(trainer, "gmaw", 40);
    const std::string end = test::endOf(trainer);
    trainer.change("voltage", "17", "the test");
    trainer.change("wire_feed_m_min", "9", "the test");
    test::runTo(trainer, "gmaw", 60);
    trainer.restore(checkpoint);
    test::runTo(trainer, "gmaw", 40);
    CHECK(test::endOf(trainer) == end);
}

TEST_CASE("figures that are on their way when a checkpoint is restored are not taken for those of its metal",
          "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("classic"));
    const Checkpoint cold = trainer.save();
    trainer.waitForFigures(true);
    test::runTo(trainer, "classic", kEnd);
    const double hot = trainer.figures().maxTemperature;
    CHECK(hot > 0);
    trainer.waitForFigures(false);
    test::runTo(trainer, "classic", kEnd + 8);
    trainer.restore(cold);
    CHECK(trainer.figures().maxTemperature == 0);
    test::runTo(trainer, "classic", 1);
    CHECK(trainer.figures().maxTemperature < hot);
}

TEST_CASE("a record goes on over a checkpoint, each row with its own figures", "[training]") {
    const auto file = test::scratchFolder("checkpoint") / "record.csv";
    Trainer trainer(test::shaders(), test::checkpointLesson("classic"));
    trainer.record(file);
    test::runTo(trainer, "classic", 10);
    const Checkpoint checkpoint = trainer.save();
    test::runTo(trainer, "classic", 20);
    trainer.restore(checkpoint);
    trainer.event("redo", "10");
    test::runTo(trainer, "classic", 15);
    trainer.stopRecord();
    CHECK(trainer.recordFault().empty());
    const TorchRecording recording = readTorchCsv(file);
    CHECK(recording.samples.size() == 15);
    CHECK(recording.samples.back().time == Approx(trainer.time()));
}

TEST_CASE("ten restores in a row give the same metal and take no more memory", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    test::runTo(trainer, "gmaw", kSaved);
    const Checkpoint checkpoint = trainer.save();
    const std::string atSave = test::endOf(trainer);
    test::runTo(trainer, "gmaw", kEnd);
    const std::string end = test::endOf(trainer);
    trainer.restore(checkpoint);
    const size_t metal = trainer.result().metalBytes;
    for (int i = 0; i < 10; ++i) {
        test::runTo(trainer, "gmaw", kEnd);
        CHECK(test::endOf(trainer) == end);
        trainer.restore(checkpoint);
        CHECK(test::endOf(trainer) == atSave);
        CHECK(trainer.result().metalBytes == metal);
    }
    constexpr size_t kMore = 60;
    const size_t before = test::residentBytes();
    for (size_t i = 0; i < kMore; ++i)
        trainer.restore(checkpoint);
    CHECK(trainer.result().stateHash != 0);
    INFO(before << " bytes, " << checkpoint.bytes.size() << " of the checkpoint");
    CHECK(test::residentBytes() <= before + kMore / 3 * checkpoint.bytes.size());
}

TEST_CASE("a checkpoint that was damaged is refused, and the metal stays as it is", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    test::runTo(trainer, "gmaw", 12);
    const Checkpoint checkpoint = trainer.save();
    test::runTo(trainer, "gmaw", 16);
    const std::string now = test::endOf(trainer);
    const auto refused = [&](const Checkpoint& damaged) {
        CHECK_THROWS_AS(trainer.restore(damaged), InputError);
        CHECK(test::endOf(trainer) == now);
    };
    for (const size_t place : {size_t(0), checkpoint.bytes.size() / 2, checkpoint.bytes.size() - 1}) {
        Checkpoint damaged = checkpoint;
        damaged.bytes[place] ^= std::byte{1};
        refused(damaged);
    }
    Checkpoint damaged = checkpoint;
    damaged.bytes.resize(damaged.bytes.size() / 3);
    refused(damaged);
    damaged = checkpoint;
    damaged.history.pop_back();
    refused(damaged);
    seal(damaged); // its hash declares it whole
    refused(damaged);
    damaged = checkpoint;
    ++damaged.step;
    refused(damaged);
    refused({});
}

TEST_CASE("a checkpoint that is shorter or longer than the state is refused by its sizes", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    test::runTo(trainer, "gmaw", 12);
    const Checkpoint checkpoint = trainer.save();
    const std::string end = test::endOf(trainer);
    for (const size_t bytes : {size_t(0), size_t(5), checkpoint.bytes.size() / 2, checkpoint.bytes.size() - 1,
                               checkpoint.bytes.size() + 1}) {
        Checkpoint other = checkpoint;
        other.bytes.resize(bytes);
        seal(other);
        CHECK_THROWS_AS(trainer.restore(other), InputError);
        trainer.restore(checkpoint);
        CHECK(test::endOf(trainer) == end);
    }
}

TEST_CASE("a checkpoint of another lesson or workpiece is refused in a sentence", "[training]") {
    Trainer gmaw(test::shaders(), test::checkpointLesson("gmaw"));
    Trainer gtaw(test::shaders(), test::checkpointLesson("gtaw"));
    Lesson wider = test::checkpointLesson("gmaw");
    wider.workpiece.widthMm += 1;
    Trainer other(test::shaders(), wider);
    const Checkpoint checkpoint = gmaw.save();
    CHECK_THROWS_WITH(gtaw.restore(checkpoint), test::containsText("another lesson or workpiece"));
    CHECK_THROWS_WITH(other.restore(checkpoint), test::containsText("expected one of gmaw-bead"));
}

TEST_CASE("a checkpoint without the hand's first steps is for the attempt that has them", "[training]") {
    Trainer trainer(test::shaders(), test::checkpointLesson("gmaw"));
    test::runTo(trainer, "gmaw", 20);
    const Checkpoint whole = trainer.save();
    test::runTo(trainer, "gmaw", 30);
    const Checkpoint rest = trainer.save(20);
    CHECK(rest.history.size() * 2 == whole.history.size());
    test::runTo(trainer, "gmaw", 40);
    const std::string end = test::endOf(trainer);
    trainer.restore(rest);
    test::runTo(trainer, "gmaw", 40);
    CHECK(test::endOf(trainer) == end);

    Trainer fresh(test::shaders(), test::checkpointLesson("gmaw"));
    CHECK_THROWS_WITH(fresh.restore(rest), test::containsText("expected the attempt that saved it"));
    CHECK(fresh.steps() == 0);
    fresh.restore(whole);
    fresh.restore(rest);
    test::runTo(fresh, "gmaw", 40);
    CHECK(test::endOf(fresh) == end);
}

TEST_CASE("a checkpoint of 30,000 particles: what it takes", "[training][long]") {
    Trainer trainer(test::shaders(),
                    findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons"));
    trainer.advanceDemonstration(nullptr); // a recording's first checkpoint is that of the first step
    const Checkpoint start = trainer.save();
    for (int i = 1; i < 700; ++i)
        trainer.advanceDemonstration(nullptr);
    Checkpoint checkpoint, back;
    const Checkpoint before = trainer.save();
    for (int i = 0; i < 90; ++i)
        trainer.advanceDemonstration(nullptr);
    const double saving = milliseconds([&] { checkpoint = trainer.save(before.historyTo); });
    std::vector<std::byte> fromStart, fromBefore;
    const double packing = milliseconds([&] { fromStart = pack(checkpoint, start); });
    const double packingNear = milliseconds([&] { fromBefore = pack(checkpoint, before); });
    const double unpacking = milliseconds([&] { back = unpack(fromStart, start); });
    CHECK(back.hash == checkpoint.hash);
    const auto hash = trainer.result().stateHash;
    const double restoring = milliseconds([&] { trainer.restore(checkpoint); });
    CHECK(trainer.result().stateHash == hash);
    WARN(trainer.result().metal.particles
         << " particles, " << trainer.result().metal.molten << " molten: saved in " << saving << " ms as "
         << checkpoint.bytes.size() << " bytes; packed against the start in " << packing << " ms to "
         << fromStart.size() << ", against one a second before in " << packingNear << " ms to " << fromBefore.size()
         << "; unpacked in " << unpacking << " ms, restored in " << restoring << " ms");
}
