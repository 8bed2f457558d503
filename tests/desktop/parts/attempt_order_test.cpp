// Tests the list of saved attempts without a window: order, filter, names, deletion and table.
#include "app/library/attempt_title.hpp"
#include "app/library/deleted_attempts.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/library/recordings_limit.hpp"
#include "app/library/replay_list.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

namespace meltpool {

namespace {

namespace fs = std::filesystem;
using Indices = std::vector<size_t>;

ReplayEntry entryWith(const std::string& lesson, std::optional<int> score, bool test, double seconds) {
    ReplayEntry entry{lesson + ".meltrec", lesson, {}};
    entry.lessonTitle = lesson;
    entry.when = "2026-11-2" + std::to_string(static_cast<int>(seconds) % 10) + " 08:10";
    entry.score = score;
    entry.test = test;
    entry.seconds = seconds;
    return entry;
}

std::vector<ReplayEntry> fewEntries() {
    std::vector<ReplayEntry> entries{entryWith("Tee fillet", 80, false, 14), entryWith("bead", std::nullopt, false, 3),
                                     entryWith("Bead", 95, true, 22), entryWith("Tee fillet", 40, true, 8)};
    entries[2].title = "My best one";
    return entries;
}

Indices ordered(AttemptColumn column, bool ascending, const AttemptFilter& filter = {}) {
    return orderedAttempts(fewEntries(), filter, {column, ascending});
}

/// Stores a recording of this day, a test or not.
fs::path keptOn(const fs::path& folder, int day, bool test) {
    AttemptHead head = test::recordedHead("gmaw-bead");
    head.utc = "2026-11-0" + std::to_string(day) + "T10:00:00.000Z";
    head.date = "2026-11-0" + std::to_string(day) + "T10:00:00+0000";
    test::RecordingBytes bytes;
    bytes.head(head).note(FrameKind::event, 0, "zoom", "1");
    if (test) bytes.note(FrameKind::event, 0, "for_score", "yes");
    bytes.step(test::recordedStep(1));
    bytes.note(FrameKind::event, 1, "for_score", "yes"); // behind the first step it says nothing
    fs::create_directories(folder);
    const fs::path file = recordingName(folder, head.date, "gmaw-bead", day);
    writeFile(file, bytes.end(test::recordedEnd(1)).bytes());
    return file;
}

const auto kTitles = [](const std::string& key) { return "Title of " + key; };

/// List of a folder with three attempts, of which the second is a test.
struct ListOfThree {
    explicit ListOfThree(const std::string& name) : folder(test::scratchFolder(name)) {
        for (int day = 1; day <= 3; ++day)
            files.push_back(keptOn(folder, day, day == 2));
        list.show(folder);
        list.rows(kTitles);
    }
    fs::path folder;
    std::vector<fs::path> files;
    ReplayList list;
};

} // namespace

TEST_CASE("attempts are sorted by each column both ways; those without a score come last, equal ones newest first") {
    CHECK(ordered(AttemptColumn::date, false) == Indices{0, 1, 2, 3});
    CHECK(ordered(AttemptColumn::date, true) == Indices{3, 2, 1, 0});
    CHECK(ordered(AttemptColumn::lesson, true) == Indices{1, 2, 0, 3});
    CHECK(ordered(AttemptColumn::lesson, false) == Indices{0, 3, 1, 2});
    CHECK(ordered(AttemptColumn::score, false) == Indices{2, 0, 3, 1});
    CHECK(ordered(AttemptColumn::score, true) == Indices{3, 0, 2, 1});
    CHECK(ordered(AttemptColumn::test, false) == Indices{2, 3, 0, 1});
    CHECK(ordered(AttemptColumn::test, true) == Indices{0, 1, 2, 3});
    CHECK(ordered(AttemptColumn::length, false) == Indices{2, 0, 3, 1});
    CHECK(ordered(AttemptColumn::title, true) == Indices{2, 0, 1, 3});
}

TEST_CASE("a pressed heading begins with its usual direction, and turns it round when pressed again") {
    const AttemptOrder byDate;
    CHECK(pressedColumn(byDate, AttemptColumn::date) == AttemptOrder{AttemptColumn::date, true});
    CHECK(pressedColumn(byDate, AttemptColumn::lesson) == AttemptOrder{AttemptColumn::lesson, true});
    const AttemptOrder byScore = pressedColumn(byDate, AttemptColumn::score);
    CHECK(byScore == AttemptOrder{AttemptColumn::score, false});
    CHECK(pressedColumn(byScore, AttemptColumn::score).ascending);
}

TEST_CASE("a filter lets attempts through that have all its words, its lesson, and are tests if asked") {
    CHECK(ordered(AttemptColumn::date, false, {"TEE", "", false}) == Indices{0, 3});
    CHECK(ordered(AttemptColumn::date, false, {" best  bead ", "", false}) == Indices{2});
    CHECK(ordered(AttemptColumn::date, false, {"11-24", "", false}) == Indices{0});
    CHECK(ordered(AttemptColumn::date, false, {"", "Tee fillet", true}) == Indices{3});
    CHECK(ordered(AttemptColumn::date, false, {"", "", true}) == Indices{2, 3});
    CHECK(ordered(AttemptColumn::date, false, {"pipe", "", false}).empty());
}

TEST_CASE("the list marks tests, and says of each attempt what its judgement was") {
    const ListOfThree three("attempts-tests");
    REQUIRE(three.list.entries().size() == 3);
    CHECK_FALSE(three.list.entries()[0].test);
    CHECK(three.list.entries()[1].test);
    CHECK(readKeptAttempt(three.files[1]).test);
    CHECK_FALSE(readKeptAttempt(three.files[2]).test);
    CHECK_THAT(three.list.entries()[1].detail, test::containsText(" test"));
    ReplayEntry entry = three.list.entries()[0];
    CHECK(scoreText(entry) == "84, accepted");
    entry.practice = true;
    CHECK(scoreText(entry) == "84, practice"); // its score does not count
    CHECK(scoreText(ReplayEntry{}) == "not judged");
}

TEST_CASE("a name is stored beside its recording, whose bytes stay, and can be taken away") {
    ListOfThree three("attempts-names");
    ReplayList& list = three.list;
    const std::string bytes = readTextFile(three.files[2]);
    list.rename(0, "  with the \"new\" gun, 20 %\r\nsecond line ");
    CHECK(list.notice().empty());
    CHECK(list.entries()[0].title == "with the \"new\" gun, 20 %");
    CHECK(readTextFile(three.files[2]) == bytes);
    CHECK(readKeptAttempt(three.files[2]).title == "with the \"new\" gun, 20 %");
    CHECK(keptRecordings(three.folder).size() == 3);
    list.setFilter({"old gun", "", false}); // words of the name
    CHECK(list.rows(kTitles).empty());
    list.setFilter({"gun new", "", false});
    CHECK(list.rows(kTitles) == Indices{0});
    list.rename(0, std::string(1000, 'x'));
    CHECK(list.entries()[0].title.size() <= kLongestTitle + 3);
    list.rename(0, "");
    CHECK(list.entries()[0].title.empty());
    CHECK_FALSE(fs::exists(titleFile(three.files[2])));
    list.rename(0, ""); // no name to take away
    CHECK(list.notice().empty());
    fs::create_directory(titleFile(three.files[2])); // a folder in the way
    CHECK(readTitle(three.files[2]).empty());
    list.rename(0, "lost");
    CHECK_THAT(list.notice(), test::containsText("The name is not kept: "));
    CHECK(list.entries()[0].title.empty());
}

TEST_CASE("a deleted attempt moves aside with its name, says where it is, and comes back to the byte") {
    ListOfThree three("attempts-deleted");
    ReplayList& list = three.list;
    const fs::path file = three.files[1];
    const std::string bytes = readTextFile(file);
    list.rename(1, "the middle one");
    list.rows(kTitles);
    list.remove(1);
    const fs::path aside = three.folder / kDeletedFolder / file.filename();
    CHECK_FALSE(fs::exists(file));
    CHECK(readTextFile(aside) == bytes);
    CHECK(readTitle(aside) == "the middle one");
    CHECK_THAT(list.notice(), test::containsText(aside.string()));
    CHECK(list.entries().size() == 2);
    list.rows(kTitles);
    CHECK(list.selected() == 1); // the next row
    CHECK(keptRecordings(three.folder).size() == 2);
    REQUIRE(list.canBringBack());
    list.bringBack();
    CHECK(readTextFile(file) == bytes);
    CHECK_FALSE(fs::exists(aside));
    CHECK_FALSE(list.canBringBack());
    REQUIRE(list.entries().size() == 3);
    CHECK(list.entries()[1].title == "the middle one");
    list.rows(kTitles);
    CHECK(list.selected() == 1);
}

TEST_CASE("neither deletion nor return replaces another file") {
    ListOfThree three("attempts-deleted-twice");
    const fs::path file = three.files[0], copy = three.folder / "copy";
    fs::copy_file(file, copy);
    const fs::path first = deleteAttempt(file);
    fs::copy_file(copy, file);
    const fs::path second = deleteAttempt(file);
    CHECK(first != second);
    CHECK((fs::exists(first) && fs::exists(second)));
    bringBackAttempt(second, file);
    CHECK_THROWS_WITH(bringBackAttempt(first, file), test::containsText("exists already"));
    CHECK(fs::exists(first));

    // A removal that fails leaves the attempt in the list.
    fs::remove_all(three.folder / kDeletedFolder);
    writeFile(three.folder / kDeletedFolder, "a file in the way");
    three.list.remove(0);
    CHECK_THAT(three.list.notice(), test::containsText("The attempt is not deleted: "));
    CHECK(three.list.entries().size() == 3);
    CHECK(fs::exists(three.files[2]));
}

TEST_CASE("deleted attempts count for the limit, and are the first to go") {
    ListOfThree three("attempts-deleted-limit");
    const std::uint64_t bytes = recordedBytes(three.folder);
    const fs::path aside = deleteAttempt(three.files[2]);
    CHECK(recordedBytes(three.folder) == bytes);
    CHECK_THAT(keepWithinLimit(three.folder, bytes - 1), test::containsText(aside.stem().string()));
    CHECK_FALSE(fs::exists(aside));
    CHECK(fs::exists(three.files[0]));
}

TEST_CASE("a newer attempt is the chosen row; without one the choice stays") {
    ListOfThree three("attempts-newer");
    ReplayList& list = three.list;
    list.rows(kTitles);
    list.select(2);
    std::vector<ReplayEntry> entries = list.entries();
    list.show(entries);
    list.rows(kTitles);
    CHECK(list.selected() == size_t(2));
    ReplayEntry newer = entries.front();
    newer.file = "newer.meltrec";
    entries.insert(entries.begin(), newer);
    list.show(entries);
    list.rows(kTitles);
    CHECK(list.selected() == size_t(0));
}

TEST_CASE("the table has the rows shown, in their order, with name and kind") {
    ListOfThree three("attempts-table");
    ReplayList& list = three.list;
    list.rename(2, "a, b");
    list.press(AttemptColumn::date); // oldest first
    list.rows(kTitles);
    const fs::path file = list.exportRows(three.folder / "tables");
    REQUIRE(fs::exists(file));
    CHECK_THAT(list.notice(), test::containsText(file.string()));
    const std::string text = readTextFile(file);
    const auto lines = splitText(text, '\n');
    REQUIRE(lines.size() == 5);
    CHECK(lines[0].ends_with(",file,person,person_id,title,test"));
    CHECK(lines[1].starts_with("2026-11-01T10:00:00+0000,gmaw-bead,"));
    CHECK(lines[1].ends_with(",\"a, b\",no"));
    CHECK(lines[2].ends_with(",,yes"));
    list.setFilter({"", "", true});
    list.rows(kTitles);
    const fs::path tests = list.exportRows(three.folder / "tables");
    CHECK(tests != file); // no table is replaced
    CHECK(splitText(readTextFile(tests), '\n').size() == 3);
}

} // namespace meltpool
