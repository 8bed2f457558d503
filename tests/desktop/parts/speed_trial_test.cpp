// Tests the offers on a machine that is too slow for an attempt for score.
#include "app/activities/speed_trial.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

Lesson plate() {
    Lesson lesson;
    lesson.model = LessonModel::Weld;
    lesson.workpiece.spacingMm = 0.5f;
    lesson.surface.cells = 96;
    return lesson;
}

/// Counts frames of 50 ms at this ratio until the trial changes its request.
SpeedTrial::Verdict measure(SpeedTrial& trial, double ratio) {
    SpeedTrial::Verdict verdict = SpeedTrial::Verdict::more;
    int frames = 0;
    while (verdict == SpeedTrial::Verdict::more) {
        // Frames during the compilation of shaders do not count.
        const bool settling = frames * 0.05 < SpeedTrial::kSettling - 0.06;
        verdict = trial.count(0.05, settling ? 0 : 0.05 * ratio);
        ++frames;
    }
    CHECK(frames * 0.05 < 2.5);
    return verdict;
}

} // namespace

TEST_CASE("a machine that keeps up is asked nothing") {
    SpeedTrial trial;
    trial.begin(plate());
    CHECK(trial.current().label.empty());
    CHECK(measure(trial, 0.97) == SpeedTrial::Verdict::fastEnough);
    CHECK_FALSE(trial.measuring());
    CHECK(trial.offers().empty());
}

TEST_CASE("one that is too slow is measured with fewer particles, a coarser surface and both") {
    SpeedTrial trial;
    trial.begin(plate());
    CHECK(measure(trial, 0.43) == SpeedTrial::Verdict::another);
    CHECK(trial.current().values == decltype(SpeedOffer::values){{"cells", "48"}});
    CHECK(measure(trial, 0.5) == SpeedTrial::Verdict::another);
    CHECK(trial.current().values == decltype(SpeedOffer::values){{"spacing_mm", "0.75"}});
    CHECK(measure(trial, 0.9) == SpeedTrial::Verdict::another);
    CHECK(trial.current().values.size() == 2);
    CHECK(measure(trial, 1.02) == SpeedTrial::Verdict::tooSlow);
    const Question question = trial.question();
    INFO(question.text);
    CHECK(question.text.find("43 % of real time") != std::string::npos);
    CHECK(question.text.find("a coarser surface (48 cells) and slightly coarser metal (0.75 mm)") != std::string::npos);
    REQUIRE(question.answers.size() == 3); // one way to the test
    REQUIRE(trial.fitting() != nullptr);
    CHECK(trial.fitting()->values.size() == 2);
}

TEST_CASE("the first change that keeps up is offered, and no other is measured or offered") {
    SpeedTrial trial;
    trial.begin(plate());
    measure(trial, 0.6);
    CHECK(measure(trial, 0.97) == SpeedTrial::Verdict::tooSlow);
    REQUIRE(trial.fitting() != nullptr);
    CHECK(trial.fitting()->values == decltype(SpeedOffer::values){{"cells", "48"}});
    CHECK(trial.question().answers.size() == 3);
}

TEST_CASE("a machine on which nothing keeps up is offered no test") {
    SpeedTrial trial;
    trial.begin(plate());
    for (int i = 0; i < 3; ++i)
        CHECK(measure(trial, 0.4) == SpeedTrial::Verdict::another);
    CHECK(measure(trial, 0.7) == SpeedTrial::Verdict::tooSlow);
    CHECK(trial.fitting() == nullptr);
    CHECK(trial.question().answers.size() == 2);
    CHECK(trial.question().text.find("too slow for a test of this lesson") != std::string::npos);
}

TEST_CASE("an offer of coarser particles says which sizes whole layers change") {
    Lesson lesson = plate();
    lesson.surface.cells = 16;
    lesson.workpiece.spacingMm = 1;
    lesson.workpiece.thicknessMm = 4;
    const auto offers = cheaperValues(lesson);
    REQUIRE(offers.size() == 1);
    CHECK(offers[0].label == "slightly coarser metal (1.5 mm; thickness 4.5 mm)");
    lesson.workpiece.thicknessMm = 6;
    CHECK(cheaperValues(lesson)[0].label == "slightly coarser metal (1.5 mm)");
}

TEST_CASE("an offer that the workpiece has no room for is left out") {
    SpeedTrial trial;
    trial.begin(plate());
    measure(trial, 0.4);
    CHECK(trial.skip() == SpeedTrial::Verdict::another);
    CHECK(trial.current().values.front().first == "spacing_mm");
    CHECK(trial.skip() == SpeedTrial::Verdict::another);
    CHECK(trial.skip() == SpeedTrial::Verdict::tooSlow);
    CHECK(trial.question().answers.size() == 2);
}

TEST_CASE("the classic lesson is offered fewer particles; nothing is offered where there is nothing left to save") {
    Lesson lesson;
    lesson.setup.particles = 8192;
    lesson.surface.cells = 16;
    const auto offers = cheaperValues(lesson);
    REQUIRE(offers.size() == 1);
    CHECK(offers[0].values == decltype(SpeedOffer::values){{"particles", "4096"}});
    lesson.setup.particles = 600;
    CHECK(cheaperValues(lesson).empty());
}

} // namespace meltpool
