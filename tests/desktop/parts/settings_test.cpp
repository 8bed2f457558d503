// Tests the settings file: round trip, faults named with their line, broken files set aside; and the messages on the
// screen.
#include "app/desktop/desktop_settings.hpp"
#include "app/desktop/screenshot.hpp"
#include "app/session/messages.hpp"
#include "app/session/settings.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#ifdef __linux__
#include "tests/support/environment_change.hpp"
#endif

#include <array>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kKinds{"ordered", "random"};

struct Values {
    float speed = 0.1f;
    int count = 7;
    int kind = 0;
    bool open = false;
    glm::vec3 pull{0, -9.81f, 0};
    std::string name = "quiet \"one\"";

    std::vector<SettingsSection> sections() {
        return {
            {"first", {{"speed", "Speed", "m/s", &speed, 0, 10, "fast"}, {"count", "Count", "", &count, 1, 100, ""}}},
            {"second",
             {{"kind", "Kind", "", &kind, 0, 1, "", kKinds},
              {"open", "Open", "", &open, 0, 1, ""},
              {"pull", "Pull", "", &pull, -100, 100, ""},
              {"name", "Name", "", &name, 0, 0, ""}}}};
    }
};

fs::path fileWith(const std::string& folder, const std::string& text) {
    const fs::path file = test::scratchFolder(folder) / "settings.toml";
    writeTextFileAtomically(file, text);
    return file;
}

size_t filesIn(const fs::path& folder) {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder))
        ++count;
    return count;
}

} // namespace

TEST_CASE("settings come back as they were kept, to the bit") {
    Values kept;
    kept.speed = 0.30000001f;
    kept.count = 42;
    kept.kind = 1;
    kept.open = true;
    kept.pull = {1.0f / 3, -2, 1e-7f};
    const fs::path file = test::scratchFolder("settings-kept") / "new" / "settings.toml";
    saveSettings(file, kept.sections());
    Values read;
    CHECK(loadSettings(file, read.sections()).empty());
    CHECK(read.speed == kept.speed);
    CHECK(read.count == kept.count);
    CHECK(read.kind == kept.kind);
    CHECK(read.open == kept.open);
    CHECK(read.pull == kept.pull);
    CHECK(read.name == kept.name);
    CHECK(filesIn(file.parent_path()) == 1);
}

TEST_CASE("no settings file is no fault") {
    Values values;
    CHECK(loadSettings(test::scratchFolder("settings-none") / "settings.toml", values.sections()).empty());
}

TEST_CASE("two programs with the same settings file keep each other's changes") {
    const fs::path file = test::scratchFolder("settings-two") / "settings.toml";
    Values first, second;
    const SettingsValues before = valuesOf(first.sections());
    first.speed = 0.5f;
    first.kind = 1;
    CHECK(saveSettings(file, first.sections(), before).empty());
    second.pull = {1, 2, 3};
    second.kind = 1;
    second.name = "loud";
    CHECK(saveSettings(file, second.sections(), before).empty());
    first.count = 9;
    CHECK(saveSettings(file, first.sections(), before).empty());
    Values read;
    CHECK(loadSettings(file, read.sections()).empty());
    CHECK(read.speed == 0.5f);
    CHECK(read.count == 9);
    CHECK(read.kind == 1);
    CHECK(read.pull == glm::vec3(1, 2, 3));
    CHECK(read.name == "loud");
    CHECK(first.name == "quiet \"one\""); // the running lesson is not touched
}

TEST_CASE("a fault that another program leaves in the settings is told when they are saved, and the file kept aside") {
    const fs::path file = fileWith("settings-late", "[first]\nspede = 1\n");
    Values values;
    CHECK(loadSettings(file, values.sections()).size() == 2);
    const SettingsValues before = valuesOf(values.sections());
    // The fault was reported at the start, with a copy of the file.
    CHECK(saveSettings(file, values.sections(), before).empty());
    CHECK_FALSE(fs::exists(file.parent_path() / "settings.broken-2.toml"));
    writeTextFileAtomically(file, "[first]\ncount = 8\nvolume = 1\n");
    const auto faults = saveSettings(file, values.sections(), before);
    REQUIRE(faults.size() == 2);
    CHECK_THAT(faults[0], test::containsText(":3: unknown key 'volume'"));
    CHECK_THAT(faults[1], test::containsText("settings.broken-2.toml"));
    Values read;
    CHECK(loadSettings(file, read.sections()).empty());
    CHECK(read.count == 8);
}

TEST_CASE("each fault is told with its line, good values beside it are taken, the file is kept aside") {
    const fs::path file = fileWith("settings-faults", "[first]\nspeed = 50\ncount = 9\nspede = 1\n\n[second]\nkind = "
                                                      "\"shuffled\"\nopen = 3\npull = [1, 2]\n[third]\nx = 1\n");
    Values values;
    const auto faults = loadSettings(file, values.sections());
    std::string all;
    for (const std::string& fault : faults)
        all += fault + "\n";
    INFO(all);
    REQUIRE(faults.size() == 7);
    const std::string name = file.string();
    CHECK_THAT(all, test::containsText(name + ":2: 'speed' is '50'; expected a number from 0 to 10 (m/s)"));
    CHECK_THAT(
        all, test::containsText(name + ":4: unknown key 'spede'; did you mean 'speed'? Expected one of speed, count"));
    CHECK_THAT(all, test::containsText(name + ":7: 'kind' is 'shuffled'; expected one of ordered, random"));
    CHECK_THAT(all, test::containsText(name + ":8: 'open' is '3'; expected true or false"));
    CHECK_THAT(all, test::containsText(name + ":9: 'pull'"));
    CHECK_THAT(all, test::containsText(name + ":10: unknown entry 'third'; expected a table of [first], [second]"));
    CHECK_THAT(faults.back(), test::containsText("is kept as") && test::containsText("settings.broken-1.toml"));
    CHECK(values.count == 9);
    CHECK(values.speed == 0.1f);
    CHECK(values.kind == 0);
    CHECK(readTextFile(file.parent_path() / "settings.broken-1.toml") == readTextFile(file));
}

TEST_CASE("a file that is no TOML is set aside whole and the defaults stand") {
    const fs::path file = fileWith("settings-broken", "[first]\nspeed = = 3\n");
    writeTextFileAtomically(file.parent_path() / "settings.broken-1.toml", "an older one");
    Values values;
    const auto faults = loadSettings(file, values.sections());
    REQUIRE(faults.size() == 2);
    CHECK_THAT(faults[0], test::containsText(file.string() + ":2: "));
    CHECK_THAT(faults[0], test::containsText("the program uses its defaults instead"));
    CHECK_THAT(faults[1], test::containsText("settings.broken-2.toml"));
    CHECK_FALSE(fs::exists(file));
    CHECK(readTextFile(file.parent_path() / "settings.broken-2.toml") == "[first]\nspeed = = 3\n");
    CHECK(readTextFile(file.parent_path() / "settings.broken-1.toml") == "an older one");
    CHECK(values.speed == 0.1f);
}

TEST_CASE("bytes that are no text, a folder in the file's place: told, never thrown") {
    std::string noise(300, '\0');
    for (size_t i = 0; i < noise.size(); ++i)
        noise[i] = static_cast<char>(i * 37 + 11);
    Values values;
    CHECK_FALSE(loadSettings(fileWith("settings-noise", noise), values.sections()).empty());
    const fs::path folder = test::scratchFolder("settings-folder") / "settings.toml";
    fs::create_directories(folder);
    CHECK_THROWS_AS(saveSettings(folder, values.sections()), InputError);
    CHECK_FALSE(loadSettings(folder, values.sections()).empty());
    CHECK_FALSE(fs::exists(folder)); // moved aside, so that the next settings can be saved
}

TEST_CASE("a settings file of a key with 40,000 parts is set aside, not parsed") {
    std::string deep = "a";
    for (int i = 0; i < 40000; ++i)
        deep += ".a";
    Values values;
    const fs::path file = fileWith("settings-deep", "\n" + deep + " = 1\n");
    const auto faults = loadSettings(file, values.sections());
    REQUIRE(faults.size() == 2);
    CHECK_THAT(faults[0], test::containsText(":2: the key has too many parts; expected at most 16"));
    CHECK_FALSE(fs::exists(file));
}

TEST_CASE("settings that will not be saved are told at the start") {
    DesktopSettings lost("/proc/nowhere/settings.toml");
    const auto faults = lost.load({});
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], test::containsText("The settings of this session cannot be saved: /proc/nowhere"));
    CHECK_THROWS_AS(lost.save({}), InputError);
    DesktopSettings kept(test::scratchFolder("settings-savable") / "new" / "settings.toml");
    CHECK(kept.load({}).empty());
}

TEST_CASE("the default lesson's values are kept while others are opened, theirs are not") {
    const fs::path file = fileWith("settings-lessons", "[start]\nparticles = 1000\n[view]\nexposure = 2\n");
    DesktopSettings settings(file);
    CHECK(settings.load({}).empty());
    Lesson classic = loadLesson(std::string(kDefaultLesson)), bead = loadLesson("gmaw-bead");
    LessonSections ofClassic(classic), ofBead(bead);
    settings.giveTo(classic, ofClassic);
    CHECK(classic.setup.particles == 1000);
    CHECK(classic.look.exposure == 2);
    settings.giveTo(bead, ofBead);
    CHECK(bead.look.exposure != 2);
    classic.setup.particles = 1728;
    ofClassic.attempt.forScore = true;
    bead.look.exposure = 3;
    settings.takeFrom(classic, ofClassic);
    settings.takeFrom(bead, ofBead);
    CHECK(settings.save({}).empty());
    DesktopSettings again(file);
    CHECK(again.load({}).empty());
    Lesson then = loadLesson(std::string(kDefaultLesson));
    LessonSections ofThen(then);
    again.giveTo(then, ofThen);
    CHECK(then.setup.particles == 1728);
    CHECK(then.look.exposure == 2);
    CHECK_FALSE(ofThen.attempt.forScore); // a test does not stick
}

TEST_CASE("messages go after their time; held ones stay until their fault is gone or they are put away") {
    Messages messages;
    messages.note("saved", 0);
    messages.hold("shader fails", "shader");
    messages.hold("shader fails", "shader");
    CHECK(messages.shown().size() == 2);
    messages.expire(100000);
    REQUIRE(messages.shown().size() == 1);
    messages.dismiss(messages.shown().front());
    messages.hold("shader fails", "shader");
    CHECK(messages.shown().empty());
    messages.hold("shader fails otherwise", "shader");
    CHECK(messages.shown().size() == 1);
    messages.clear("shader");
    messages.hold("shader fails", "shader");
    CHECK(messages.shown().size() == 1);
    for (int i = 0; i < 50; ++i)
        messages.warn("again", 0);
    CHECK(messages.shown().size() <= 5);
}

#ifdef __linux__
TEST_CASE("pictures go into the person's folder, which is made; where nothing can be written they are refused") {
    const Image image{2, 1, std::vector<std::uint8_t>(6)};
    const fs::path folder = test::scratchFolder("pictures-named") / "Bilder";
    {
        const test::EnvironmentChange named("XDG_PICTURES_DIR", folder.c_str());
        CHECK(savePicture(image).parent_path() == folder);
    }
    const test::EnvironmentChange named("XDG_PICTURES_DIR", "/proc/nowhere");
    CHECK_THROWS_AS(savePicture(image), InputError);
}
#endif

TEST_CASE("pictures are named by the time and never overwrite one another") {
    const fs::path folder = test::scratchFolder("pictures");
    for (int i = 0; i < 3; ++i) {
        const fs::path name = pictureName(folder);
        CHECK_FALSE(fs::exists(name));
        CHECK_THAT(name.filename().string(), test::containsText("meltpool-20"));
        writeTextFileAtomically(name, "x");
    }
    CHECK(filesIn(folder) == 3);
}

} // namespace meltpool
