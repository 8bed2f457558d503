// Writer of a recording during an attempt: all frames in order, messages about full disks and removed folders, and a
// whole file.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/content.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/attempt/recording_writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/little_time.hpp"
#include "tests/support/recording_bytes.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <new>
#include <random>
#include <thread>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

fs::path newFile() {
    return test::scratchFolder("recording-writer") / "a.meltrec";
}

void addSteps(RecordingWriter& writer, int from, int to) {
    for (int i = from; i <= to; ++i)
        writer.step(test::recordedStep(i));
}

/// Writes the complete attempt of the other tests.
void writeAttempt(RecordingWriter& writer, int steps) {
    addSteps(writer, 1, steps);
    writer.end(test::recordedEnd(steps));
    writer.wait();
}

/// Returns how `work` ends in its own process whose files grow to `bytes` bytes at most.
int endWithin(std::uint64_t bytes, const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
        _exit(work());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST_CASE("frames leave the ring as they came, around its end too", "[training]") {
    FrameRing ring(64);
    std::uint32_t kind = 0;
    std::string content;
    CHECK_FALSE(ring.take(kind, content));
    for (std::uint32_t i = 0; i < 100; ++i) {
        const std::string text(i % 20, static_cast<char>('a' + i % 26));
        REQUIRE(ring.put(i, {text, "and", ""}));
        REQUIRE(ring.put(i + 1000, {}));
        REQUIRE(ring.take(kind, content));
        CHECK(kind == i);
        CHECK(content == text + "and");
        REQUIRE(ring.take(kind, content));
        CHECK(kind == i + 1000);
        CHECK(content.empty());
    }
    CHECK_FALSE(ring.put(1, {std::string(57, 'x')})); // one byte too many with its head
    CHECK(ring.put(1, {std::string(56, 'x')}));
    CHECK_FALSE(ring.put(2, {}));
}

TEST_CASE("two threads share a ring", "[training]") {
    FrameRing ring(200);
    constexpr std::uint32_t kFrames = 20'000;
    std::thread taker([&] {
        std::uint32_t kind = 0;
        std::string content;
        for (std::uint32_t next = 0; next < kFrames;) {
            if (!ring.take(kind, content)) {
                std::this_thread::yield();
                continue;
            }
            if (kind != next || content != std::to_string(next)) FAIL_CHECK("frame " << next << " is another one");
            ++next;
        }
    });
    for (std::uint32_t i = 0; i < kFrames; ++i)
        while (!ring.put(i, {std::to_string(i)}))
            std::this_thread::yield();
    taker.join();
}

TEST_CASE("what is written while an attempt runs is what was brought", "[training]") {
    const fs::path file = newFile();
    RecordingWriter writer(file, test::recordedHead("classic"));
    CHECK_THROWS_AS(RecordingWriter(file, test::recordedHead("classic")), InputError); // no file is replaced
    RecordingPerson person;
    person.head = RecordingPose{{0, 0.4f, 0.5f}, {1, 0, 0, 0}};
    person.zoom = 2;
    writer.person(person);
    writer.person(person); // an equal pose again
    writer.event(0, "zoom", "2");
    addSteps(writer, 1, 200);
    writer.change(200, "voltage", "22");
    writer.checkpoint(200, std::vector<std::byte>(5000, std::byte{7}));
    person.steps = 200;
    person.left = RecordingPose{{-0.1f, 0, 0}, {0, 1, 0, 0}};
    writer.person(person);
    addSteps(writer, 201, 300);
    writer.judged(83.5, "accepted");
    CHECK_FALSE(writer.finished());
    writer.end(test::recordedEnd(300));
    writer.event(300, "late", "nobody reads this");
    writer.wait();
    CHECK(writer.finished());
    CHECK(writer.fault() == "");
    CHECK(writer.bytes() == fs::file_size(file));
    const Recording recording = readRecording(file);
    CHECK_FALSE(recording.fault);
    REQUIRE(recording.steps.size() == 300);
    for (int i = 1; i <= 300; ++i)
        if (stepContent(recording.steps[static_cast<size_t>(i - 1)]) != stepContent(test::recordedStep(i)))
            FAIL_CHECK("step " << i << " is another one");
    REQUIRE(recording.people.size() == 2);
    CHECK(recording.people[0].head == person.head);
    CHECK_FALSE(recording.people[0].left);
    CHECK(recording.people[1].left == person.left);
    CHECK(recording.people[1].zoom == 2);
    REQUIRE(recording.changes.size() == 1);
    CHECK(recording.changes[0].value == "22");
    CHECK(recording.events.size() == 1);
    REQUIRE(recording.checkpoints.size() == 1);
    CHECK(readCheckpoint(file, recording.checkpoints[0]) == std::vector<std::byte>(5000, std::byte{7}));
    REQUIRE(recording.end);
    CHECK(recording.end->score == 83.5);
    CHECK(recording.end->verdict == "accepted");
}

TEST_CASE("an attempt that nobody ended has no end, and all of its steps", "[training]") {
    const fs::path file = newFile();
    {
        RecordingWriter writer(file, test::recordedHead("classic"));
        addSteps(writer, 1, 50);
    }
    const Recording recording = readRecording(file);
    CHECK_FALSE(recording.fault);
    CHECK(recording.steps.size() == 50);
    CHECK_FALSE(recording.end);
}

TEST_CASE("a disk that fills at any moment is told, and what was written is whole", "[training]") {
    constexpr int kSteps = 300;
    const fs::path file = newFile();
    {
        RecordingWriter writer(file, test::recordedHead("classic"));
        writeAttempt(writer, kSteps);
        REQUIRE(writer.fault().empty());
    }
    const std::uint64_t whole = fs::file_size(file);
    for (const std::uint64_t limit : {whole - 1, whole - 300, whole / 2, whole / 2 + 7, std::uint64_t{3000}}) {
        INFO(limit << " of " << whole << " bytes");
        fs::remove(file);
        const int code = endWithin(limit, [&] {
            RecordingWriter writer(file, test::recordedHead("classic"));
            writeAttempt(writer, kSteps);
            return writer.fault().find("cannot be continued") == std::string::npos ? 43 : 42;
        });
        CHECK(code == 42);
        const Recording recording = readRecording(file);
        CHECK_FALSE(recording.fault); // cut at a frame's end
        CHECK_FALSE(recording.end);
        CHECK(fs::file_size(file) <= limit);
        CHECK(fs::file_size(file) + kFrameBytes + kStepBytes + 300 > limit);
        // At the very last flush only the end is lost.
        if (limit == whole - 1) CHECK(recording.steps.size() == kSteps);
    }
    fs::remove(file);
    const int code = endWithin(100, [&] { // too small for the head
        try {
            RecordingWriter writer(file, test::recordedHead("classic"));
        } catch (const RuntimeFault&) {
            return fs::exists(file) ? 44 : 42;
        }
        return 43;
    });
    CHECK(code == 42);
}

namespace {

/// State that a welding process reports in memory that outlives it.
struct Told {
    std::atomic<bool> begun{false};
    std::atomic<double> seconds{0}; ///< time of the last step passed to the writer
};

/// Passes steps to the writer by the clock until the process is killed.
[[noreturn]] void weldUntilKilled(const fs::path& file, Told& told) {
    using Clock = std::chrono::steady_clock;
    RecordingWriter writer(file, test::recordedHead("classic"));
    const auto begin = Clock::now();
    told.begun = true;
    for (std::uint64_t steps = 1;; ++steps) {
        RecordingStep step = test::recordedStep(1);
        step.steps = steps;
        step.torch.time = std::chrono::duration<double>(Clock::now() - begin).count();
        writer.step(step);
        told.seconds = step.torch.time;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

/// Returns the seconds lost when a welding process is killed after `wait`. The file that is left opens and is sound.
double lostToKill(const fs::path& file, std::chrono::milliseconds wait, Told& told) {
    fs::remove(file);
    told.begun = false;
    told.seconds = 0;
    const pid_t child = fork();
    if (child == 0) weldUntilKilled(file, told);
    while (!told.begun)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(wait);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const Recording recording = readRecording(file);
    INFO("killed after " << wait.count() << " ms: " << recording.stateSentence());
    CHECK_FALSE(recording.damaged());
    CHECK(recording.head.lesson == "classic");
    return told.seconds - recording.seconds();
}

void killWriters(int count, unsigned seed) {
    const fs::path file = newFile();
    void* shared = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    REQUIRE(shared != MAP_FAILED);
    Told* told = new (shared) Told;
    std::mt19937 random(seed);
    std::vector<double> lost;
    for (int i = 0; i < count; ++i)
        lost.push_back(lostToKill(file, std::chrono::milliseconds(random() % 1500), *told));
    munmap(shared, sizeof(Told));
    std::sort(lost.begin(), lost.end());
    WARN("killed " << count << " times: " << lost[lost.size() / 2] << " s lost as the median, " << lost.back()
                   << " s at most");
    CHECK(lost[lost.size() / 2] <= 0.2);
    // A machine without time for the writing thread may lose more, an idle one may not.
    CHECK((lost.back() <= 0.2 || test::shareOfProcessor() < 0.9));
}

} // namespace

TEST_CASE("a program that is killed loses no more than 0.2 s of its recording", "[training]") {
    killWriters(8, 5);
}

TEST_CASE("a program that is killed at fifty moments loses no more than 0.2 s each time", "[training][long]") {
    killWriters(50, 6);
}

TEST_CASE("a recording whose folder is removed is told", "[training]") {
    const fs::path folder = test::scratchFolder("recording-removed") / "recordings";
    fs::create_directories(folder);
    RecordingWriter writer(folder / "a.meltrec", test::recordedHead("classic"));
    addSteps(writer, 1, 10);
    fs::remove_all(folder);
    addSteps(writer, 11, 20);
    writer.end(test::recordedEnd(20));
    writer.wait();
    CHECK_THAT(writer.fault(), containsText("the recording is no longer there"));
    CHECK_THROWS_AS(RecordingWriter(folder / "b.meltrec", test::recordedHead("classic")), InputError);
}

TEST_CASE("a checkpoint stands behind the way back that led to it and before the end", "[training]") {
    const fs::path file = newFile();
    RecordingWriter writer(file, test::recordedHead("classic"));
    addSteps(writer, 1, 10);
    writer.event(5, "redo", "5");
    addSteps(writer, 6, 8);
    writer.checkpoint(7, std::vector<std::byte>(3));
    writer.end(test::recordedEnd(8));
    writer.wait();
    const Recording recording = readRecording(file);
    CHECK(recording.redone == 1);
    CHECK(recording.checkpoints.size() == 1);
    CHECK(readRecordingSummary(file).end.has_value());
}
