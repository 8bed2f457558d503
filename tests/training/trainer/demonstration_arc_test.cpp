// The shipped demonstrations with the program's own arc: it strikes and burns as the machine is set.
#include "core/training/lesson/lesson.hpp"
#include "core/weld/process/weld.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <map>

using namespace meltpool;

namespace {

std::filesystem::path dataFolder() {
    return test::testFolder().parent_path() / "app" / "data";
}

/// Returns the share of each of the arc's states over the steps with the trigger pulled, from half a second after the
/// first of them on.
std::map<ArcAction, double> statesOf(const Lesson& lesson, double seconds) {
    Weld weld(test::shaders(), readMaterial(dataFolder() / "materials" / (lesson.workpiece.metal + ".toml")),
              makeWorkpiece(lesson.workpiece), lesson.process);
    double pulledSince = -1;
    std::map<ArcAction, double> counts;
    int counted = 0;
    for (double time = 0; pulledSince < 0 || time < pulledSince + seconds; time += weld.timeStep()) {
        const TorchSample torch = lesson.torch.sample(time);
        weld.step(torch, nullptr);
        if (pulledSince < 0 && torch.trigger > 0) pulledSince = time;
        if (pulledSince < 0 || time < pulledSince + 0.5) continue;
        counts[weld.arc().action] += 1;
        ++counted;
    }
    for (auto& [action, count] : counts)
        count /= counted;
    return counts;
}

/// Returns the voltage (V) left for the arc's column at the set stick-out, where the wire melts as fast as it is fed:
/// an open arc above 0, short circuits below.
double voltageOfColumn(const GmawSettings& gmaw) {
    const WireMelting wire = WireMelting::steel(static_cast<double>(gmaw.wireDiameterMm) * 1e-3);
    const double current =
        wire.current(static_cast<double>(gmaw.wireFeedMPerMin) / 60, static_cast<double>(gmaw.stickOutMm) * 1e-3);
    return static_cast<double>(gmaw.voltage) - kArcFallVoltage - kWireResistance * current;
}

} // namespace

TEST_CASE("every arc lesson's demonstration welds with the arc that its machine is set for", "[training]") {
    int arcs = 0;
    for (const std::string& name : lessonNames(dataFolder() / "lessons")) {
        Lesson lesson = findLesson(name, dataFolder() / "lessons");
        if (lesson.model != LessonModel::Weld || !lesson.process.is<Gmaw>()) continue;
        ++arcs;
        auto states = statesOf(lesson, 2.2);
        INFO(name << ": " << states[ArcAction::burning] << " burning, " << states[ArcAction::shorting] << " shorting");
        CHECK(states[ArcAction::stubbed] == 0);
        CHECK(states[ArcAction::out] == 0);
        CHECK(states[ArcAction::breaking] < 0.05);
        // Dip transfer has 20 to 200 short circuits a second: an arc at the border of both modes burns in part of the
        // steps.
        if (voltageOfColumn(lesson.process.of<Gmaw>()) > 0)
            CHECK(states[ArcAction::burning] > 0.9);
        else
            CHECK(states[ArcAction::shorting] > 0.2);
    }
    CHECK(arcs >= 2);
}
