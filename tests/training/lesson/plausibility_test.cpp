// Warnings about torch paths that are readable but weld nothing, and about incomplete lessons.
#include "core/training/lesson/plausibility.hpp"

#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

const std::filesystem::path kLessons = test::testFolder().parent_path() / "app" / "data" / "lessons";

/// Returns a straight path from `from` to `to` (mm) in `seconds`.
TorchPath lineOf(const glm::vec3& from, const glm::vec3& to, double seconds, float trigger = 1) {
    std::vector<TorchSample> samples;
    for (int i = 0; i <= 20; ++i) {
        TorchSample sample;
        sample.time = seconds * i / 20;
        sample.tip = glm::mix(from, to, static_cast<float>(i) / 20) * 1e-3F;
        sample.trigger = trigger;
        samples.push_back(sample);
    }
    return TorchPath(std::move(samples));
}

std::string warningsOf(const char* name, TorchPath torch) {
    Lesson lesson = findLesson(name, kLessons);
    lesson.torch = std::move(torch);
    lesson.torchFile = "path.csv";
    std::string all;
    for (const std::string& sentence : pathWarnings(lesson))
        all += sentence + "\n";
    return all;
}

} // namespace

TEST_CASE("the demonstration of every shipped lesson is plausible", "[training]") {
    for (const std::string& name : lessonNames(kLessons)) {
        INFO(name);
        const Lesson lesson = findLesson(name, kLessons);
        CHECK(pathWarnings(lesson) == std::vector<std::string>{});
        CHECK(lessonWarnings(lesson, kLessons) == std::vector<std::string>{});
    }
}

TEST_CASE("a path that cannot weld the workpiece is warned of with the reason", "[training]") {
    const char* bead = "gmaw-bead";
    CHECK(warningsOf(bead, lineOf({-30, 3, 0}, {30, 3, 0}, 10)).empty());
    CHECK_THAT(warningsOf(bead, lineOf({-30, 3, 0}, {30, 3, 0}, 10, 0)),
               containsText("The torch path path.csv never pulls the trigger"));
    CHECK_THAT(warningsOf(bead, lineOf({-0.03F, 0.003F, 0}, {0.03F, 0.003F, 0}, 10)),
               containsText("a thousand times too small. Are its positions metres?"));
    CHECK_THAT(warningsOf(bead, lineOf({-30000, 3000, 0}, {30000, 3000, 0}, 10)),
               containsText("a thousand times too large"));
    const std::string world = warningsOf(bead, lineOf({1200, 350, 800}, {1260, 350, 800}, 10));
    CHECK_THAT(world, containsText("is wholly outside the workpiece: x from 1200 to 1260") &&
                          containsText("not those of a robot's world"));
    CHECK_THAT(warningsOf(bead, lineOf({-30, 3, 0}, {30, 3, 0}, 9000)), containsText("lasts 2.5 hours."));
    CHECK(warningsOf(bead, lineOf({5, 3, 0}, {5, 3, 0}, 10)).empty()); // a spot weld
    // Milliseconds with a point for thousands: 8.4 s are read as 8.4 ms.
    CHECK_THAT(warningsOf(bead, lineOf({-30, 3, 0}, {30, 3, 0}, 0.0084)), containsText("travels at 7143 mm/s"));
    // The path is on a tee's plate, far from its corner.
    CHECK_THAT(warningsOf("tee-fillet", lineOf({-20, 3, 24}, {20, 3, 24}, 10)),
               containsText("never comes within 20 mm of the joint's seam"));
}

TEST_CASE("a trigger that is pulled after the run's end is warned of", "[training]") {
    Lesson lesson = findLesson("gmaw-bead", kLessons);
    std::vector<TorchSample> samples(2);
    samples[0].tip = samples[1].tip = {0, 0.003F, 0};
    samples[1].time = 50;
    samples[1].trigger = 1;
    lesson.torch = TorchPath(samples);
    lesson.run.seconds = 20;
    CHECK(pathWarnings(lesson, true).empty()); // 20 s are deliberate
    REQUIRE(pathWarnings(lesson).size() == 1);
    CHECK_THAT(pathWarnings(lesson)[0], containsText("pulls the trigger at 50 s, and the run ends at 20 s"));
}

TEST_CASE("a path that is written for another pipe is warned of", "[training]") {
    const auto file = test::scratchFolder("pipe") / "pipe.toml";
    writeTextFileAtomically(file, "start_mm = [0, 3, 0]\npipe_diameter_mm = 100\n[[move]]\nkind = 'arc_on'\n"
                                  "[[move]]\nkind = 'line'\nto_mm = [20, 3, 0]\nspeed_mm_s = 4\n");
    CHECK_THAT(warningsOf("pipe-5g", TorchPath::read(file)), containsText("is written for a pipe of 100 mm, and"));
    CHECK_THAT(warningsOf("gmaw-bead", TorchPath::read(file)), containsText("and the workpiece is not a pipe."));
}

TEST_CASE("a lesson without a title, or with a next one that is not there, is warned of", "[training]") {
    const auto file = test::scratchFolder("lesson") / "mine.toml";
    writeTextFileAtomically(file, "next = \"solder-cub\"\n");
    const std::vector<std::string> sentences = lessonWarnings(readLesson(file), kLessons);
    REQUIRE(sentences.size() == 2);
    CHECK_THAT(sentences[0], containsText("The lesson mine.toml has no title"));
    CHECK_THAT(sentences[1], containsText("names 'solder-cub' as the next lesson, which is not in the catalogue"));
}
