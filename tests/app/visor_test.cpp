// The visor and the eye of the window's picture, in a lesson in progress.
#include "app/session/lesson_session.hpp"
#include "app/session/notices.hpp"
#include "core/render/picture_target.hpp"
#include "tests/app/program.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

namespace {

/// A viewer of the demonstration in a window with 45 frames a second.
class Watcher {
  public:
    explicit Watcher(const LookParameters& look) : session(test::shaders(), lessonWith(look), [] { return 0.0; }) {
        session.demonstrate(controls);
    }

    void watch(double seconds) {
        constexpr double kFrame = 1.0 / 45;
        for (double time = 0; time < seconds; time += kFrame) {
            session.advance(controls, kFrame, nullptr);
            session.picture().draw(session.picture().atDesk(controls, 1, {0, 0}, false, nullptr), target.target(),
                                   nullptr);
            LessonFigures figures;
            fillFigures(figures, session);
            notices.update(session, figures, lock, kFrame, messages);
        }
    }
    bool told(std::string_view text) const {
        for (const Message& message : messages.shown())
            if (message.text.find(text) != std::string::npos) return true;
        return false;
    }
    float shade() const { return session.picture().visor().filter().shade(visorOf(session.lesson().look)); }

    Controls controls;
    LessonSession session;
    PictureTarget target{32, 32};
    Messages messages;
    Notices notices;
    TriggerLock lock;

  private:
    static Lesson lessonWith(const LookParameters& look) {
        Lesson lesson = test::plainBead();
        lesson.workpiece.lengthMm = 100; // length of the expert's path
        lesson.look.adaptation = look.adaptation;
        lesson.look.visorShade = look.visorShade;
        lesson.look.visorLightShade = look.visorLightShade;
        return lesson;
    }
};

/// Returns the mean of all channels, 0..255, of the picture that a run took of its lesson's first look.
double brightness(const std::filesystem::path& folder, const std::string& time) {
    const Image picture = readPng(folder / (time + "-metal.png"));
    double sum = 0;
    for (const unsigned char value : picture.rgb)
        sum += value;
    return sum / static_cast<double>(picture.rgb.size());
}

} // namespace

TEST_CASE("who watches an arc without a visor is dazzled and told so, where the eye adapts", "[app]") {
    LookParameters look;
    look.adaptation = true;
    Watcher watcher(look);
    watcher.watch(0.2);
    CHECK_FALSE(watcher.session.run().arc().burns());
    const float before = watcher.session.picture().visor().eye().exposure();
    CHECK_FALSE(watcher.told("You looked"));
    watcher.watch(1);
    REQUIRE(watcher.session.run().arc().burns());
    CHECK(watcher.told("You looked into the arc without a visor for "));
    CHECK(watcher.session.picture().visor().eye().exposure() < 0.8f * before);
    CHECK(watcher.session.picture().visor().eye().afterImage().strength > 0.5f);
}

TEST_CASE("the window's auto-darkening visor is light before the arc and dark while it burns", "[app]") {
    LookParameters look;
    look.adaptation = true;
    look.visorShade = 10;
    look.visorLightShade = 3;
    Watcher watcher(look);
    watcher.watch(0.2);
    CHECK(watcher.shade() == 3);
    watcher.watch(1);
    REQUIRE(watcher.session.run().arc().burns());
    CHECK(watcher.shade() == 10);
    CHECK(watcher.messages.shown().empty());
    CHECK(watcher.session.picture().visor().eye().afterImage().strength == 0);
}

TEST_CASE("a look without adaptation tells and changes nothing", "[app]") {
    Watcher watcher({});
    watcher.watch(1.2);
    REQUIRE(watcher.session.run().arc().burns());
    CHECK(watcher.messages.shown().empty());
    CHECK(watcher.shade() == 0);
}

TEST_CASE("pictures of a run follow visor and eye where the look asks for it, and only there", "[app]") {
    const auto taken = [](const std::string& name, const std::string& values) {
        const std::filesystem::path folder = test::scratchFolder(name);
        const test::Outcome run = test::runMeltpool(
            "run gmaw-bead --seconds 0.9 --size 96x54 --out '" + folder.string() +
            "' --set pictures_every=0.3 --set spacing_mm=1.5 --set cells=32 --set visor_shade=10" + values);
        INFO(run.errors);
        REQUIRE(run.code == 0);
        return folder;
    };
    const auto fixed = taken("fixed visor", ""), own = taken("own visor", " --set visor_light_shade=3"),
               eye = taken("eye", " --set visor_light_shade=3 --set adaptation=true");
    CHECK(brightness(fixed, "000.000s") < 2);
    CHECK(brightness(own, "000.000s") > 20);                                // the filter's light state
    CHECK(brightness(own, "000.900s") == brightness(fixed, "000.900s"));    // the filter's dark state
    CHECK(brightness(eye, "000.900s") < 0.8 * brightness(own, "000.900s")); // eye adapted to the arc
    CHECK(brightness(eye, "000.300s") > brightness(own, "000.300s"));       // eye adapted to the dim room
}
