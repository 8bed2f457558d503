// The record of an attempt: a torch path that reads back to its bits, events and changes between its rows, and
// behaviour on a full disk.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/record.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

TorchSample sampleAt(int i) {
    const float f = static_cast<float>(i);
    const glm::quat q = glm::normalize(glm::quat(1.0f, 0.1f * f, 0.2f, -0.3f));
    return {i / 60.0, {0.001f * f, 0.02f, -0.003f}, q, static_cast<float>(i % 2)};
}

MetalStatistics metalWith(size_t molten) {
    MetalStatistics metal;
    metal.molten = molten;
    metal.maxTemperature = 0.5;
    return metal;
}

AttemptHead headOf(const std::string& lesson) {
    AttemptHead head;
    head.lesson = lesson;
    head.attempt = 3;
    head.program = "1.0 abc";
    head.driver = "a driver\nwith two lines";
    head.values = {{"solidify_rate", "0.25"}, {"gravity", "0,-9.81,0"}};
    return head;
}

} // namespace

TEST_CASE("a record is a torch path with the metal's figures behind", "[training]") {
    const auto file = test::scratchFolder("record") / "record.csv";
    {
        Record record(file, headOf("classic"), {true, false});
        for (int i = 1; i <= 100; ++i) {
            record.add({sampleAt(i), {}, 1});
            // Figures arrive two steps later.
            if (i > 2) record.complete(metalWith(static_cast<size_t>(i - 2)));
        }
        CHECK(record.waiting() == 2);
        for (size_t i = 99; i <= 100; ++i)
            record.complete(metalWith(i));
        CHECK(record.rows() == 100);
    }
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.samples.size() == 100);
    REQUIRE(recording.furtherColumns.front() == "molten");
    CHECK(recording.furtherColumns.back() == "real_time");
    for (int i = 1; i <= 100; ++i) {
        const TorchSample& got = recording.samples[static_cast<size_t>(i - 1)];
        const TorchSample wanted = sampleAt(i);
        REQUIRE(got.time == wanted.time);
        REQUIRE(got.tip == wanted.tip);
        REQUIRE(got.orientation == wanted.orientation);
        REQUIRE(got.trigger == wanted.trigger);
        REQUIRE(recording.furtherCells[static_cast<size_t>(i - 1)].front() == std::to_string(i));
    }
}

TEST_CASE("what happened between the steps stands between the rows, and is read again", "[training]") {
    const auto file = test::scratchFolder("record-events") / "record.csv";
    {
        Record record(file, headOf("classic"), {true, false});
        record.add({sampleAt(1), {}, 1});
        record.event("zoom", "2");
        record.change("solidify_rate", "0.5");
        record.add({sampleAt(2), {}, 0.5});
        record.event("torch_lost", "");
        record.complete(metalWith(1));
        record.complete(metalWith(2));
        record.end("reset", 0xABCU);
    }
    const std::string text = readTextFile(file);
    INFO(text);
    CHECK(text.find("# driver a driver with two lines\n") != std::string::npos);
    const auto attempt = readRecordedAttempt(file);
    REQUIRE(attempt);
    CHECK(attempt->head.lesson == "classic");
    CHECK(attempt->rows == 2);
    CHECK(attempt->ended == "reset");
    CHECK(attempt->stateHash == "0000000000000abc");
    REQUIRE(attempt->realTime);
    CHECK(*attempt->realTime == Approx(2.0 / 3)); // one step at full and one at half speed
    REQUIRE(attempt->values.size() == 2);
    CHECK(attempt->values[1].value == "0,-9.81,0");
    REQUIRE(attempt->changes.size() == 1);
    CHECK(attempt->changes[0].key == "solidify_rate");
    CHECK(attempt->changes[0].value == "0.5");
    CHECK(attempt->changes[0].steps == 1);
    // Events are at their places: after the first row and before the second; the last one after both.
    const size_t second = text.find("\n" + formatNumber(sampleAt(2).time) + ",");
    REQUIRE(second != std::string::npos);
    CHECK(text.find("# event zoom 2\n") < second);
    CHECK(text.find("# event torch_lost\n") > second);
}

TEST_CASE("a recorded attempt is repeated only on its own lesson, and its faults have a line", "[training]") {
    const auto folder = test::scratchFolder("record-repeat");
    const auto write = [&](const std::string& body) {
        writeTextFileAtomically(folder / "r.csv", "# meltpool record 1\n# lesson bench\n" + body +
                                                      "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n0,0,0,0,0,0,0,1,0\n");
        return readRecordedAttempt(folder / "r.csv");
    };
    const auto sentenceOf = [](auto&& work) {
        try {
            work();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    Lesson lesson;
    lesson.key = "other";
    CHECK(sentenceOf([&] { repeatAttempt(lesson, *write("")); }).find("a record of lesson 'bench'") !=
          std::string::npos);
    lesson.key = "bench";
    CHECK(sentenceOf([&] { repeatAttempt(lesson, *write("# value solidify_rate 7\n")); }).find("r.csv:3: ") !=
          std::string::npos);
    CHECK(sentenceOf([&] { write("# value solidify_rate\n"); }).find("r.csv:3: has no value") != std::string::npos);
    CHECK(lesson.metal.solidifyRate == ClassicParameters{}.solidifyRate);
    repeatAttempt(lesson, *write("# value solidify_rate 0.5\n"));
    CHECK(lesson.metal.solidifyRate == 0.5f);
    CHECK(lesson.recorded->rows == 1);
    writeTextFileAtomically(folder / "plain.csv", "time_s\n");
    CHECK_FALSE(readRecordedAttempt(folder / "plain.csv"));
}

TEST_CASE("a record that goes on from an ended one has its values and rows, and counts their pace", "[training]") {
    const auto folder = test::scratchFolder("record-from");
    {
        Record record(folder / "first.csv", headOf("classic"), {true, false});
        for (int i = 1; i <= 4; ++i) {
            record.add({sampleAt(i), {}, 0.5});
            if (i == 2) record.event("zoom", "2");
            record.complete(metalWith(static_cast<size_t>(i)));
        }
        record.end("over", 0xABCU);
    }
    AttemptHead head = headOf("classic");
    head.attempt = 4;
    head.values = {{"solidify_rate", "9"}}; // of now, not of the start
    {
        Record record(folder / "second.csv", head, {true, false, folder / "first.csv"});
        CHECK(record.rows() == 4);
        record.event("redo", "2");
        record.add({sampleAt(3), {}, 1});
        record.complete(metalWith(3));
        record.end("over", 0xDEFU);
    }
    const auto first = readRecordedAttempt(folder / "first.csv"), second = readRecordedAttempt(folder / "second.csv");
    REQUIRE(first);
    REQUIRE(second);
    CHECK(second->head.attempt == 4);
    CHECK(second->redone == 1);
    CHECK(second->rows == 3);
    CHECK(second->stateHash == formatHexadecimal(std::uint64_t{0xDEF}));
    REQUIRE(second->values.size() == first->values.size());
    CHECK(second->values.front().value == "0.25");
    REQUIRE(second->realTime);
    CHECK(*second->realTime == Approx(5 / 9.0)); // four rows at half speed, one at full
    CHECK_THROWS_AS(Record(folder / "third.csv", head, {true, false, folder / "nowhere.csv"}), InputError);
}

TEST_CASE("a place that cannot be written is bad input, a full disk is a fault, and no file is replaced",
          "[training]") {
    CHECK_THROWS_AS(Record("/proc/nowhere/record.csv", {}, {true, true}), InputError);
    if (std::filesystem::exists("/dev/full")) CHECK_THROWS_AS(Record("/dev/full", {}, {true, true}), RuntimeFault);
    const auto file = test::scratchFolder("record-again") / "record.csv";
    { const Record first(file, headOf("a"), {true, false}); }
    CHECK_THROWS_AS(Record(file, headOf("b"), {true, false}), InputError);
    CHECK(readTextFile(file).find("# lesson a\n") != std::string::npos);
    { const Record third(file, headOf("c"), {true, true}); }
    CHECK(readTextFile(file).find("# lesson c\n") != std::string::npos);
}

TEST_CASE("the record of a process that melts a filler rod has the rod where one is held", "[training]") {
    const auto file = test::scratchFolder("record") / "rod.csv";
    {
        AttemptHead head = headOf("gtaw");
        head.rod = head.arc = true;
        Record record(file, head, {true, false});
        for (int i = 1; i <= 10; ++i) {
            TorchSample torch = sampleAt(i);
            if (i > 5) torch.rod = RodSample{{0.01F, 0.002F, 0.001F * static_cast<float>(i)}, torch.orientation, 2e-3F};
            record.add({torch, {}, 1});
            record.complete(metalWith(1));
        }
    }
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.samples.size() == 10);
    CHECK_FALSE(recording.samples[4].rod);
    REQUIRE(recording.samples[5].rod);
    CHECK(recording.samples[5].rod->tip == glm::vec3(0.01F, 0.002F, 0.006F));
    CHECK(recording.samples[5].rod->orientation == recording.samples[5].orientation);
    CHECK(recording.samples[5].rod->feed == 2e-3F);
}
