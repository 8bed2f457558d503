// Loss of metal from the space: none in the shipped demonstrations.
#include "core/training/lesson/lesson.hpp"
#include "core/weld/process/weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>

using namespace meltpool;

namespace {

/// Returns the largest number of lost particles at any moment of the lesson's demonstration.
size_t mostLost(const Lesson& lesson) {
    const auto materials = test::testFolder().parent_path() / "app" / "data" / "materials";
    Weld weld(test::shaders(), readMaterial(materials / (lesson.workpiece.metal + ".toml")),
              makeWorkpiece(lesson.workpiece), lesson.process);
    size_t most = 0;
    const int steps = static_cast<int>(static_cast<double>(lesson.run.seconds) / weld.timeStep());
    for (int i = 1; i <= steps; ++i) {
        weld.step(lesson.torch.sample(i * weld.timeStep()), nullptr);
        if (i % 4 == 0) most = std::max(most, weld.metal().statistics().lost);
    }
    return most;
}

Lesson shippedLesson(const std::string& name) {
    return findLesson(name, test::testFolder().parent_path() / "app" / "data" / "lessons");
}

} // namespace

TEST_CASE("the solder lessons lose no metal: drops between table and cube, a bar that falls", "[training]") {
    Lesson cube = shippedLesson("solder-cube");
    cube.workpiece.spacingMm = 2; // faster, with equally frequent squeezed drops
    CHECK(mostLost(cube) == 0);
    Lesson bridge = shippedLesson("solder-bridge");
    bridge.workpiece.spacingMm = 2;
    CHECK(mostLost(bridge) == 0);
}

TEST_CASE("no shipped lesson loses metal in its demonstration, at its own spacing", "[training][long]") {
    for (const std::string& name : lessonNames(test::testFolder().parent_path() / "app" / "data" / "lessons")) {
        const Lesson lesson = shippedLesson(name);
        INFO(name);
        if (lesson.model == LessonModel::Weld) CHECK(mostLost(lesson) == 0);
    }
}
