// Comparison of two recorded attempts in the window: each is welded again within the frames' time, to the bits of its
// record.
#include "app/activities/attempt_comparison.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

/// Record of a bead on a small plate, welded at `speed` in mm/s.
fs::path recordedBead(const fs::path& folder, const std::string& name, float speed) {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 14;
    lesson.workpiece.thicknessMm = 3;
    lesson.workpiece.spacingMm = 1.5f;
    lesson.surface.cells = 32;
    const fs::path file = folder / name;
    Trainer trainer(test::shaders(), std::move(lesson));
    trainer.record(file, {1, "some program", "some driver"});
    while (trainer.time() < 2.2) {
        TorchSample torch;
        torch.tip = {-0.008f + speed * 1e-3f * static_cast<float>(trainer.time()), 0.003f, 0};
        torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
        torch.trigger = trainer.time() > 0.1 && trainer.time() < 2 ? 1 : 0;
        trainer.advance(torch, nullptr);
    }
    trainer.stopRecord();
    return file;
}

/// Runs frames of a stopped clock until both attempts are welded. Returns the number of frames.
int untilBoth(AttemptComparison& comparison) {
    int frames = 0;
    double before = 0;
    while (comparison.welding() && frames < 3000) {
        comparison.update(test::shaders(), 1.0 / 45, [] { return 0.0; });
        ++frames;
        CHECK(comparison.progress() >= before - 1e-9);
        before = comparison.progress();
    }
    return frames;
}

double meanOf(const AttemptComparison& comparison, size_t number, const char* key) {
    return comparison.attempt(number)->figures.values.at(key);
}

} // namespace

TEST_CASE("two attempts are welded again in shares of frames, held against each other, and known from then on",
          "[app]") {
    const fs::path folder = test::scratchFolder("window-comparison");
    const fs::path slow = recordedBead(folder, "slow.csv", 5), fast = recordedBead(folder, "fast.csv", 8);
    AttemptComparison comparison;
    CHECK_FALSE(comparison.welding());
    comparison.begin({slow, "slow"}, {fast, "fast"});
    REQUIRE(comparison.welding());
    CHECK(comparison.current() == 0);
    CHECK(comparison.progress() == 0);
    CHECK(untilBoth(comparison) > 6); // the work is spread over frames
    INFO(comparison.fault());
    REQUIRE(comparison.rows());
    CHECK(comparison.progress() == 1);
    CHECK(comparison.welded() == 2);
    for (size_t i = 0; i < 2; ++i)
        CHECK(comparison.attempt(i)->end.verdict == ReplayEnd::Verdict::same);
    CHECK(meanOf(comparison, 1, "travel_speed") > 1.3 * meanOf(comparison, 0, "travel_speed"));
    CHECK_THAT(comparison.rows()->words, test::containsText("faster travel"));
    CHECK(comparison.bands() != nullptr);

    comparison.begin({fast, "fast"}, {slow, "slow"}); // no second weld of known attempts
    CHECK_FALSE(comparison.welding());
    REQUIRE(comparison.rows());
    CHECK_THAT(comparison.rows()->words, test::containsText("slower travel"));
    const fs::path third = recordedBead(folder, "third.csv", 6);
    comparison.begin({slow, "slow"}, {third, "third"});
    CHECK(comparison.current() == 1);
    untilBoth(comparison);
    CHECK(comparison.welded() == 3);
    comparison.end();
    CHECK_FALSE(comparison.rows());
}

TEST_CASE("an attempt is welded again with a change, and a sentence says what would have passed", "[app]") {
    const fs::path folder = test::scratchFolder("window-what-if");
    const fs::path one = recordedBead(folder, "one.csv", 8);
    AttemptComparison comparison;
    comparison.choose("wire_feed_m_min=2.9", "wire feed 2.9 m/min instead of 3.6");
    comparison.tryChange({one, "one"});
    REQUIRE(comparison.welding());
    CHECK(comparison.side(1).detail == "wire feed 2.9 m/min instead of 3.6");
    untilBoth(comparison);
    INFO(comparison.fault());
    REQUIRE(comparison.rows());
    CHECK(comparison.attempt(0)->end.verdict == ReplayEnd::Verdict::same);
    CHECK(meanOf(comparison, 1, "mean_current_a") < meanOf(comparison, 0, "mean_current_a") - 5);
    CHECK_THAT(comparison.rows()->words, test::containsText("With wire feed 2.9 m/min instead of 3.6 "));
    CHECK(comparison.welded() == 2);

    comparison.choose("speed=5mm/s", "travel speed 5 mm/s instead of 8");
    comparison.tryChange({one, "one"});
    untilBoth(comparison);
    INFO(comparison.fault());
    REQUIRE(comparison.rows());
    CHECK(meanOf(comparison, 1, "travel_speed") == Approx(5).margin(0.3));

    // The changed weld is not taken for the attempt itself.
    const fs::path two = recordedBead(folder, "two.csv", 6);
    comparison.begin({one, "one"}, {two, "two"});
    untilBoth(comparison);
    CHECK(meanOf(comparison, 0, "travel_speed") == Approx(8).margin(0.3));
    CHECK_THAT(comparison.rows()->words, !test::containsText("instead of"));

    comparison.choose("colour=red", "red");
    CHECK_THROWS_AS(comparison.tryChange({one, "one"}), InputError);
    CHECK(comparison.rows()); // the earlier comparison stays
}

TEST_CASE("what is no pair of welds of a lesson is refused, and ending frees the metal", "[app]") {
    const fs::path folder = test::scratchFolder("window-comparison-faults");
    const fs::path one = recordedBead(folder, "one.csv", 8);
    AttemptComparison comparison;
    CHECK_THROWS_WITH(comparison.begin({one, ""}, {one, ""}), test::containsText("with itself"));
    CHECK_THROWS_AS(comparison.begin({one, ""}, {folder / "nowhere.csv", ""}), InputError);
    CHECK_FALSE(comparison.welding());
    const fs::path two = recordedBead(folder, "two.csv", 9);
    comparison.begin({one, "one"}, {two, "two"});
    for (int frame = 0; frame < 4; ++frame)
        comparison.update(test::shaders(), 1.0 / 45, [] { return 0.0; });
    CHECK(comparison.welding());
    CHECK(comparison.progress() > 0);
    comparison.end();
    CHECK_FALSE(comparison.welding());
    comparison.update(test::shaders(), 1.0 / 45, [] { return 0.0; });
    CHECK(comparison.welded() == 0);
}

TEST_CASE("a person who compares two attempts is in no lesson, and the session makes the steps of both", "[app]") {
    const fs::path folder = test::scratchFolder("window-comparison-session");
    const fs::path one = recordedBead(folder, "one.csv", 8), two = recordedBead(folder, "two.csv", 9);
    LessonSession session(test::shaders(), test::plainBead(), [] { return 0.0; });
    Controls controls;
    Activities& activities = session.activities();
    const AttemptComparison& comparison = activities.comparison;
    CHECK_THROWS_AS(session.compare({one, ""}, {one, ""}), InputError);
    CHECK_FALSE(activities.at(comparison));
    session.compare({one, "one"}, {two, "two"});
    CHECK(activities.at(comparison));
    CHECK(activities.current().hurries());
    CHECK_FALSE(session.running());
    CHECK(session.leader() == TorchLeader::none);
    for (int frame = 0; comparison.welding() && frame < 3000; ++frame)
        session.advance(controls, 1.0 / 45, nullptr);
    CHECK(comparison.rows());
    CHECK_FALSE(activities.current().hurries());
    session.reset(controls); // the comparison has no lesson to restore
    CHECK(activities.at(comparison));
    activities.endComparison();
    CHECK_FALSE(activities.at(comparison));
    CHECK_FALSE(comparison.rows());
    session.compare({two, "two"}, {one, "one"});
    CHECK(comparison.rows()); // both attempts are known
    session.begin(controls);
    CHECK(activities.at(activities.attempt));
    CHECK_FALSE(comparison.rows());
    activities.comparison.choose("wire_feed_m_min=2.9", "wire feed 2.9 m/min instead of 3.6");
    session.compare({one, "one"}); // the comparison ends the lesson; it tries the chosen change
    CHECK(comparison.side(1).detail == "wire feed 2.9 m/min instead of 3.6");
    session.compare({one, "one"}, {two, "two"}); // the comparison ends the lesson
    CHECK_FALSE(session.running());
    CHECK(session.run().trainer() == nullptr);
}
