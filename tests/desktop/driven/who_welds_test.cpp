// Tests the question for a name in the running window: by keys, at the next start, and from the command line.
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <set>
#include <string>

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const char* const kNarrow = "[window]\nwidth = 800\nheight = 600\n";

fs::path personsOf(const fs::path& data) {
    return data / "meltpool" / "persons";
}

/// Names in the folder of persons.
std::set<std::string> namesIn(const fs::path& persons) {
    std::set<std::string> names;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(persons, missing)) {
        if (!fs::exists(entry.path() / "person.toml")) continue;
        const std::string text = readTextFile(entry.path() / "person.toml");
        const size_t begin = text.find("name = \"") + 8;
        names.insert(text.substr(begin, text.find('"', begin) - begin));
    }
    return names;
}

void waitForQuestion(TrainerWindow& window, bool shown) {
    window.waitFor(shown ? "the question" : "the lessons",
                   [&](const json& s) { return s.at("places").contains("persons.name") == shown; });
}

/// Persons who welded the recordings of a window.
std::multiset<std::string> recordedPersons(const TrainerWindow& window) {
    std::multiset<std::string> persons;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(window.recordingsFolder(), missing))
        if (isRecording(entry.path())) persons.insert(readRecordingSummary(entry.path()).head.person);
    return persons;
}

} // namespace

TEST_CASE("at home N asks who welds: a typed name, the other one by Enter, and at the next start the last one") {
    TrainerWindow window("who-keys", {.settings = kNarrow, .lesson = ""});
    const json first = window.settle();
    CHECK(first.at("places").contains("home.persons"));
    CHECK_FALSE(first.at("places").contains("persons.name")); // there is no name to choose from
    const fs::path persons = personsOf(window.folder() / "data");
    CHECK_FALSE(fs::exists(persons));
    for (const char* name : {"Anna Maria", "Bert"}) {
        window.key("n");
        waitForQuestion(window, true);
        window.settle();
        window.xdotool({"type", "--delay", "120", name});
        window.settle();
        window.key("Return");
        waitForQuestion(window, false);
        CHECK(namesIn(persons).contains(name));
    }
    CHECK(window.settle().at("page") == "home"); // Enter has opened no lesson
    window.takePicture("who-home");
    window.key("n");
    waitForQuestion(window, true);
    window.settle();
    window.key("Return"); // Anna Maria, the other one
    waitForQuestion(window, false);
    CHECK(namesIn(persons) == std::set<std::string>{"Anna Maria", "Bert"});
    window.closeWindow();
    CHECK(window.finish() == 0);

    TrainerWindow again(
        "who-again",
        {.settings = kNarrow, .lesson = "", .environment = {{"XDG_DATA_HOME", (window.folder() / "data").string()}}});
    waitForQuestion(again, true);
    again.settle();
    again.click("persons.guest");
    waitForQuestion(again, false);
    again.closeWindow();
    CHECK(again.finish() == 0);
}

TEST_CASE("with --person the recordings bear the name; those of a guest are not kept") {
    for (const auto& [name, persons] :
         {std::pair<std::string, std::multiset<std::string>>{" anna  / 2 ", {"anna / 2"}}, {"guest", {}}}) {
        TrainerWindow window("who-recorded", {.arguments = {"--person", name}});
        window.start();
        window.closeWindow();
        CHECK(window.finish() == 0);
        CHECK(recordedPersons(window) == persons);
    }
}

} // namespace meltpool::test
