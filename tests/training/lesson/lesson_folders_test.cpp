// Lessons by name from the folders of program, school and person: resolution of a name, and files that are no lesson.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson_folders.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

/// Returns three folders below a new one, with a file for each of "shipped/a.toml" ..; the text is a lesson's title.
LessonFolders foldersWith(const fs::path& base, std::initializer_list<const char*> files) {
    for (const char* folder : {"shipped", "school", "own"})
        fs::create_directories(base / folder);
    for (const char* file : files)
        writeTextFileAtomically(base / file, std::string("title = '") + file + "'\n");
    LessonFolders folders(base / "shipped");
    folders.add(LessonOrigin::school, base / "school" / ""); // a trailing slash has no effect
    folders.add(LessonOrigin::own, base / "own");
    return folders;
}

std::string keysOf(const std::vector<NamedLesson>& lessons) {
    std::string keys;
    for (const NamedLesson& lesson : lessons)
        keys += std::string(nameOf(lesson.origin)) + "/" + lesson.key + (lesson.fault.empty() ? " " : "! ");
    return keys;
}

} // namespace

TEST_CASE("lessons of three folders are found by name", "[training]") {
    const fs::path base = test::scratchFolder("lesson-folders");
    const LessonFolders folders =
        foldersWith(base, {"shipped/b.toml", "shipped/a.toml", "school/c.toml", "own/e.toml", "own/d.meltpool"});
    CHECK(keysOf(folders.list()) == "shipped/a shipped/b school/c own/d own/e ");
    for (const auto& [name, title] : {std::pair("a", "shipped/a.toml"), std::pair("c", "school/c.toml"),
                                      std::pair("d", "own/d.meltpool"), std::pair("e", "own/e.toml")})
        CHECK(findLesson(name, folders).title == title);
    CHECK_THROWS_WITH(findLesson("f", folders), containsText("expected one of a, b, c, d, e, or a file"));
    CHECK_THROWS_AS(findLesson("../own/e", folders), InputError);
    CHECK_THROWS_AS(findLesson("", folders), InputError);
}

TEST_CASE("a name means the shipped lesson first, then the school's; the other file says so", "[training]") {
    const fs::path base = test::scratchFolder("lesson-namesakes");
    const LessonFolders folders = foldersWith(
        base, {"shipped/a.toml", "school/a.toml", "school/b.toml", "own/a.toml", "own/b.toml", "own/c.toml"});
    CHECK(keysOf(folders.list()) == "shipped/a school/a! school/b own/a! own/b! own/c ");
    CHECK(findLesson("a", folders).title == "shipped/a.toml");
    CHECK(findLesson("b", folders).title == "school/b.toml");
    const std::vector<NamedLesson> named = folders.named("b");
    REQUIRE(named.size() == 2);
    CHECK(named[0].fault.empty());
    CHECK(named[1].fault == (base / "own" / "b.toml").string() +
                                ": has the name of a lesson of the school, so 'b' means that one; expected a file name "
                                "of its own, such as my-b.toml");
    CHECK_THAT(folders.named("a")[2].fault, containsText("has the name of a shipped lesson"));
}

TEST_CASE("materials, torch paths, limits and checks beside own lessons are no lessons", "[training]") {
    const fs::path base = test::scratchFolder("lesson-others");
    const LessonFolders folders = foldersWith(base, {"shipped/a.toml", "own/mine.toml"});
    const fs::path data = test::testFolder().parent_path() / "app" / "data";
    fs::copy_file(data / "materials" / "copper.toml", base / "own" / "steel.toml");
    fs::copy_file(data / "paths" / "tee-fillet.toml", base / "own" / "path.toml");
    fs::copy_file(data / "acceptance" / "iso5817-c.toml", base / "own" / "limits.toml");
    writeTextFileAtomically(base / "own" / "checks.toml", "lesson = 'mine.toml'\n[expect]\nscore = [1, 2]\n");
    writeTextFileAtomically(base / "own" / "broken.toml", "title = \n");
    fs::create_directories(base / "own" / "folder.toml");
    // A broken file may be a lesson: the list contains it so that its fault is visible.
    CHECK(keysOf(folders.list()) == "shipped/a own/broken own/folder! own/mine ");
}

TEST_CASE("a school's folder that is missing is told; a person's need not exist", "[training]") {
    const fs::path base = test::scratchFolder("lesson-missing");
    const LessonFolders folders = foldersWith(base, {"shipped/a.toml"});
    fs::remove_all(base / "school");
    fs::remove_all(base / "own");
    std::vector<std::string> faults;
    CHECK(keysOf(folders.list(&faults)) == "shipped/a ");
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0],
               containsText("school") &&
                   containsText("cannot be read; expected a folder with lessons (MELTPOOL_LESSONS names it)"));
    CHECK_THROWS_WITH(findLesson("b", folders), containsText("expected one of a,") && containsText("MELTPOOL_LESSONS"));
    writeTextFileAtomically(base / "own", "no folder");
    faults.clear();
    folders.list(&faults);
    CHECK(faults.size() == 2);
}

TEST_CASE("the same folder named twice gives its lessons once", "[training]") {
    const fs::path base = test::scratchFolder("lesson-twice");
    LessonFolders folders = foldersWith(base, {"shipped/a.toml", "own/b.toml"});
    folders.add(LessonOrigin::own, base / "shipped" / ".." / "own");
    CHECK(keysOf(folders.list()) == "shipped/a own/b ");
}

TEST_CASE("an attempt finds its lesson again by file, else by name among the school's and the person's", "[training]") {
    const fs::path base = test::scratchFolder("lesson-of-attempt");
    const LessonFolders folders = foldersWith(base, {"shipped/a.toml", "own/b.toml", "own/elsewhere.toml"});
    RecordedAttempt attempt;
    attempt.file = "attempt.meltrec";
    attempt.head.lesson = "a";
    CHECK(findLessonOf(attempt, folders).title == "shipped/a.toml");
    attempt.head.lesson = "b"; // the name in a CSV record
    CHECK(findLessonOf(attempt, folders).title == "own/b.toml");
    CHECK(movedLessonText(attempt, findLessonOf(attempt, folders)).empty());
    attempt.head.lessonFile = (base / "own" / "elsewhere.toml").string();
    CHECK(findLessonOf(attempt, folders).title == "own/elsewhere.toml");
    attempt.head.lessonFile = "/nowhere/b.toml";
    const Lesson moved = findLessonOf(attempt, folders);
    CHECK(moved.title == "own/b.toml");
    CHECK_THAT(movedLessonText(attempt, moved), containsText("/nowhere/b.toml is no longer there"));
    attempt.head.lesson = "a"; // a shipped lesson never replaces a file elsewhere
    CHECK_THROWS_WITH(findLessonOf(attempt, folders), containsText("expected --lesson with this lesson's file"));
}
