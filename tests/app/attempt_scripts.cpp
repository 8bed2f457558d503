#include "tests/app/attempt_scripts.hpp"

#include "app/session/lesson_session.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace meltpool::test {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kFrame = 1.0 / 45;
constexpr double kPull = 0.1;       ///< s, time of the first trigger pull
constexpr double kTouched = 0.1;    ///< s of contact for an electrode to strike
constexpr double kOutOfSight = 0.3; ///< s for which a lost torch remains lost

const std::array<AttemptScript, 20> kScripts{{
    {"flame held over the cube", "flame", "cube", "still", 1.8},
    {"flame in circles, turned up", "flame", "cube", "circle", 2, {{0.8, "flame_power", "1900"}}},
    {"flame along the bridge", "flame", "bridge", "along", 1.6, {}, kNever, 0.7},
    {"flame that is lost", "flame", "cube", "weave", 2, {}, 0.9},
    {"iron held on the cube", "iron", "cube", "still", 1.8},
    {"iron along the cube, made hotter", "iron", "cube", "along", 2, {{0.7, "tip_temperature_c", "460"}}, kNever, 1.2},
    {"TIG along a plate", "gtaw", "plate", "along", 1.8},
    {"TIG weave, current up and down",
     "gtaw",
     "plate",
     "weave",
     2.2,
     {{0.6, "current", "170"}, {1.4, "current", "90"}}},
    {"TIG in a corner", "gtaw", "tee", "along", 1.8},
    {"TIG by mouse", "gtaw", "plate", "desk", 2, {{1.2, "current", "140"}}},
    {"TIG with rod", "rod", "plate", "along", 2.2},
    {"TIG with rod, shaky and lost", "rod", "plate", "shaky", 2.2, {{0.5, "current", "150"}}, 1.3},
    {"wire along a plate", "gmaw", "plate", "along", 1.8},
    {"wire weave, voltage turned",
     "gmaw",
     "plate",
     "weave",
     2.2,
     {{0.7, "voltage", "25"}, {1.3, "inductance", "high"}}},
    {"wire in a corner", "gmaw", "tee", "weave", 2, {}, kNever, 1},
    {"wire in a corner, lost, more wire", "gmaw", "tee", "shaky", 2.2, {{0.6, "wire_feed_m_min", "8"}}, 1.2},
    {"wire by mouse in a corner", "gmaw", "tee", "desk", 2, {{0.9, "voltage", "27"}}},
    {"wire in dabs, gone back", "gmaw", "plate", "dabs", 2.4, {{0.5, "voltage", "21"}}, kNever, kNever, 1.9},
    {"electrode along a plate", "smaw", "plate", "along", 2.2, {{1.1, "current", "140"}}},
    {"electrode in a corner, shaky", "smaw", "tee", "shaky", 2.2, {}, 1.5, 0.9},
}};

std::string lessonNameOf(const AttemptScript& script) {
    if (script.piece == "cube") return "solder-cube";
    if (script.piece == "bridge") return "solder-bridge";
    if (script.piece == "tee") return "tee-fillet";
    if (script.process == "rod") return "gtaw-rod";
    return script.process + "-bead";
}

/// Sets a process other than the lesson's own; the lesson's bands belong to its own process.
void changeProcess(Lesson& lesson, const AttemptScript& script) {
    if (script.process == "iron") {
        lesson.process.choose<SolderingIron>() = {};
    } else if (script.piece == "tee" && script.process == "gtaw") {
        lesson.process.choose<Gtaw>().current = 130;
    } else if (script.piece == "tee" && script.process == "smaw") {
        lesson.process.choose<Smaw>().current = 115;
    } else {
        return;
    }
    lesson.technique.reset();
    lesson.acceptance.reset();
}

/// Distance (m) from the welded place to the tip, away from the metal.
float distanceOf(const AttemptScript& script, double time) {
    if (script.process == "flame") return 10 * kMm;
    if (script.process == "iron") return 0.5F * kMm;
    if (script.process == "gmaw") return (script.piece == "tee" ? 5 : 3) * kMm;
    if (script.process == "smaw") return time < kPull + kTouched ? -0.2F * kMm : 2.5F * kMm;
    return (script.piece == "tee" ? 3 : 2) * kMm;
}

/// Path of the hand: x along the seam, y across it, m.
glm::vec2 wayOf(const std::string& hand, double time) {
    constexpr double kTurn = glm::two_pi<double>();
    const auto swing = [time](double hertz) { return static_cast<float>(std::sin(kTurn * hertz * time)); };
    const float along = -5 * kMm + 4 * kMm * static_cast<float>(time);
    if (hand == "still") return {-2 * kMm, 0};
    if (hand == "circle") return 2 * kMm * glm::vec2(static_cast<float>(std::cos(kTurn * 0.7 * time)), swing(0.7));
    if (hand == "weave") return {along, 1.5F * kMm * swing(1.5)};
    if (hand == "shaky") return {along + 0.3F * kMm * swing(9), 0.3F * kMm * swing(8) + 0.2F * kMm * swing(11.3)};
    return {along, 0};
}

/// Position of a workpiece under the torch.
struct StartPlace {
    glm::vec3 middle{0};
    glm::vec3 up{0, 1, 0};
    glm::vec3 across{0, 0, 1};
    double workAngle = glm::half_pi<double>();
};

StartPlace placeOf(const AttemptScript& script) {
    StartPlace place;
    if (script.piece == "cube") place.middle.y = 5 * kMm;
    if (script.piece != "tee") return place;
    const float diagonal = std::sqrt(0.5F);
    place.up = {0, diagonal, diagonal};
    place.across = {0, -diagonal, diagonal};
    place.workAngle = glm::quarter_pi<double>();
    return place;
}

/// The torch at the end of the step at `time`, s.
TorchSample torchAt(const AttemptScript& script, double time) {
    const StartPlace place = placeOf(script);
    const glm::vec2 way = wayOf(script.hand, time);
    const bool stick = script.process == "smaw";
    TorchSample torch;
    torch.orientation = heldOrientation(place.workAngle, glm::radians(stick ? -15.0 : 10.0), {1, 0, 0});
    torch.tip = place.middle + distanceOf(script, time) * place.up + way.x * glm::vec3(1, 0, 0) + way.y * place.across;
    // The hand follows an electrode that burns off.
    if (stick) torch.tip += torch.axis() * (4.5F * kMm * static_cast<float>(std::max(time - kPull - kTouched, 0.0)));
    const bool between = script.hand == "dabs" && std::fmod(time, 0.6) > 0.45;
    const bool lost = time >= script.lost && time < script.lost + kOutOfSight;
    torch.trigger = time < kPull || between || lost ? 0.0F : 1.0F;
    if (script.process != "rod") return torch;
    RodHold hold;
    hold.frequency = 1.2;
    hold.feed = 2e-3;
    if (!lost) torch.rod = hold.sample(torch.tip, time);
    return torch;
}

/// The trainee: plays the script frame by frame.
class Person {
  public:
    Person(const AttemptScript& script, LessonSession& session) : script_(script), session_(session) {}

    void begin() {
        session_.begin(controls_);
        REQUIRE(session_.running());
        if (script_.hand != "desk") return;
        controls_.captureMouse();
        controls_.parameters.guideSpeed = 4;
        controls_.parameters.tremor = 1;
    }

    void frame() {
        const double time = session_.run().torch().time;
        turnSettings(time);
        tellLoss(time);
        if (time >= script_.pause && !std::exchange(paused_, true)) pause();
        if (time >= script_.redo && !std::exchange(wentBack_, true)) goBack();
        if (script_.hand == "desk")
            leadByMouse(time);
        else
            session_.advance(controls_, kFrame, nullptr, [this](int, int) { return next(); });
        session_.settle(controls_);
        if (++frames_ % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2)); // time for checkpoints
    }

  private:
    TorchSample next() const { return torchAt(script_, session_.run().torch().time + 1.0 / 90); }

    void turnSettings(double time) {
        for (; turned_ < script_.changes.size() && time >= script_.changes[turned_].time; ++turned_) {
            const ScriptedChange& change = script_.changes[turned_];
            setParameter(session_.sections().simulation.parameters, change.key, change.value, script_.name);
        }
    }

    void tellLoss(double time) {
        const bool lost = time >= script_.lost && time < script_.lost + kOutOfSight;
        if (lost != std::exchange(lost_, lost)) session_.run().event("torch", lost ? "lost" : "seen");
    }

    /// Runs some frames without a step.
    void pause() {
        const size_t steps = session_.run().steps();
        controls_.setMode(Mode::view);
        for (int i = 0; i < 3; ++i)
            session_.advance(controls_, kFrame, nullptr);
        controls_.setMode(Mode::interact);
        CHECK(session_.run().steps() == steps);
        session_.run().event("zoom", "2");
    }

    void goBack() {
        REQUIRE(session_.redoes());
        session_.redo(controls_);
        CHECK(session_.log().redo().redone() == 1);
    }

    void leadByMouse(double time) {
        InputFrame input;
        input.leftHeld = time > kPull;
        input.mouseMove = {time > kPull ? 0.5F : 0.0F, static_cast<float>(std::sin(7 * time))};
        input.scroll = frames_ == 30 ? 1.0F : 0.0F;
        if (frames_ == 40) input.pressed.push_back(Key::left);
        controls_.update(input, kFrame);
        session_.advance(controls_, kFrame, nullptr);
    }

    const AttemptScript& script_;
    LessonSession& session_;
    Controls controls_;
    size_t turned_ = 0;
    bool lost_ = false, paused_ = false, wentBack_ = false;
    int frames_ = 0;
};

} // namespace

std::span<const AttemptScript> attemptScripts() {
    return kScripts;
}

Lesson lessonOf(const AttemptScript& script) {
    Lesson lesson = findLesson(lessonNameOf(script), testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.choose.clear(); // the machine is set as the lesson wants it
    lesson.surface.cells = 24;
    changeProcess(lesson, script);
    WorkpieceParameters& piece = lesson.workpiece;
    if (script.piece == "cube" || script.piece == "bridge") {
        piece.temperatureC = 150;
        if (script.piece == "cube") piece.lengthMm = 10;
        return lesson;
    }
    piece.lengthMm = 20;
    piece.widthMm = script.piece == "tee" ? 16 : 14;
    piece.thicknessMm = script.piece == "tee" ? 3 : 4;
    if (script.piece == "tee") piece.heightMm = 12;
    piece.temperatureC = 600; // melts within a second
    return lesson;
}

std::filesystem::path recordAttempt(const AttemptScript& script, const std::filesystem::path& folder) {
    LessonSession session(shaders(), lessonOf(script), [] { return 0.0; });
    session.log().recordings().use(folder, "program", "driver");
    Person person(script, session);
    person.begin();
    for (int frames = 0; frames < 1000 && session.run().torch().time < script.seconds; ++frames)
        person.frame();
    CHECK(session.run().fault() == "");
    CHECK(session.run().torch().time >= script.seconds);
    session.end("start menu");
    session.log().recordings().finish();
    CHECK(session.log().recordings().lost() == "");
    return session.log().recordings().file();
}

} // namespace meltpool::test
