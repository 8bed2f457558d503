// Recordings of people's attempts: one for each attempt, replayed to its bits, within the size limit, and no silent
// loss.
#include "app/library/best_kept.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <algorithm>
#include <fstream>
#include <set>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;

Lesson smallLesson() {
    Lesson lesson = findLesson("classic", testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = 1728;
    lesson.metal.supportRadius = 0.12f;
    lesson.surface.cells = 32;
    return lesson;
}

/// Welds in a session that records its attempts, with a flame that wanders from frame to frame.
class Welder {
  public:
    explicit Welder(const fs::path& folder) : session(shaders(), smallLesson(), [] { return 0.0; }) {
        session.log().recordings().use(folder, "program", "driver");
    }

    void weld(int frames) {
        for (int i = 0; i < frames; ++i) {
            const float place = 0.021f - 1e-4f * static_cast<float>(++frame_ % 40);
            const TorchSource torch = [&](int, int) { return TorchSample{0, glm::vec3(place), {1, 0, 0, 0}, 1}; };
            session.advance(controls, 1.0 / 45, nullptr, torch);
            session.settle(controls);
            tellRecordings(session.log().recordings(), 0, messages);
        }
    }

    bool warned(const std::string& text) const {
        return std::any_of(messages.shown().begin(), messages.shown().end(),
                           [&](const Message& m) { return m.text.find(text) != std::string::npos; });
    }

    Controls controls;
    LessonSession session;
    Messages messages;

  private:
    int frame_ = 0;
};

std::string hashOfRepeat(const fs::path& file) {
    Lesson lesson = smallLesson();
    takeTorch(lesson, file);
    REQUIRE(lesson.recorded);
    Trainer trainer(shaders(), lesson);
    for (size_t i = 0; i < lesson.recorded->rows; ++i)
        trainer.advanceDemonstration(nullptr);
    return formatHexadecimal(trainer.result().stateHash);
}

/// Stores a recording of about `bytes` bytes with these dates in its head and the local one in its name.
fs::path keptAt(const fs::path& folder, const std::string& date, const std::string& utc, int attempt, size_t bytes) {
    const fs::path file = recordingName(folder, date, "classic", attempt);
    AttemptHead head = recordedHead("classic");
    head.date = date;
    head.utc = utc;
    RecordingBytes recording;
    recording.head(head).add(frameKind("FILL"), std::string(bytes, 'x')).step(recordedStep(1)).end(recordedEnd(1));
    std::ofstream(file, std::ios::binary) << recording.bytes();
    return file;
}

fs::path keptFile(const fs::path& folder, int day, size_t bytes) {
    return keptAt(folder, "2026-01-0" + std::to_string(day) + "T10:00:00+0000", "", day, bytes);
}

} // namespace

TEST_CASE("the recordings of two persons bear their names; an attempt of a guest has none", "[app]") {
    const fs::path folder = scratchFolder("recordings-persons") / "recordings";
    Welder welder(folder);
    AttemptLog& log = welder.session.log();
    const auto attemptOf = [&](const AttemptOwner& owner) {
        log.weldedBy(owner);
        welder.session.begin(welder.controls);
        welder.weld(5);
        welder.session.end("start menu");
    };
    attemptOf({AttemptOwner::Kind::person, {"00000000000000aa", "Anna", ""}});
    attemptOf({AttemptOwner::Kind::guest, {}});
    CHECK(welder.messages.shown().empty());
    attemptOf({AttemptOwner::Kind::person, {"00000000000000bb", "Bert", ""}});
    attemptOf({});
    log.recordings().finish();
    std::vector<std::string> faults;
    std::multiset<std::string> persons;
    for (const KeptAttempt& kept : keptRecordings(folder, &faults))
        persons.insert(kept.person + " " + kept.personId);
    CHECK(faults.empty());
    CHECK(persons == std::multiset<std::string>{" ", "Anna 00000000000000aa", "Bert 00000000000000bb"});
}

TEST_CASE("each attempt has a recording that replays to the same bits, whatever was changed while it ran", "[app]") {
    const fs::path folder = scratchFolder("recordings") / "made" / "by the program";
    const fs::path record = scratchFolder("recordings-record") / "weld.csv";
    std::vector<fs::path> files;
    {
        Welder welder(folder);
        welder.session.log().records().use(record, "program", "driver");
        welder.session.begin(welder.controls);
        files.push_back(welder.session.log().recordings().file());
        const auto& live = welder.session.sections().simulation.parameters;
        welder.weld(15);
        setParameter(live, "heat_temperature", "0.3", "test");
        welder.session.run().event("zoom", "2");
        welder.session.run().event("torch", "lost");
        welder.weld(15);
        welder.session.reset(welder.controls);
        files.push_back(welder.session.log().recordings().file());
        welder.weld(10);
        setParameter(live, "viscosity", "4", "test");
        welder.weld(10);
        welder.session.end("start menu");
        welder.session.log().recordings().finish();
        CHECK(welder.session.log().recordings().lost() == "");
        CHECK(welder.messages.shown().empty());
    }
    for (const fs::path& file : files) {
        const auto attempt = readRecordedAttempt(file);
        REQUIRE(attempt);
        CHECK(attempt->rows > 10);
        CHECK(attempt->changes.size() == 1);
        CHECK(attempt->head.lessonFile == "");
        CHECK(attempt->head.lessonHash == fileHash(smallLesson().file));
        CHECK(hashOfRepeat(file) == attempt->stateHash);
    }
    CHECK(readRecordedAttempt(files[0])->ended == "reset");
    CHECK(readRecordedAttempt(files[1])->ended == "start menu");
    // The attempt's record has equal values.
    const Recording recording = readRecording(files[0]);
    const TorchRecording rows = readTorchCsv(record);
    REQUIRE(rows.samples.size() == recording.steps.size());
    for (size_t i = 0; i < rows.samples.size(); ++i) {
        CHECK(rows.samples[i].time == recording.steps[i].torch.time);
        CHECK(rows.samples[i].tip == recording.steps[i].torch.tip);
    }
    CHECK(readRecordedAttempt(record)->stateHash == readRecordedAttempt(files[0])->stateHash);
    CHECK(readRecordedAttempt(record)->events.size() == readRecordedAttempt(files[0])->events.size());
    const auto kept = keptRecordings(folder);
    REQUIRE(kept.size() == 2);
    CHECK(kept[0].lesson == "classic");
    CHECK(kept[0].ended == "start menu"); // newest first
    CHECK(kept[0].seconds == Approx(readRecording(files[1]).seconds()));
    CHECK(kept[0].when.size() == 16);
    WARN("a recording takes " << static_cast<double>(kept[1].bytes) / kept[1].seconds * 60 / 1e6 << " MB a minute at "
                              << static_cast<double>(recording.steps.size()) / recording.seconds()
                              << " steps a second");
}

TEST_CASE("the desk's camera stands in the recording as the person's head", "[app]") {
    const fs::path folder = scratchFolder("recordings-person");
    Welder welder(folder);
    welder.session.begin(welder.controls);
    welder.weld(3);
    const View view = welder.controls.view(1);
    welder.session.log().recordings().person(deskPerson(view, glm::mat3(1.0f), 2.0f, welder.session.run().steps()));
    welder.session.end("start menu");
    welder.session.log().recordings().finish();
    const Recording recording = readRecording(welder.session.log().recordings().file());
    REQUIRE(recording.people.size() == 1);
    REQUIRE(recording.people[0].head);
    CHECK(recording.people[0].steps == recording.steps.size());
    const RecordingPose head = *recording.people[0].head;
    CHECK(glm::distance(head.position, view.eye * 2.0f) < 1e-5f);
    // The eye looks where the head looks.
    const glm::vec3 ahead = view.eye + head.orientation * glm::vec3(0, 0, -1);
    const glm::vec4 inEye = view.worldToEye * glm::vec4(ahead, 1);
    CHECK(glm::distance(glm::vec3(inEye), glm::vec3(0, 0, -1)) < 1e-4f);
}

TEST_CASE("an attempt that cannot be recorded is told, goes on, and is told in the end", "[app]") {
    Welder welder("/proc/nowhere/recordings");
    welder.session.begin(welder.controls);
    welder.weld(5);
    CHECK(welder.session.run().steps() > 0);
    CHECK(welder.warned("This attempt is not recorded: "));
    CHECK(welder.warned("/proc/nowhere/recordings"));
    welder.session.end("start menu");
    welder.session.log().recordings().finish();
    CHECK_THAT(welder.session.log().recordings().lost(), containsText("This attempt is not recorded"));
}

TEST_CASE("a folder that is removed under an attempt is told at its end at the latest", "[app]") {
    const fs::path folder = scratchFolder("recordings-gone") / "recordings";
    Welder welder(folder);
    welder.session.begin(welder.controls);
    welder.weld(5);
    fs::remove_all(folder);
    welder.session.reset(welder.controls);
    welder.session.log().recordings().finish();
    welder.weld(5);
    CHECK(welder.session.run().steps() > 0); // the lesson continues
    CHECK(welder.warned("the recording is no longer there"));
    CHECK_THAT(welder.session.log().recordings().lost(), containsText("is no longer there"));
}

TEST_CASE("no recordings are made where nobody wants them, nor of demonstrations", "[app]") {
    const fs::path folder = scratchFolder("recordings-unwanted");
    Welder welder(folder);
    welder.session.log().recordings().parameters.keep = false;
    welder.session.begin(welder.controls);
    welder.weld(3);
    welder.session.end("start menu");
    welder.session.log().recordings().parameters.keep = true;
    welder.session.demonstrate(welder.controls);
    welder.weld(3);
    welder.session.end("start menu");
    CHECK(fs::is_empty(folder));
    CHECK(welder.messages.shown().empty());
}

TEST_CASE("recordings keep within their limit: the oldest are removed and named, others are left alone", "[app]") {
    const fs::path folder = scratchFolder("recordings-limit");
    std::vector<fs::path> files;
    for (int day = 1; day <= 4; ++day)
        files.push_back(keptFile(folder, day, 100'000));
    const fs::path own = folder / "my best weld.meltrec";
    fs::copy_file(files[0], own);
    const std::uint64_t bytes = recordedBytes(folder);
    CHECK(bytes > 400'000);
    CHECK(bytes < 410'000);
    CHECK(keepWithinLimit(folder, bytes) == "");
    CHECK_THAT(nearLimit(folder, bytes), containsText("first 2026-01-01_10-00-00_classic_1."));
    CHECK(nearLimit(folder, 2 * bytes) == "");
    const std::string told = keepWithinLimit(folder, 250'000);
    CHECK_THAT(told, containsText("2 oldest, 2026-01-01_10-00-00_classic_1 to 2026-01-02_10-00-00_classic_2"));
    CHECK_FALSE(fs::exists(files[0]));
    CHECK_FALSE(fs::exists(files[1]));
    CHECK(fs::exists(files[2]));
    CHECK(fs::exists(own));
    CHECK_THAT(readTextFile(folder / kRemovedList), containsText(files[1].filename().string()));
    // The list begins with the newest; the copy is of the first day.
    const auto kept = keptRecordings(folder);
    REQUIRE(kept.size() == 3);
    CHECK(kept[0].file == files[3]);
    CHECK(kept[2].file == own);
    CHECK(kept[0].when == "2026-01-04 10:00");
    CHECK(kept[0].score == 84);
    CHECK(kept[0].verdict == "accepted");
    CHECK(keptRecordings(folder / "nowhere").empty());
    CHECK(bestKept(folder, kept[0].lesson) == files[3]); // newest of equal ones
    CHECK(bestKept(folder, "no-such-lesson").empty());
    CHECK(bestKept(folder, kept[0].lesson, "0123456789abcdef").empty()); // of another person
}

TEST_CASE("the order of attempts is that of their moments, whatever clock on the wall has named them", "[app]") {
    const fs::path folder = scratchFolder("recordings-order");
    const auto keep = [&](const std::string& date, const std::string& utc) {
        return keptAt(folder, date, utc, 1, 100'000);
    };
    // Journey home from the east, then the end of summer time; the first two are old recordings without UTC.
    const std::vector<fs::path> files{
        keep("2026-10-24T22:00:00+0900", ""),
        keep("2026-10-25T02:30:00+0200", ""),
        keep("2026-10-25T02:10:00+0100", "2026-10-25T01:10:00.000Z"),
        keep("2026-10-24T18:10:05-0700", "2026-10-25T01:10:05.250Z"),
        keep("2027-06-01T10:00:00+0000", "2026-10-25T01:10:05.750Z"),
    };
    std::vector<fs::path> newestFirst;
    for (const KeptAttempt& kept : keptRecordings(folder))
        newestFirst.push_back(kept.file);
    CHECK(newestFirst == std::vector<fs::path>(files.rbegin(), files.rend()));
    // An old recording without a time zone counts by its file time, which is now.
    const fs::path undated = keep("2020-01-01T10:00:00", "");
    CHECK(keptRecordings(folder).front().file == undated);
    CHECK_THAT(nearLimit(folder, 600'000), containsText("first 2026-10-24_22-00-00_classic_1."));
    CHECK_THAT(keepWithinLimit(folder, 350'000), containsText("3 oldest, 2026-10-24_22-00-00_classic_1 to 2026-10-25_0"
                                                              "2-10-00_classic_1"));
    CHECK(fs::exists(files[3]));
    CHECK(fs::exists(files[4]));
    CHECK(fs::exists(undated));
}

TEST_CASE("an attempt of this run of the program is never removed, whatever other recordings are called", "[app]") {
    const fs::path folder = scratchFolder("recordings-own");
    Welder welder(folder);
    welder.session.begin(welder.controls);
    welder.weld(2);
    const fs::path made = welder.session.log().recordings().file();
    // A machine whose clock is ahead gives later names and later times.
    for (const char* date : {"2099-01-01T10:00:00+0000", "2099-01-02T10:00:00+0000"})
        keptAt(folder, date, "", 1, 30'000'000);
    welder.session.log().recordings().parameters.limitMb = 50;
    welder.session.begin(welder.controls);
    welder.weld(1);
    CHECK(fs::exists(made));
    CHECK(fs::exists(welder.session.log().recordings().file()));
    CHECK(welder.warned("the oldest, 2099-01-01_10-00-00_classic_1, was removed"));
    const std::vector<fs::path> own{made};
    CHECK(keepWithinLimit(folder, 1, own).find("oldest") != std::string::npos);
    CHECK(fs::exists(made));
    CHECK(keepWithinLimit(folder, 1, own).empty());
    CHECK_THAT(nearLimit(folder, 1, own), containsText("All are from this session"));
}

TEST_CASE("a start near the limit is told before anything is removed, and a removal when it happens", "[app]") {
    const fs::path folder = scratchFolder("recordings-near");
    for (int day = 1; day <= 2; ++day)
        keptFile(folder, day, 24'000'000);
    Welder welder(folder);
    welder.session.log().recordings().parameters.limitMb = 50;
    welder.session.begin(welder.controls);
    welder.weld(1);
    CHECK(welder.warned("The recordings take 48 of 50 MB."));
    keptFile(folder, 3, 24'000'000);
    welder.session.begin(welder.controls);
    welder.weld(1);
    CHECK(welder.warned("the oldest, 2026-01-01_10-00-00_classic_1, was removed"));
}

TEST_CASE("the command lists recordings, makes a table of one and tells what is whole", "[app]") {
    const fs::path folder = scratchFolder("recordings-command");
    const fs::path file = keptFile(folder, 5, 10), table = folder / "out.csv", damaged = folder / "damaged.meltrec";
    std::string bytes = readTextFile(file);
    bytes[bytes.size() - 300] = static_cast<char>(bytes[bytes.size() - 300] ^ 4);
    std::ofstream(damaged, std::ios::binary) << bytes;
    std::ofstream(folder / "none.meltrec") << "not a recording";
    const Outcome list = runMeltpool("recordings --folder '" + folder.string() + "'");
    INFO(list.output << list.errors);
    CHECK(list.code == 0);
    CHECK_THAT(list.output, containsText("2026-01-05 10:00  classic"));
    CHECK_THAT(list.output, containsText("84 accepted"));
    CHECK_THAT(list.output, containsText("none.meltrec"));
    const Outcome whole = runMeltpool("recordings --check '" + file.string() + "'");
    CHECK(whole.code == 0);
    CHECK_THAT(whole.output, containsText("are whole; the attempt ended: back to the lesson page"));
    const Outcome broken = runMeltpool("recordings --check '" + damaged.string() + "'");
    CHECK(broken.code == 1);
    CHECK_THAT(broken.output, containsText("is damaged"));
    const Outcome csv = runMeltpool("recordings --csv '" + file.string() + "' '" + table.string() + "'");
    CHECK(csv.code == 0);
    CHECK(readTorchCsv(table).samples.size() == 1);
    const Outcome empty = runMeltpool("recordings", "XDG_DATA_HOME='" + (folder / "none").string() + "'");
    CHECK(empty.code == 0);
    CHECK_THAT(empty.output, containsText("There are no recordings in " + (folder / "none").string()));
    CHECK(runMeltpool("recordings --folder /nowhere/at/all").code == 2);
    CHECK(runMeltpool("recordings --check '" + (folder / "none.meltrec").string() + "'").code == 2);
}
