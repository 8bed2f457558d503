// The file of a recording: it reads back to the bit, damage is located, and a cut file opens.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_csv.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <fstream>
#include <limits>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& bytes, const std::string& name = "a.meltrec") {
    static const fs::path folder = test::scratchFolder("recording");
    std::ofstream(folder / name, std::ios::binary | std::ios::trunc) << bytes; // not synced to the disk: there are many
    return folder / name;
}

template <class Work>
std::string sentenceOf(Work work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

void checkStep(const RecordingStep& got, const RecordingStep& wanted) {
    // Equal bytes mean equal bits, infinite numbers included.
    CHECK(stepContent(got) == stepContent(wanted));
    CHECK(got.torch.rod.has_value() == wanted.torch.rod.has_value());
    CHECK(got.torch.tip == wanted.torch.tip);
    CHECK(got.torch.orientation == wanted.torch.orientation);
    CHECK(got.arc.rodInPool == wanted.arc.rodInPool);
}

/// Returns the begin of each frame, and the file's end.
std::vector<size_t> frameStarts(const std::string& bytes) {
    std::vector<size_t> starts{kRecordingSignature.size()};
    while (starts.back() < bytes.size()) {
        ByteReader head(std::string_view(bytes).substr(starts.back() + 4, 4));
        starts.push_back(starts.back() + kFrameBytes + head.u32());
    }
    return starts;
}

} // namespace

TEST_CASE("a recording reads back to the same bits", "[training]") {
    const std::string bytes = test::recordingOf("classic", 20);
    const Recording recording = readRecording(written(bytes));
    CHECK_FALSE(recording.fault);
    REQUIRE(recording.steps.size() == 20);
    for (int i = 1; i <= 20; ++i)
        checkStep(recording.steps[static_cast<size_t>(i - 1)], test::recordedStep(i));
    CHECK(recording.head.lesson == "classic");
    CHECK(recording.head.attempt == 3);
    CHECK(recording.head.driver == "a driver with two lines");
    CHECK(recording.head.values == test::recordedHead("").values);
    CHECK(recording.head.chosen == test::recordedHead("").chosen);
    REQUIRE(recording.changes.size() == 1);
    CHECK(recording.changes[0].name == "solidify_rate");
    CHECK(recording.changes[0].steps == 1);
    REQUIRE(recording.events.size() == 2);
    CHECK(recording.events[1].value == "lost");
    CHECK(recording.events[1].seconds == test::recordedStep(2).torch.time);
    REQUIRE(recording.end);
    CHECK(recording.end->score == 83.5);
    CHECK(recording.end->verdict == "accepted");
    CHECK(recording.end->leastRealTime == 1.0 / 3);
    // The path gives each row's own bits at the row's time.
    const TorchPath path = torchPathOf(recording);
    for (const RecordingStep& step : recording.steps) {
        const TorchSample sample = path.sample(step.torch.time);
        CHECK(sample.tip == step.torch.tip);
        CHECK(sample.orientation == step.torch.orientation);
    }
    WARN("a step takes " << kFrameBytes + kStepBytes
                         << " bytes: " << static_cast<double>(kFrameBytes + kStepBytes) * 90 * 60 / 1e6
                         << " MB a minute at 90 steps a second");
}

TEST_CASE("a recording and its table bear the name and the id of the person who welded", "[training]") {
    AttemptHead head = test::recordedHead("classic");
    head.person = "J\xC3\xBCrgen \"J\" M\xC3\xBCller / 2";
    head.personId = "0123456789abcdef";
    const fs::path file =
        written(test::RecordingBytes().head(head).step(test::recordedStep(1)).end(test::recordedEnd(1)).bytes(),
                "named.meltrec");
    const Recording recording = readRecording(file);
    CHECK(recording.head.person == head.person);
    CHECK(recording.head.personId == head.personId);
    CHECK(readRecordingSummary(file).head.person == head.person);
    const auto fromTable = readRecordedAttempt(written(recordingCsv(recording), "named.csv"));
    REQUIRE(fromTable);
    CHECK(fromTable->head.person == head.person);
    CHECK(fromTable->head.personId == head.personId);
    CHECK(readRecording(written(test::recordingOf("classic", 1))).head.person.empty()); // of before there were names
}

TEST_CASE("the table of a recording is a record of the same attempt", "[training]") {
    const fs::path file = written(test::recordingOf("classic", 20));
    const fs::path table = written(recordingCsv(readRecording(file)), "table.csv");
    const TorchRecording rows = readTorchCsv(table);
    REQUIRE(rows.samples.size() == 20);
    for (int i = 1; i <= 20; ++i) {
        const TorchSample &got = rows.samples[static_cast<size_t>(i - 1)], wanted = test::recordedStep(i).torch;
        CHECK(got.time == wanted.time);
        CHECK(got.tip == wanted.tip);
        CHECK(got.orientation == wanted.orientation);
        CHECK(got.rod.has_value() == wanted.rod.has_value());
        if (got.rod && wanted.rod) CHECK(got.rod->feed == wanted.rod->feed);
    }
    const auto fromTable = readRecordedAttempt(table), fromRecording = readRecordedAttempt(file);
    REQUIRE(fromTable);
    REQUIRE(fromRecording);
    CHECK(fromTable->head.lesson == fromRecording->head.lesson);
    CHECK(fromTable->head.driver == fromRecording->head.driver);
    CHECK(fromTable->head.program == fromRecording->head.program);
    CHECK(fromTable->rows == fromRecording->rows);
    CHECK(fromTable->ended == fromRecording->ended);
    CHECK(fromTable->stateHash == fromRecording->stateHash);
    CHECK(fromTable->values.size() == fromRecording->values.size());
    REQUIRE(fromTable->changes.size() == 1);
    REQUIRE(fromRecording->changes.size() == 1);
    CHECK(fromTable->changes[0].steps == fromRecording->changes[0].steps);
    CHECK(fromTable->changes[0].value == fromRecording->changes[0].value);
    REQUIRE(fromRecording->events.size() == 1); // a zoom does not affect the score
    CHECK(fromTable->events.size() == 1);
    CHECK(fromRecording->events[0].steps == 2);
}

TEST_CASE("a bit that is flipped anywhere is found in its own frame", "[training]") {
    const std::string whole = test::recordingOf("classic", 3);
    const std::vector<size_t> starts = frameStarts(whole);
    size_t frame = 0;
    for (size_t at = 0; at < whole.size(); ++at) {
        while (frame < starts.size() && at >= starts[frame])
            ++frame; // number of the frame that contains this byte, from 1; 0 is the signature
        for (int bit = 0; bit < 8; ++bit) {
            std::string bytes = whole;
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
            const fs::path file = written(bytes);
            INFO("byte " << at << ", bit " << bit);
            if (frame == 0) {
                CHECK_THROWS_WITH(readRecording(file), containsText("first 8 bytes"));
                continue;
            }
            const Recording recording = readRecording(file);
            if (!recording.damaged() || recording.fault->frame != frame || recording.fault->byte != starts[frame - 1])
                FAIL_CHECK("not found, or found elsewhere: " << recording.stateSentence());
            if (recording.frames != frame - 1) FAIL_CHECK(recording.frames << " frames are whole");
        }
    }
    CHECK(frame == starts.size() - 1);
}

TEST_CASE("a recording that ends at any byte opens with all its whole frames", "[training]") {
    const std::string whole = test::recordingOf("classic", 5);
    const std::vector<size_t> starts = frameStarts(whole);
    for (size_t length = 0; length <= whole.size(); ++length) {
        const fs::path file = written(whole.substr(0, length));
        const Recording recording = readRecording(file);
        size_t frames = 0;
        while (frames + 1 < starts.size() && starts[frames + 1] <= length)
            ++frames;
        INFO(length << " bytes: " << recording.stateSentence());
        CHECK_FALSE(recording.damaged());
        CHECK(recording.frames == frames);
        const bool onEdge = length >= starts[0] && starts[frames] == length;
        CHECK(recording.fault.has_value() == !onEdge);
        if (recording.steps.empty())
            CHECK_THROWS_AS(readRecordedAttempt(file), InputError);
        else
            CHECK(readRecordedAttempt(file)->rows == recording.steps.size());
        if (recording.frames > 0) {
            const RecordingSummary summary = readRecordingSummary(file);
            CHECK(summary.head.lesson == "classic");
            CHECK(summary.end.has_value() == (length == whole.size()));
            CHECK(summary.seconds == Approx(recording.seconds()));
        }
    }
}

TEST_CASE("what no attempt has is refused with frame and second, though its hashes fit", "[training]") {
    using test::RecordingBytes;
    const auto refusal = [](const RecordingBytes& recording) {
        const fs::path file = written(recording.bytes());
        return sentenceOf([&] { readRecording(file); });
    };
    const auto begun = [] {
        RecordingBytes recording;
        recording.head(test::recordedHead("classic")).step(test::recordedStep(1)).step(test::recordedStep(2));
        return recording;
    };
    RecordingStep step = test::recordedStep(3);
    step.torch.tip.x = std::numeric_limits<float>::quiet_NaN();
    CHECK_THAT(refusal(begun().step(step)), containsText("frame 4, after 0.02 s: a place is not within 100 m"));
    step = test::recordedStep(3);
    step.torch.orientation.w = 3;
    CHECK_THAT(refusal(begun().step(step)), containsText("expected a unit quaternion"));
    step = test::recordedStep(3);
    step.torch.time = 0.001;
    CHECK_THAT(refusal(begun().step(step)), containsText("expected a later one"));
    CHECK_THAT(refusal(begun().step(test::recordedStep(4))), containsText("it is step 4; expected step 3"));
    CHECK_THAT(refusal(begun().add(FrameKind::step, "short")), containsText("expected 160 bytes"));
    CHECK_THAT(refusal(begun().note(FrameKind::event, 7, "zoom", "2")), containsText("follows 7 steps; expected 2"));
    CHECK_THAT(refusal(begun().head(test::recordedHead("classic"))), containsText("expected it first, and once"));
    CHECK_THAT(refusal(RecordingBytes().step(test::recordedStep(1))), containsText("expected it first, and once"));
    CHECK_THAT(refusal(RecordingBytes().add(FrameKind::head, "format 2\nlesson x\n")), containsText("another format"));
    CHECK_THAT(sentenceOf([] { readRecording(written("time_s,x_mm\n")); }), containsText("does not begin like"));
    CHECK_THAT(sentenceOf([] { readRecording("nowhere/a.meltrec"); }), containsText("nowhere/a.meltrec: "));
}

TEST_CASE("a recording repeats its own lesson only, and damaged ones are not repeated", "[training]") {
    Lesson lesson;
    lesson.key = "bench";
    const fs::path file = written(test::recordingOf("bench", 10));
    takeTorch(lesson, file);
    CHECK(lesson.metal.solidifyRate == 0.25f);
    REQUIRE(lesson.recorded);
    CHECK(lesson.recorded->rows == 10);
    CHECK(lesson.torchFile == file);
    CHECK(lesson.torch.sample(test::recordedStep(4).torch.time).tip == test::recordedStep(4).torch.tip);
    Lesson other;
    other.key = "other";
    CHECK_THAT(sentenceOf([&] { takeTorch(other, file); }), containsText("is a recording of lesson 'bench'"));
    test::RecordingBytes strange;
    strange.head(test::recordedHead("bench")).step(test::recordedStep(1)).note(FrameKind::change, 1, "colour", "red");
    CHECK_THAT(sentenceOf([&] { takeTorch(lesson, written(strange.bytes())); }),
               containsText("a.meltrec: frame 3, after 0.01 s"));
    std::string damaged = test::recordingOf("bench", 10);
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    CHECK_THAT(sentenceOf([&] { takeTorch(lesson, written(damaged)); }), containsText("are whole; frame"));
}

TEST_CASE("checkpoints are found and read from their place", "[training]") {
    test::RecordingBytes recording;
    const std::string state("\1\2\3\0\5", 5);
    recording.head(test::recordedHead("classic")).step(test::recordedStep(1));
    recording.checkpoint({1, 0}, state).checkpoint({2, 0}, state); // step 2 is missing from the file
    const fs::path file = written(recording.bytes());
    const Recording read = readRecording(file);
    REQUIRE(read.checkpoints.size() == 1);
    CHECK(read.checkpoints[0].steps == 1);
    const std::vector<std::byte> bytes = readCheckpoint(file, read.checkpoints[0]);
    CHECK(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) == state);
    CHECK_THROWS_AS(readCheckpoint(file, {1, 10'000, 5}), InputError);
}
