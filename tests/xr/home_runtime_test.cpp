// Tests the whole program on a real runtime: from the list of lessons on the panel to the result, again, and back.
#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/newest_recording.hpp"
#include "tests/support/places.hpp"
#include "tests/xr/trainee.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Makes a copy of the build's data with two lessons: the default one, small, and a bead on a small plate that is
/// judged.
fs::path smallCatalogue(const fs::path& folder) {
    const fs::path share = folder / "share";
    const fs::path built = test::buildFolder() / "share" / "meltpool";
    fs::create_directories(share / "data" / "lessons");
    fs::create_directory_symlink(fs::canonical(built / "shaders"), share / "shaders");
    for (const auto& entry : fs::directory_iterator(fs::canonical(built / "data")))
        if (entry.path().filename() != "lessons")
            fs::create_directory_symlink(entry.path(), share / "data" / entry.path().filename());
    fs::rename(smallLesson(folder), share / "data" / "lessons" / "classic.toml");
    std::string plate = readTextFile(plateLesson(folder));
    const size_t at = plate.find("[surface]");
    plate.insert(at, "[technique]\nlength_from_mm = -8\nlength_to_mm = 8\n"
                     "travel_speed = { ideal = 8, inner = 4, outer = 8 }\n");
    writeTextFileAtomically(share / "data" / "lessons" / "plate.toml", plate);
    return share;
}

bool onPage(const json& row, const std::string& page) {
    return row["page"] == page;
}

/// Starts the program with these data and without a lesson.
std::unique_ptr<TrainerProcess> startAtHome(const fs::path& folder) {
    const char* const kVariable = "MELTPOOL_DATA";
    const std::string before = std::getenv(kVariable) == nullptr ? "" : std::getenv(kVariable);
    setenv(kVariable, smallCatalogue(folder).c_str(), 1);
    auto trainer = std::make_unique<TrainerProcess>(folder, std::vector<std::string>{"--headset"});
    setenv(kVariable, before.c_str(), 1);
    return trainer;
}

std::function<bool(const json&)> offers(const std::string& place) {
    return [place](const json& row) { return row["headset"]["places"].contains(place); };
}

/// Moves the head to `from` and pitches it by `down`, radians, negative downwards.
void look(Trainee& trainee, const glm::vec3& from, float down) {
    trainee.state.head.position = from;
    trainee.state.head.orientation = glm::angleAxis(down, glm::vec3(1, 0, 0));
    trainee.send();
}

/// Welds 14 mm along the seam, takes the torch away and waits for the result.
void weldBead(Trainee& trainee, TrainerProcess& trainer) {
    REQUIRE(trainee.strike(trainer, {-0.007f, 0.003f, 0}, [](const json& row) { return row["metal"]["molten"] > 5; }));
    for (int i = 1; i <= 28; ++i) {
        const float x = -0.007f + 0.0005f * static_cast<float>(i);
        const double from = trainer.now()["metal"]["time"];
        trainee.aim({x, 0.003f, 0}, 1.0f);
        REQUIRE(trainer.waitFor([&](const json& row) { return row["metal"]["time"] > from + 0.05; }));
        // A gap of the runtime puts the arc out.
        if (trainer.now()["headset"]["trigger_locked"] == true)
            REQUIRE(trainee.strike(trainer, {x, 0.003f, 0}, [](const json& row) {
                return row["headset"]["trigger_locked"] == false && row["headset"]["tip"]["action"] != "out";
            }));
    }
    trainee.aim({0.03f, 0.05f, 0}, 0.0f);
    REQUIRE(trainer.waitFor([](const json& row) {
        return !row["judgement"].is_null() && row["headset"]["places"].contains("result.again");
    }));
}

/// Opens the judged attempt, the last but one in the panel's list, plays it to its end, to the bits of its recording,
/// and goes back to its first second.
void replayTheWeld(Trainee& trainee, TrainerProcess& trainer) {
    REQUIRE(trainer.waitFor(offers("home.attempts")));
    trainee.press(trainer, "home.attempts", offers("home.attempt.1.play"));
    passFrames(trainer, 4);
    keepPicture(screenshot(), "attempts.png");
    trainee.press(trainer, "home.attempt.1.play", [](const json& row) { return !row["replay"].is_null(); });
    REQUIRE(trainer.waitFor([](const json& row) {
        return !row["replay"].is_null() && row["replay"]["over"] == true &&
               row["headset"]["places"].contains("replay.back");
    }));
    CHECK(trainer.now()["replay"]["same"] == true);
    passFrames(trainer, 10);
    keepPicture(screenshot(), "replay.png");
    const double end = trainer.now()["replay"]["time"];
    trainee.press(trainer, "replay.back", [end](const json& row) { return row["replay"]["time"] < end - 0.5; });
    CHECK(trainer.waitFor([](const json& row) { return row["replay"]["seeking"] == false; }));
}

} // namespace

TEST_CASE("a lesson is picked on the panel, demonstrated, welded, judged and begun again with the other hand's trigger",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "home";
    Trainee trainee;
    trainee.bottom = -0.010f; // 4 mm of plate over 6 mm of supports
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0)); // nearly straight down
    const auto process = startAtHome(folder);
    TrainerProcess& trainer = *process;
    REQUIRE(trainer.waitFor([](const json& row) {
        return onPage(row, "home") && row["headset"]["panel"] == true &&
               row["headset"]["places"].contains("home.lesson.plate");
    }));
    CHECK(trainer.now()["metal"]["steps"] == 0);
    passFrames(trainer, 4);
    keepPicture(screenshot(), "home.png");
    trainee.press(trainer, "home.lesson.plate", [](const json& row) { return onPage(row, "start"); });
    REQUIRE(trainer.waitFor([](const json& row) {
        return onPage(row, "start") && row["headset"]["places"].contains("headset.demonstration");
    }));
    trainee.press(trainer, "headset.demonstration", [](const json& row) { return !row["demonstration"].is_null(); });
    REQUIRE(trainer.waitFor([](const json& row) {
        return !row["demonstration"].is_null() && row["demonstration"]["time"] > 0.1 &&
               row["headset"]["places"].contains("demonstration.weld");
    }));
    keepPicture(screenshot(), "demonstration.png");
    trainee.press(trainer, "demonstration.weld", [](const json& row) { return row["demonstration"].is_null(); });
    REQUIRE(trainer.waitFor([](const json& row) { return onPage(row, "running") && row["demonstration"].is_null(); }));
    trainee.lookDown();
    trainee.showPanel(trainer, false);

    weldBead(trainee, trainer);
    INFO(trainer.now()["judgement"].dump());
    // A score, or the reason without one.
    CHECK_THAT(trainer.now()["judgement"]["score"].get<std::string>(), containsText("core"));
    CHECK(trainer.now()["panels"]["result"] == true); // the window shows it too
    keepPicture(screenshot(), "result.png");

    // The weld is cut open in its place, and closed again.
    trainee.press(trainer, "cut.open", [](const json& row) { return !row["cut"].is_null(); });
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["places"].contains("cut.place"); }));
    CHECK(trainer.now()["cut"]["judged"] == true);
    look(trainee, {0.05f, 1.3f, 0.12f}, -0.5f); // leans over it
    passFrames(trainer, 10);
    keepPicture(screenshot(), "cut.png");
    trainee.lookDown();
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "cut.open", [](const json& row) { return row["cut"].is_null(); });

    // The other hand's trigger, pointing at the ceiling, asks for the next attempt.
    trainee.state.hands[0].active = true;
    trainee.state.hands[0].pose.orientation = glm::angleAxis(1.4f, glm::vec3(1, 0, 0));
    trainee.send();
    passFrames(trainer, 10);
    // A pull in passing asks for nothing.
    trainee.state.hands[0].trigger = 1;
    trainee.send();
    passFrames(trainer, 3);
    trainee.state.hands[0].trigger = 0;
    trainee.send();
    passFrames(trainer, 10);
    CHECK_FALSE(trainer.now()["judgement"].is_null());
    bool again = false;
    for (int attempt = 0; attempt < 5 && !again; ++attempt) { // an unanswered frame loses a pull
        trainee.state.hands[0].trigger = 1;
        trainee.send();
        again = comesTrue(trainer, 200, [](const json& row) { return row["judgement"].is_null(); });
        trainee.state.hands[0].trigger = 0;
        trainee.send();
        passFrames(trainer, 4);
    }
    CHECK(again);
    CHECK(trainer.waitFor([](const json& row) { return row["metal"]["molten"] == 0; }));
    CHECK(trainer.waitFor([](const json& row) { return row["headset"]["panel"] == false; }));
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "headset.home", [](const json& row) { return onPage(row, "home"); });
    replayTheWeld(trainee, trainer);
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("from the list of lessons to the weld, its result and back the panel opens and closes by itself",
          "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "by itself";
    Trainee trainee;
    trainee.bottom = -0.010f;
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0));
    const auto process = startAtHome(folder);
    TrainerProcess& trainer = *process;
    const auto inFront = [](const json& row) {
        return row["headset"]["panel"] == true && std::abs(row["headset"]["panel_pose"][0].get<float>()) < 0.01f;
    };
    const auto aside = [](const json& row) {
        return row["headset"]["panel"] == true && row["headset"]["panel_pose"][0] < -0.3f;
    };
    const auto closed = [](const json& row) { return row["headset"]["panel"] == false; };
    REQUIRE(trainer.waitFor(offers("home.lesson.plate")));
    CHECK(comesTrue(trainer, 40, inFront));
    // Over the table, at the height of the eyes.
    CHECK(comesTrue(trainer, 40, [](const json& row) {
        return std::abs(row["headset"]["panel_pose"][1].get<float>() - 1.6f) < 0.02f;
    }));
    passFrames(trainer, 4);
    keepPicture(screenshot(), "itself-home.png");
    trainee.press(trainer, "home.lesson.plate", offers("headset.start"));
    CHECK(comesTrue(trainer, 40, inFront));
    passFrames(trainer, 4);
    keepPicture(screenshot(), "itself-page.png");
    trainee.press(trainer, "headset.start", running);
    CHECK(comesTrue(trainer, 60, aside));
    passFrames(trainer, 4);
    keepPicture(screenshot(), "itself-start.png");
    trainee.lookDown();
    trainee.aim({-0.007f, 0.06f, 0}, 0); // away from the panel
    passFrames(trainer, 4);
    REQUIRE(trainee.strike(trainer, {-0.007f, 0.003f, 0}, [](const json& row) { return row["metal"]["molten"] > 5; }));
    CHECK(comesTrue(trainer, 40, closed));
    keepPicture(screenshot(), "itself-weld.png");
    weldBead(trainee, trainer);
    CHECK(comesTrue(trainer, 60, inFront));
    trainee.state.head = {{1, 0, 0, 0}, {0, 1.6f, 0}};
    trainee.send();
    passFrames(trainer, 8);
    keepPicture(screenshot(), "itself-result.png");

    // Home keeps the panel that the result has opened.
    trainee.press(trainer, "headset.home", [](const json& row) { return onPage(row, "home"); });
    REQUIRE(trainer.waitFor(offers("home.lesson.plate")));
    passFrames(trainer, 30);
    CHECK(inFront(trainer.now()));
    trainee.press(trainer, "home.lesson.plate", offers("headset.start"));
    passFrames(trainer, 30);
    CHECK(inFront(trainer.now()));
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
}

TEST_CASE("the panel asks who welds; the recording of the lesson bears the name that was pressed", "[runtime]") {
    handGeometry();
    const fs::path folder = runFolder() / "who";
    const fs::path person = folder / "meltpool" / "persons" / "0123456789abcdef";
    fs::create_directories(person);
    writeTextFileAtomically(person / "person.toml", "name = \"Anna\"\n");
    Trainee trainee;
    trainee.bottom = -0.010f;
    trainee.zoom = 1;
    trainee.take("gmaw");
    const auto process = startAtHome(folder);
    TrainerProcess& trainer = *process;
    REQUIRE(trainer.waitFor(offers("persons.known.0")));
    CHECK_FALSE(offers("home.lesson.plate")(trainer.now()));
    passFrames(trainer, 4);
    keepPicture(screenshot(), "who.png");
    trainee.press(trainer, "persons.known.0", offers("home.persons"));
    REQUIRE(trainer.waitFor(offers("home.lesson.plate")));
    trainee.press(trainer, "home.lesson.plate", offers("headset.start"));
    trainee.press(trainer, "headset.start", running);
    CHECK(trainer.stop() == 0);
    const auto recordings = recordingsIn(folder / "meltpool" / "recordings");
    REQUIRE(recordings.size() == 1);
    CHECK(readRecording(recordings.front()).head.person == "Anna");
    CHECK(readRecording(recordings.front()).head.personId == "0123456789abcdef");
}

TEST_CASE("in the headset an attempt goes back, is held against another one, and is the ghost of a third",
          "[runtime][long]") {
    handGeometry();
    const fs::path folder = runFolder() / "back";
    Trainee trainee;
    trainee.bottom = -0.010f;
    trainee.zoom = 1;
    trainee.take("gmaw");
    trainee.held = glm::angleAxis(-1.4f, glm::vec3(1, 0, 0));
    const auto process = startAtHome(folder);
    TrainerProcess& trainer = *process;
    REQUIRE(trainer.waitFor(offers("home.lesson.plate")));
    trainee.press(trainer, "home.lesson.plate", offers("headset.start"));
    trainee.press(trainer, "headset.start", running);
    trainee.lookDown();
    trainee.showPanel(trainer, false);
    weldBead(trainee, trainer);

    // The attempt goes back by three seconds, or to the beginning, and on to another end: practice.
    trainee.showPanel(trainer, true);
    REQUIRE(trainer.waitFor(offers("result.redo")));
    trainee.press(trainer, "result.redo", [](const json& row) { return row["judgement"].is_null(); });
    trainee.showPanel(trainer, false);
    passFrames(trainer, 6);
    keepPicture(screenshot(), "redo.png");
    weldBead(trainee, trainer);
    keepPicture(screenshot(), "practice.png");

    trainee.showPanel(trainer, true);
    trainee.press(trainer, "result.again", [](const json& row) { return row["judgement"].is_null(); });
    trainee.showPanel(trainer, false);
    weldBead(trainee, trainer);
    trainee.showPanel(trainer, true);
    trainee.press(trainer, "headset.home", offers("home.attempts"));
    trainee.press(trainer, "home.attempts", offers("home.attempt.1.compare"));
    trainee.press(trainer, "home.attempt.1.compare", offers("home.attempts.marked"));
    trainee.press(trainer, "home.attempt.0.compare", offers("comparison.back"));
    REQUIRE(trainer.waitFor(offers("comparison.words")));
    CHECK_THAT(trainer.now()["headset"]["notice"].get<std::string>(), !containsText("too slow")); // no metal runs
    look(trainee, {0, 1.6f, 0}, 0);
    passFrames(trainer, 10);
    keepPicture(screenshot(), "comparison.png");
    trainee.press(trainer, "comparison.back", offers("home.attempt.0.ghost"));

    trainee.press(trainer, "home.attempt.0.ghost", running);
    trainee.lookDown();
    trainee.showPanel(trainer, false);
    REQUIRE(trainee.strike(trainer, {-0.007f, 0.003f, 0}, [](const json& row) { return row["metal"]["molten"] > 5; }));
    for (int i = 1; i <= 8; ++i) {
        const double from = trainer.now()["metal"]["time"];
        trainee.aim({-0.007f + 0.0005f * static_cast<float>(i), 0.003f, 0.003f}, 1.0f);
        REQUIRE(trainer.waitFor([&](const json& row) { return row["metal"]["time"] > from + 0.05; }));
    }
    trainee.held = glm::angleAxis(-0.8f, glm::vec3(1, 0, 0));
    trainee.aim({-0.003f, 0.008f, 0.012f}, 0.0f); // a look at both torches by the room's light
    look(trainee, {0.12f, 1.15f, -0.25f}, -0.75f);
    passFrames(trainer, 40);
    keepPicture(screenshot(), "ghost.png");
    CHECK(trainer.stop() == 0);
    CHECK(trainer.misuses() == "");
    int wentBack = 0, withGhost = 0;
    for (const fs::path& file : recordingsIn(folder / "meltpool" / "recordings")) {
        const Recording recording = readRecording(file);
        const auto tells = [&](const std::string& name, const std::string& value) {
            return std::any_of(recording.events.begin(), recording.events.end(), [&](const RecordingNote& note) {
                return note.name == name && note.value.find(value) != std::string::npos;
            });
        };
        wentBack += tells("redo", "") ? 1 : 0;
        withGhost += tells("ghost", "file") ? 1 : 0;
    }
    CHECK(wentBack == 1);
    CHECK(withGhost == 1);
}
