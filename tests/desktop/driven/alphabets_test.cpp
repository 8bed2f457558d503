// Tests lessons in other alphabets: their letters are drawn, and letters that no font has are reported.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <csignal>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Alphabet {
    const char *key, *title, *text;
};

/// Makes a copy of the build's data with the classic lesson in these languages only.
fs::path catalogueOf(const std::string& name, const std::vector<Alphabet>& alphabets) {
    const fs::path share = scratchFolder(name);
    const fs::path built = test::buildFolder() / "share" / "meltpool";
    fs::create_directory_symlink(fs::canonical(built / "shaders"), share / "shaders");
    fs::create_directories(share / "data" / "lessons");
    for (const auto& entry : fs::directory_iterator(fs::canonical(built / "data")))
        if (entry.path().filename() != "lessons")
            fs::create_directory_symlink(entry.path(), share / "data" / entry.path().filename());
    const std::string classic = readTextFile(built / "data" / "lessons" / "classic.toml");
    fs::copy_file(built / "data" / "lessons" / "classic.toml", share / "data" / "lessons" / "classic.toml");
    for (const Alphabet& each : alphabets) {
        std::string lesson = classic;
        const auto replaceLine = [&](const std::string& start, const std::string& with) {
            const size_t at = lesson.find("\n" + start) + 1;
            lesson.replace(at, lesson.find('\n', at) - at, with);
        };
        replaceLine("title = ", std::string("title = \"") + each.title + "\"");
        replaceLine("text = ", std::string("text = \"") + each.text + "\"");
        writeTextFileAtomically(share / "data" / "lessons" / (std::string(each.key) + ".toml"), lesson);
    }
    return share;
}

const std::vector<Alphabet> kDrawn{
    {"greek", "Γωνιακή ραφή", "Κρατήστε τον πυρσό στις 45° και προχωρήστε ομαλά."},
    {"russian", "Угловой шов", "Ведите горелку ровно; щель ≤ 1 мм, скорость ≈ 6 мм/с."},
    {"ukrainian", "Кутовий шов", "Тримайте пальник рівно, їжте кашу, ґрунт не плавте."},
    {"romanian", "Sudură de colț", "Țineți torța la 45°; înaintați încet și așteptați baia."},
    {"vietnamese", "Hàn góc trên tấm thép", "Giữ mỏ hàn ở góc 45° và di chuyển đều tay, đừng vội."},
    {"turkish", "Köşe kaynağı", "Torcu İŞ parçasına 45° tutun; ısıyı yavaş yayın, ağır ilerleyin."},
    {"polish", "Spoina pachwinowa", "Prowadź uchwyt równo: źdźbło żółci, łąka, ćma."},
    {"signs", "Rohr ⌀ 60 → ∠ 45° ✓", "Kosten 12 €; Spalt ≤ 1, Höhe ≥ 2, Länge ≈ 30 mm → weiter. ½ ± × µ Ω"}};

} // namespace

TEST_CASE("lessons in Greek, Cyrillic, Romanian, Vietnamese, Turkish and with technical signs are drawn whole") {
    TrainerWindow window("alphabets", {.settings = "[window]\nwidth = 1280\nheight = 900\n",
                                       .lesson = "",
                                       .data = catalogueOf("alphabets-data", kDrawn)});
    const json s = window.settle();
    CHECK(s.at("messages").empty());
    window.takePicture("alphabets-home");
    for (const Alphabet& each : kDrawn) {
        window.click(std::string("home.lesson.") + each.key);
        window.waitFor("the lesson's page", [](const json& t) { return t.at("page") == "start"; });
        window.settle();
        window.takePicture(std::string("alphabets-") + each.key);
        window.click("start.home");
        window.waitFor("the list", [](const json& t) { return t.at("page") == "home"; });
    }
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);
    CHECK(window.output().empty());
}

TEST_CASE("letters that no font has are named once, in the window and on the terminal") {
    const std::vector<Alphabet> japanese{{"japanese", "すみ肉溶接", "トーチを45°に保つ。"}};
    TrainerWindow window("japanese", {.lesson = "", .data = catalogueOf("japanese-data", japanese)});
    window.waitFor("the letters in a message",
                   [](const json& s) { return s.at("messages").dump().find("U+6EB6") != std::string::npos; });
    window.takePicture("missing-letters");
    window.key("Right");
    window.key("Return");
    window.waitFor("the lesson's page", [](const json& t) { return t.at("page") == "start"; });
    window.settle();
    const std::string told = window.output();
    CHECK_THAT(told, containsText("溶"));
    CHECK(told.find("溶") == told.rfind("溶"));
}

TEST_CASE("another language is chosen in the settings, counts at once and after a start, and leaves again") {
    const fs::path share = catalogueOf("language-data", {});
    const fs::path words = share / "data" / "words";
    const std::string english = readTextFile(words / "en.toml");
    fs::remove(words); // a link to the build's folder
    fs::create_directories(words);
    writeTextFileAtomically(words / "en.toml", english);
    writeTextFileAtomically(words / "de.toml", "[language]\nname = \"Deutsch\"\n[home]\nlessons = \"Übungen\"\n"
                                               "[desk.message]\npicture_saved = \"Bild gespeichert: {file}\"\n");
    writeTextFileAtomically(words / "xx.toml", "[home]\nlessons = \"{open\"\n");
    const auto says = [](const char* text) {
        return [text](const json& s) { return s.at("messages").dump().find(text) != std::string::npos; };
    };
    TrainerWindow window("language", {.lesson = "", .data = share});
    CHECK(parameterIn(window.state(), "window", "language") == "system");
    window.key("F2");
    window.click("window.language.de");
    window.waitFor("German", [](const json& s) { return parameterIn(s, "window", "language") == "de"; });
    window.settle();
    window.takePicture("language-settings");
    window.key("Escape");
    window.key("F10");
    window.waitFor("a German sentence", says("Bild gespeichert: "));
    window.key("F2");
    window.click("window.language.xx");
    window.waitFor("its fault", says("xx.toml:2: home.lessons: expected each place in braces of its own"));
    CHECK(parameterIn(window.settle(), "window", "language") == "de"); // it is still spoken
    window.process().signal(SIGTERM);
    CHECK(window.finish() == 0);

    TrainerWindow again("language", {.settings = readTextFile(window.settingsFile()), .lesson = "", .data = share});
    CHECK(parameterIn(again.state(), "window", "language") == "de");
    again.key("F2");
    again.click("window.language.system");
    again.waitFor("English", [](const json& s) { return parameterIn(s, "window", "language") == "system"; });
    again.key("Escape");
    again.key("F10");
    again.waitFor("an English sentence", says("Picture saved as "));
}

} // namespace meltpool::test
