// Tests that a finished weld gets its judgement before a key ends the attempt: no result is empty, no score is lost.
#include "core/training/attempt/recording_reader.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"

namespace meltpool::test {

using nlohmann::json;

namespace {

const char* const kQuickPicture = "[window]\nwidth = 960\nheight = 640\n[view]\nmode = \"points\"\nshow_sky = false\n";

/// Welds some 15 mm of a bead by keys, and lets the trigger go.
void weldAWhile(TrainerWindow& window) {
    window.xdotool({"keydown", "space", "keydown", "Shift_L", "keydown", "Right"});
    const double begin = window.waitFor("a pool", [](const json& s) { return s.at("metal").at("molten") > 50; })
                             .at("torch")
                             .at("tip_mm")
                             .at(0);
    window.waitFor("15 mm", [&](const json& s) { return s.at("torch").at("tip_mm").at(0) > begin + 15; });
    window.xdotool({"keyup", "Right", "keyup", "Shift_L", "keyup", "space"});
}

bool told(const json& row, const char* words) {
    return row.at("messages").dump().find(words) != std::string::npos;
}

} // namespace

TEST_CASE("F5 and H right after a weld judge it first, and its recording has the verdict") {
    TrainerWindow window("judged-first", {.settings = kQuickPicture, .lesson = "gmaw-bead"});
    window.start();
    weldAWhile(window);
    CHECK(window.state().at("judgement").is_null());
    window.key("F5");
    const json judged = window.waitFor("the result", [](const json& s) { return !s.at("judgement").is_null(); });
    CHECK(judged.at("panels").at("result") == true);
    CHECK(told(window.settle(), "judged first"));
    CHECK(window.state().at("metal").at("steps") >= judged.at("metal").at("steps")); // the same attempt
    window.takePicture("judged-first");
    window.key("x");
    window.waitFor("the cut", [](const json& s) { return told(s, "cut open") || !s.at("cut").is_null(); });
    const bool machine = window.settle().at("panels").at("simulation");
    window.key("F3"); // the machine has nothing to set now
    window.waitFor("a sentence", [](const json& s) { return told(s, "Close the cut (X)"); });
    CHECK(window.state().at("panels").at("simulation") == machine);
    window.key("x");
    window.settle();
    window.key("F5");
    const long long steps = judged.at("metal").at("steps");
    window.waitFor("a new attempt", [&](const json& s) { return s.at("metal").at("steps") < steps; });

    weldAWhile(window);
    const auto atHome = [](const json& s) { return s.at("page") == "home"; };
    for (int i = 0; i < 20 && !atHome(window.state()); ++i) { // H waits for the arc to go out
        window.key("h");
        if (window.comesTrue(5, atHome)) break;
    }
    window.waitFor("the lessons", atHome);
    window.closeWindow();
    CHECK(window.finish() == 0);
    for (const auto& entry : std::filesystem::directory_iterator(window.recordingsFolder())) {
        if (!isRecording(entry.path())) continue;
        INFO(entry.path());
        const RecordingSummary summary = readRecordingSummary(entry.path());
        REQUIRE(summary.end);
        CHECK_FALSE(summary.end->verdict.empty());
    }
}

} // namespace meltpool::test
