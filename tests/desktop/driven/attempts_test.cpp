// Tests the list of saved attempts in the running window: names, deletion and the table, by mouse and keys.
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/recording_bytes.hpp"

#include <array>

namespace meltpool::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path keptOnDay(const fs::path& folder, int day) {
    AttemptHead head = recordedHead("gmaw-bead");
    head.utc = "2026-11-0" + std::to_string(day) + "T10:00:00.000Z";
    head.date = "2026-11-0" + std::to_string(day) + "T10:00:00+0000";
    RecordingBytes bytes;
    bytes.head(head).step(recordedStep(1));
    const fs::path file = folder / ("2026-11-0" + std::to_string(day) + "_10-00-00_gmaw-bead_1.meltrec");
    writeFile(file, bytes.end(recordedEnd(1)).bytes());
    return file;
}

auto shows(const std::string& name) {
    return [name](const json& s) { return s.at("places").contains(name); };
}

} // namespace

TEST_CASE("an attempt is named, deleted and brought back in the window's list") {
    TrainerWindow window("attempts-window", {.lesson = ""});
    fs::create_directories(window.recordingsFolder());
    for (const int day : {1, 2, 3})
        keptOnDay(window.recordingsFolder(), day);
    const fs::path newest = window.recordingsFolder() / "2026-11-03_10-00-00_gmaw-bead_1.meltrec";
    window.click("home.attempts");
    window.waitFor("three rows", shows("home.attempt.2"));
    window.click("home.attempts.name");
    const json asked = window.waitFor("the line for a name", shows("home.attempts.title"));
    const auto line = asked.at("places").at("home.attempts.title").get<std::array<double, 4>>(),
               button = asked.at("places").at("home.attempts.name").get<std::array<double, 4>>();
    CHECK(line[0] == Approx(button[0]).margin(5)); // below its button
    CHECK(line[1] - (button[1] + button[3]) < 20);
    window.xdotool({"type", "--delay", "60", "hot j"}); // letters that are keys elsewhere
    window.holdKey("Return", "the list again",
                   [](const json& s) { return !s.at("places").contains("home.attempts.title"); });
    CHECK(readTextFile(window.recordingsFolder() / "2026-11-03_10-00-00_gmaw-bead_1.title.txt") == "hot j\n");
    window.takePicture("attempts");

    window.click("home.attempts.delete");
    window.waitFor("a question", shows("home.attempts.delete.yes"));
    window.key("Escape"); // gives the question up, and leaves the list open
    window.waitFor("no question", [](const json& s) { return !s.at("places").contains("home.attempts.delete.yes"); });
    CHECK(fs::exists(newest));
    window.click("home.attempts.delete");
    window.click("home.attempts.delete.yes");
    window.waitFor("two rows", [](const json& s) {
        return s.at("places").contains("home.attempt.1") && !s.at("places").contains("home.attempt.2");
    });
    CHECK_FALSE(fs::exists(newest));
    CHECK(fs::exists(window.recordingsFolder() / "deleted" / newest.filename()));
    window.click("home.attempts.undo");
    window.waitFor("three rows again", shows("home.attempt.2"));
    CHECK(fs::exists(newest));

    window.click("home.attempts.column.score");
    window.click("home.attempts.export");
    const fs::path tables = window.folder() / "data" / "meltpool" / "tables";
    window.waitFor("the table", [&](const json&) { return fs::exists(tables) && !fs::is_empty(tables); });
    window.key("Escape");
    window.waitFor("the lessons", shows("home.lesson.gmaw-bead"));
}

} // namespace meltpool::test
