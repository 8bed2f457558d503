// Recordings of attempts that went back: read as their final course, with every checkpoint that is still valid.
#include "core/base/error.hpp"
#include "core/training/attempt/checkpoint_schedule.hpp"
#include "core/training/attempt/recording_csv.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <algorithm>
#include <fstream>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& bytes, const std::string& name = "a.meltrec") {
    static const fs::path folder = test::scratchFolder("recording-redo");
    std::ofstream(folder / name, std::ios::binary | std::ios::trunc) << bytes;
    return folder / name;
}

/// Returns a step of the second branch, with another torch position.
RecordingStep otherStep(int i) {
    RecordingStep step = test::recordedStep(i);
    step.torch.tip.z = 0.05f;
    return step;
}

/// Returns ten steps, a return to the fifth, and steps to the eighth.
test::RecordingBytes wentBack() {
    test::RecordingBytes recording;
    recording.head(test::recordedHead("classic")).note(FrameKind::event, 0, "zoom", "2");
    for (int i = 1; i <= 10; ++i) {
        recording.step(test::recordedStep(i));
        if (i == 3) recording.note(FrameKind::change, 3, "solidify_rate", "0.5");
        if (i == 5) recording.note(FrameKind::event, 5, "samples", "dropped");
        if (i == 6) recording.note(FrameKind::event, 6, "cues", "all").checkpoint({4, 0}, "four");
        if (i == 8) recording.note(FrameKind::change, 8, "solidify_rate", "0.7").checkpoint({8, 0}, "eight");
        if (i != 9) continue;
        recording.note(FrameKind::event, 9, "torch", "lost").note(FrameKind::event, 9, "arc_out", "too_long");
        RecordingPerson person;
        person.steps = 9;
        const auto content = personContent(person);
        recording.add(FrameKind::person, {content.data(), content.size()});
    }
    recording.note(FrameKind::event, 5, "redo", "5").note(FrameKind::change, 5, "solidify_rate", "0.5");
    recording.checkpoint({7, 0}, "late"); // made before the return, written after it
    for (int i = 6; i <= 8; ++i)
        recording.step(otherStep(i));
    return recording.checkpoint({7, 1}, "seven").checkpoint({5, 0}, "five");
}

std::string textOf(const Recording& recording, const RecordingCheckpoint& checkpoint) {
    const std::vector<std::byte> bytes = readCheckpoint(recording.file, checkpoint);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string refusal(const test::RecordingBytes& recording) {
    try {
        readRecording(written(recording.bytes()));
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

} // namespace

TEST_CASE("of an attempt that went back its recording is read as what came of it", "[training]") {
    RecordingEnd end = test::recordedEnd(8);
    end.redone = 1;
    const Recording recording = readRecording(written(wentBack().end(end).bytes()));
    CHECK_FALSE(recording.fault);
    CHECK(recording.redone == 1);
    REQUIRE(recording.end);
    CHECK(recording.end->redone == 1);
    REQUIRE(recording.steps.size() == 8);
    CHECK(stepContent(recording.steps[4]) == stepContent(test::recordedStep(5)));
    CHECK(stepContent(recording.steps[5]) == stepContent(otherStep(6)));
    CHECK(recording.people.empty());
    REQUIRE(recording.changes.size() == 2);
    CHECK(recording.changes[0].steps == 3);
    CHECK(recording.changes[1].steps == 5);
    REQUIRE(recording.events.size() == 3); // zoom, cues, redo
    CHECK(recording.events[1].name == "cues");
    CHECK(recording.events[1].steps == 5); // cues remain visible
    REQUIRE(recording.checkpoints.size() == 3);
    CHECK(textOf(recording, recording.checkpoints[0]) == "four");
    CHECK(textOf(recording, recording.checkpoints[1]) == "five");
    CHECK(textOf(recording, recording.checkpoints[2]) == "seven");
    const auto attempt = readRecordedAttempt(recording.file);
    REQUIRE(attempt);
    CHECK(attempt->redone == 1);
    CHECK(attempt->rows == 8);
    CHECK(attempt->events.empty());
    CHECK(std::count_if(attempt->notes.begin(), attempt->notes.end(),
                        [](const RecordedEvent& note) { return note.name == "redo"; }) == 1);
    CHECK(torchPathOf(recording).duration() == test::recordedStep(8).torch.time);
    // The table is an equal record.
    const auto table = readRecordedAttempt(written(recordingCsv(recording), "table.csv"));
    REQUIRE(table);
    CHECK(table->redone == 1);
    CHECK(table->rows == 8);
    REQUIRE(table->changes.size() == 2);
    CHECK(table->changes[1].steps == 5);
    CHECK(table->changes[1].value == "0.5");
}

TEST_CASE("a list tells that an attempt went back, also where its program was killed", "[training]") {
    RecordingEnd end = test::recordedEnd(8);
    end.redone = 1;
    const RecordingSummary whole = readRecordingSummary(written(wentBack().end(end).bytes()));
    CHECK(whole.redone == 1);
    const RecordingSummary killed = readRecordingSummary(written(wentBack().bytes()));
    CHECK_FALSE(killed.end);
    CHECK(killed.redone == 1);
    CHECK(killed.seconds == Approx(test::recordedStep(8).torch.time));
    CHECK(readRecordingSummary(written(test::recordingOf("classic", 4))).redone == 0);
}

TEST_CASE("an attempt may go back behind the place to which it went back before", "[training]") {
    test::RecordingBytes recording = wentBack();
    recording.note(FrameKind::event, 2, "redo", "2").checkpoint({5, 1}, "of the second end").step(otherStep(3));
    const Recording read = readRecording(written(recording.bytes()));
    CHECK(read.redone == 2);
    CHECK(read.steps.size() == 3);
    CHECK(read.changes.empty());
    CHECK(read.checkpoints.empty());
    const auto table = readRecordedAttempt(written(recordingCsv(read), "table.csv"));
    REQUIRE(table);
    CHECK(table->redone == 2);
    CHECK(table->rows == 3);
}

TEST_CASE("a checkpoint that stands before the way back to which it belongs is read behind it", "[training]") {
    test::RecordingBytes recording;
    recording.head(test::recordedHead("classic"));
    for (int i = 1; i <= 10; ++i)
        recording.step(test::recordedStep(i));
    recording.checkpoint({6, 1}, "six").note(FrameKind::event, 5, "redo", "5").step(otherStep(6));
    const Recording read = readRecording(written(recording.bytes()));
    REQUIRE(read.checkpoints.size() == 1);
    CHECK(textOf(read, read.checkpoints[0]) == "six");
}

TEST_CASE("a way back that no attempt has gone is refused", "[training]") {
    CHECK_THAT(refusal(wentBack().note(FrameKind::event, 9, "redo", "9")), containsText("goes back to step 9"));
    CHECK_THAT(refusal(wentBack().note(FrameKind::event, 3, "redo", "4")), containsText("goes back to step 4"));
    CHECK_THAT(refusal(wentBack().note(FrameKind::event, 3, "redo", "")), containsText("expected the step"));
    CHECK_THAT(refusal(wentBack().checkpoint({3, 2}, "x")), containsText("expected at most 1"));
}

TEST_CASE("a recording takes the moments that come, as far as 60 megabytes a minute allow", "[training]") {
    CheckpointSchedule small, large;
    int smallTaken = 0, largeTaken = 0;
    constexpr size_t kSmall = 20'000, kLarge = 9'700'000;
    for (int second = 0; second <= 60; ++second) {
        smallTaken += small.take(second + 0.02, kSmall) ? 1 : 0;
        largeTaken += large.take(second + 0.02, kLarge) ? 1 : 0;
    }
    CHECK(smallTaken == 61);
    CHECK(largeTaken == 7); // the first, then one each 10 s, the second one sooner
    // After a return to 30 s later checkpoints are abandoned, and the next one is taken where there is room.
    CHECK(small.take(31.02, kSmall));
    CHECK_FALSE(small.take(31.22, kSmall)); // closer than any two checkpoints
    CHECK(small.take(31.42, kSmall));
    CHECK_FALSE(large.take(31.02, kLarge));
}
