// The judgement that window and headset share: when it is made, automatically and on request, and when it is discarded.
#include "app/session/lesson_session.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

class Welder {
  public:
    explicit Welder(Lesson lesson) : session(test::shaders(), std::move(lesson), [] { return 0.0; }) {
        session.begin(controls);
    }

    /// Leads the torch along the seam for `seconds`, 3 mm over the plate, at 8 mm/s while the trigger is pulled.
    void lead(double seconds, float trigger) {
        constexpr double kFrame = 1.0 / 45;
        for (double time = 0; time < seconds; time += kFrame) {
            session.advance(controls, kFrame, nullptr, [&](int, int steps) {
                if (trigger > 0) x_ += 8e-3f * static_cast<float>(kFrame / steps);
                TorchSample torch;
                torch.tip = {x_, 0.003f, 0};
                torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
                torch.trigger = trigger;
                return torch;
            });
        }
    }

    /// Runs one frame of `seconds` with the torch held still.
    void stall(double seconds, float trigger) {
        session.advance(controls, seconds, nullptr, [&](int, int) {
            TorchSample torch;
            torch.tip = {x_, 0.003f, 0};
            torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
            torch.trigger = trigger;
            return torch;
        });
    }

    Controls controls;
    LessonSession session;

  private:
    float x_ = -0.010f; ///< m
};

} // namespace

TEST_CASE("a weld whose end is not awaited is put out and judged at once; a short one is not", "[app]") {
    Welder welder(test::smallBead());
    const auto finish = [&] { return welder.session.attempt().finishWeld(*welder.session.run().trainer()); };
    welder.lead(0.5, 1);
    CHECK_FALSE(finish()); // some mm
    welder.lead(1.5, 1);
    REQUIRE(welder.session.run().arc().burns());
    CHECK(finish());
    CHECK_FALSE(welder.session.run().arc().burns());
    REQUIRE(welder.session.attempt().judged());
    CHECK(welder.session.attempt().judged()->judgement.verdict);
    CHECK_FALSE(finish());
}

TEST_CASE("a finished weld is judged by itself once, and welding on or another attempt drops the judgement", "[app]") {
    Welder welder(test::smallBead());
    CHECK(welder.session.judges());
    welder.lead(0.1, 0);
    CHECK_FALSE(welder.session.attempt().judged());
    welder.lead(2, 1);
    REQUIRE(welder.session.run().arc().burns());
    welder.session.judge(); // no judgement while the arc burns
    CHECK_FALSE(welder.session.attempt().judged());
    const auto waits = [&] { return welder.session.attempt().judging().waits(*welder.session.run().trainer()); };
    CHECK(waits());
    welder.lead(0.5, 0);
    CHECK_FALSE(welder.session.attempt().judged());
    CHECK(waits());
    welder.lead(1, 0);
    REQUIRE(welder.session.attempt().judged());
    CHECK_FALSE(waits());
    CHECK(welder.session.attempt().judgements() == 1);
    const JudgedAttempt& judged = *welder.session.attempt().judged();
    REQUIRE(judged.judgement.score);
    CHECK(judged.judgement.score->scored);
    CHECK(judged.rows.technique.rows.size() == judged.judgement.score->parameters.size());
    REQUIRE(judged.judgement.weld);
    CHECK(judged.judgement.weld->stations.size() >= 4);
    REQUIRE(judged.judgement.verdict);
    CHECK_THAT(judged.rows.verdict, test::containsText("ISO 5817, level C"));
    welder.lead(2, 0);
    CHECK(welder.session.attempt().judgements() == 1);

    SECTION("the arc burns again") {
        welder.lead(0.3, 1);
        REQUIRE(welder.session.run().arc().burns());
        CHECK_FALSE(welder.session.attempt().judged());
        welder.lead(1.2, 0);
        CHECK(welder.session.attempt().judgements() == 2); // covers the whole weld
    }
    SECTION("again") {
        welder.session.reset(welder.controls);
        CHECK_FALSE(welder.session.attempt().judged());
        welder.lead(1.5, 0);
        CHECK(welder.session.attempt().judgements() == 1); // nothing is welded yet
    }
    SECTION("the start menu") {
        welder.session.end("start menu");
        CHECK_FALSE(welder.session.attempt().judged());
        CHECK_FALSE(welder.session.judges());
        welder.session.judge();
        CHECK_FALSE(welder.session.attempt().judged());
    }
}

TEST_CASE("a short weld, and one of a lesson that asks for nothing, is judged on request only", "[app]") {
    Lesson lesson = test::smallBead();
    const bool asks = GENERATE(true, false);
    if (!asks) {
        lesson.technique.reset();
        lesson.acceptance.reset();
    }
    Welder welder(std::move(lesson));
    welder.lead(asks ? 0.8 : 2, 1);
    welder.lead(1.5, 0);
    CHECK_FALSE(welder.session.attempt().judged());
    welder.session.judge();
    REQUIRE(welder.session.attempt().judged());
    const JudgedAttempt& judged = *welder.session.attempt().judged();
    CHECK(judged.judgement.score.has_value() == asks);
    CHECK(judged.judgement.verdict.has_value() == asks);
    CHECK(judged.judgement.weld);
    welder.session.judge(); // a new request judges again
    CHECK(welder.session.attempt().judgements() == 2);
}

TEST_CASE("the classic lesson has nothing to judge", "[app]") {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = 1728;
    lesson.metal.supportRadius = 0.12f;
    lesson.surface.cells = 32;
    Welder welder(std::move(lesson));
    CHECK_FALSE(welder.session.judges());
    welder.session.judge();
    CHECK_FALSE(welder.session.attempt().judged());
}

TEST_CASE("an attempt in which the hand went unseen for a long frame under the arc is not scored", "[app]") {
    Welder welder(test::smallBead());
    welder.lead(0.1, 0);
    welder.stall(0.5, 0); // before the arc a stall costs no score
    welder.lead(0.9, 1);
    REQUIRE(welder.session.run().arc().burns());
    const bool stalls = GENERATE(false, true);
    if (stalls) welder.stall(0.5, 1);
    welder.lead(1, 1);
    welder.lead(1.5, 0);
    REQUIRE(welder.session.attempt().judged());
    REQUIRE(welder.session.attempt().judged()->judgement.score);
    CHECK(welder.session.attempt().judged()->judgement.score->scored == !stalls);
    CHECK((welder.session.attempt().judged()->judgement.score->unknownMm > 0) == stalls);
    if (stalls)
        CHECK_THAT(welder.session.attempt().judged()->judgement.score->reason,
                   test::containsText("too busy to see the torch at 1 moment") &&
                       test::containsText(" of 20 mm of the seam. From 5 % on"));
}
