// Tests the home page without a window: its lessons, their order, and the keys that move the choice.
#include "app/session/home.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

namespace {

namespace fs = std::filesystem;

fs::path shippedLessons() {
    return resourceFolder() / "data" / "lessons";
}

/// Makes a folder of lessons with these texts by name.
fs::path lessonsWith(const std::string& name, const std::map<std::string, std::string>& texts) {
    const fs::path folder = test::scratchFolder(name) / "lessons";
    fs::create_directories(folder);
    for (const auto& [key, text] : texts)
        writeTextFileAtomically(folder / (key + ".toml"), text);
    return folder;
}

} // namespace

TEST_CASE("the shipped lessons are listed by process, the easiest of each first, from a bead with wire and gas on") {
    Home home(shippedLessons(), test::scratchFolder("home-shipped") / "best-scores.toml");
    REQUIRE(home.lessons().size() >= 5);
    int level = 1, process = 0;
    std::string order;
    for (const CataloguedLesson& lesson : home.lessons()) {
        INFO(lesson.key << ": " << lesson.fault);
        CHECK(lesson.fault.empty());
        CHECK_FALSE(lesson.title.empty());
        CHECK_FALSE(lesson.text.empty());
        CHECK(lesson.process >= process);
        if (lesson.process == process) CHECK(lesson.level >= level);
        level = lesson.level;
        process = lesson.process;
        order += lesson.key + " ";
        if (!lesson.next.empty()) CHECK(home.find(lesson.next) != nullptr);
    }
    CHECK(order.starts_with(
        "gmaw-bead tee-fillet tee-thin lap-2f corner-1f butt-1g tee-3f smaw-bead smaw-tee gtaw-bead "));
    CHECK(home.chosen().key == "gmaw-bead");
    CHECK(home.find(readLesson(shippedLessons() / "gmaw-bead.toml")) == home.find("gmaw-bead"));
    CHECK(home.find("knitting") == nullptr);
}

TEST_CASE("a lesson at fault is listed with its sentence, after those that can be used") {
    const fs::path folder = lessonsWith(
        "home-faults",
        {{"a", "title = 'A'\nlevel = 9\n"}, {"b", "title = 'B'\n"}, {"c", "level = 2\n"}, {"d", "level = 1\n"}});
    const Home home(folder, folder / "best-scores.toml");
    std::string order;
    for (const CataloguedLesson& lesson : home.lessons())
        order += lesson.key;
    CHECK(order == "dcba"); // a lesson without a level comes after the others, the faulty one last
    CHECK_THAT(home.find("a")->fault, test::containsText("a.toml:2: level"));
    CHECK(home.find("a")->title == "a");
    CHECK(home.find("b")->title == "B");
    CHECK_THROWS_AS(Home(lessonsWith("home-empty", {}), folder / "best-scores.toml"), InputError);
    CHECK_THROWS_AS(Home(folder / "none", folder / "best-scores.toml"), InputError);
}

TEST_CASE("lessons of a level are listed before the ones that follow them, also if they go round") {
    const fs::path folder = lessonsWith(
        "home-next",
        {{"a", "next = 'c'\n"}, {"b", "next = 'a'\n"}, {"c", ""}, {"x", "next = 'y'\n"}, {"y", "next = 'x'\n"}});
    const Home home(folder, folder / "best-scores.toml");
    std::string order;
    for (const CataloguedLesson& lesson : home.lessons())
        order += lesson.key;
    CHECK(order == "bacxy");
}

TEST_CASE("arrow keys move the choice through rows of lessons and stop at both ends") {
    std::map<std::string, std::string> texts;
    for (const char* key : {"a", "b", "c", "d", "e"})
        texts[key] = "level = 1\n";
    const fs::path folder = lessonsWith("home-keys", texts);
    Home home(folder, folder / "best-scores.toml");
    home.columns = 3;
    const auto after = [&](int right, int down) {
        home.move(right, down);
        return home.chosen().key;
    };
    CHECK(after(-1, 0) == "a");
    CHECK_FALSE(home.takeMoved());
    CHECK(after(0, -1) == "a");
    CHECK(after(1, 0) == "b");
    CHECK(home.takeMoved());
    CHECK_FALSE(home.takeMoved());
    CHECK(after(0, 1) == "e");
    CHECK(after(0, 1) == "e");
    CHECK(after(1, 0) == "e");
    CHECK(after(0, -1) == "b");
    CHECK(after(0, 0) == "b");
    home.choose("d");
    CHECK(after(-1, 0) == "c");
    home.choose("knitting");
    CHECK(home.chosen().key == "c");
}

TEST_CASE("own lessons stand in groups behind the shipped ones, with the fault of each file, and are read again") {
    const fs::path shipped = lessonsWith("home-groups", {{"a", "level = 1\n"}, {"b", "level = 2\n"}});
    const fs::path own = shipped.parent_path() / "own";
    fs::create_directories(own);
    writeTextFileAtomically(own / "a.toml", "level = 1\n");
    writeTextFileAtomically(own / "c.toml", "level = 1\ntorch = 'gone.csv'\n");
    writeTextFileAtomically(own / "d.toml", "level = 1\ntitle = 'D'\n");
    LessonFolders folders(shipped);
    folders.add(LessonOrigin::school, shipped.parent_path() / "school");
    folders.add(LessonOrigin::own, own);
    Home home(folders, shipped / "best-scores.toml");
    CHECK(home.faults().size() == 1); // the school's folder does not exist
    const auto groups = home.groups();
    REQUIRE(groups.size() == 2);
    CHECK(groups[0].end == 2);
    CHECK(groups[1].origin == LessonOrigin::own);
    CHECK(groups[1].end == 5);
    CHECK(home.lessons()[2].key == "d"); // faulty lessons come last
    CHECK(home.lessons()[3].taken);
    CHECK(home.find("a")->origin == LessonOrigin::shipped);
    CHECK(home.find(readLesson(own / "a.toml")) == nullptr); // the file's scores would belong to another lesson
    CHECK(home.find(readLesson(own / "d.toml")) == home.find("d"));
    CHECK(shortFault(*home.find("c")).starts_with("c.toml:2: torch: gone.csv: "));

    home.choose("d");
    writeTextFileAtomically(own / "c.toml", "level = 1\ntitle = 'C'\n");
    home.refresh();
    CHECK(home.find("c")->fault.empty());
    CHECK(home.chosen().key == "d");
}

TEST_CASE("arrow keys go from the last row of a group to the first of the next one and back") {
    const fs::path shipped = lessonsWith("home-group-keys", {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}, {"e", ""}});
    const fs::path own = shipped.parent_path() / "own";
    fs::create_directories(own);
    for (const char* key : {"f", "g", "h", "i"})
        writeTextFileAtomically(own / (std::string(key) + ".toml"), "");
    LessonFolders folders(shipped);
    folders.add(LessonOrigin::own, own);
    Home home(folders, shipped / "best-scores.toml");
    home.columns = 3; // rows: a b c, d e; f g h, i
    const auto after = [&](const char* key, int right, int down) {
        home.choose(key);
        home.move(right, down);
        return home.chosen().key;
    };
    CHECK(after("b", 0, 1) == "e");
    CHECK(after("c", 0, 1) == "e");
    CHECK(after("e", 0, 1) == "g");
    CHECK(after("e", 1, 0) == "f");
    CHECK(after("h", 0, 1) == "i");
    CHECK(after("h", 0, -1) == "e");
    CHECK(after("f", 0, -1) == "d");
    CHECK(after("i", 0, -1) == "f");
    CHECK(after("i", 0, 1) == "i");
    CHECK(after("a", 0, -1) == "a");
}

TEST_CASE("level and best score stand below a lesson's title") {
    const fs::path folder = lessonsWith("home-standing", {{"a", "level = 2\n"}, {"b", ""}});
    Home home(folder, folder.parent_path() / "best-scores.toml");
    CHECK(home.standing(*home.find("a")) == "Level 2 of 5");
    CHECK(home.standing(*home.find("b")).empty());
    home.scores.offer("a", {71.6, true});
    home.scores.offer("b", {12});
    CHECK(home.standing(*home.find("a")) == "Level 2 of 5 \xC2\xB7 Best so far: 72, accepted");
    CHECK(home.standing(*home.find("b")) == "Best so far: 12");
}

TEST_CASE("a lesson's picture is a texture; a missing or broken one is none") {
    test::context();
    const fs::path folder = test::scratchFolder("home-pictures");
    Image image{4, 3, std::vector<std::uint8_t>(36, 200)};
    writePng(folder / "whole.png", image);
    writeTextFileAtomically(folder / "broken.png", "no picture");
    LessonPictures pictures;
    const GLuint texture = pictures.texture(folder / "whole.png");
    CHECK(texture != 0);
    CHECK(pictures.texture(folder / "whole.png") == texture);
    CHECK(pictures.texture(folder / "broken.png") == 0);
    CHECK(pictures.texture(folder / "none.png") == 0);
}

} // namespace meltpool
