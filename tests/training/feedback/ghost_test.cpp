// The ghost as figures: a path's pose at a place or time, and the exact distance of a hand from it.
#include "core/training/feedback/ghost.hpp"

#include "core/base/text.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/judging/synthetic_weld.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace meltpool;
using test::Hand;

namespace {

constexpr double kPeriod = 0.02; // s between rows of a path

/// Returns a recorded path of `seconds`, with the trigger pulled where the hand's arc burns.
TorchPath pathOf(const Seam& seam, double seconds, const std::function<Hand(double)>& hand) {
    std::vector<TorchSample> samples;
    for (int i = 0; i <= static_cast<int>(std::lround(seconds / kPeriod)); ++i) {
        const Hand now = hand(i * kPeriod);
        samples.push_back(test::torchOf(seam, i * kPeriod, now));
        samples.back().trigger = now.burns ? 1.0F : 0.0F;
    }
    return TorchPath(std::move(samples));
}

/// Returns a hand that rests a second at -30 mm, then welds for 10 s at 4 mm/s, to +10 mm, and rests again.
Hand expert(double time) {
    Hand hand;
    hand.workDeg = 10;
    hand.travelDeg = -15;
    hand.aimMm = 0.5;
    hand.burns = time >= 1 && time <= 11;
    hand.placeMm = -30 + 4 * std::clamp(time - 1, 0.0, 10.0);
    return hand;
}

GhostPath expertGhost() {
    const Seam seam = test::plateSeam();
    return GhostPath(pathOf(seam, 12, expert), seam);
}

} // namespace

TEST_CASE("by place the ghost stands exactly where its path came by there, at its own speed and angles", "[training]") {
    const GhostPath ghost = expertGhost();
    REQUIRE_FALSE(ghost.empty());
    CHECK(ghost.direction() == 1);
    CHECK(ghost.duration() == Approx(10).margin(0.02));
    for (const double mm : {-29.9, -20.0, -7.3, 0.0, 9.9}) {
        INFO(mm);
        const auto moment = ghost.atPlace(mm * 1e-3);
        REQUIRE(moment);
        CHECK(moment->place * 1e3 == Approx(mm).margin(1e-3));
        CHECK(moment->torch.time == Approx(1 + (mm + 30) / 4).margin(1e-3));
        const TorchSample exact = test::torchOf(test::plateSeam(), 0, expert(1 + (mm + 30) / 4));
        CHECK(glm::distance(moment->torch.tip, exact.tip) < 2e-6F);
        CHECK(glm::dot(moment->torch.axis(), exact.axis()) > 0.999999F);
        CHECK(glm::degrees(moment->workAngle) == Approx(10).margin(0.01));
        CHECK(glm::degrees(moment->travelAngle) == Approx(-15).margin(0.3)); // a lean precedes the projection
        if (mm > -28) CHECK(moment->speed * 1e3 == Approx(4).margin(0.01));
    }
    // Beyond the ends there is no ghost.
    CHECK_FALSE(ghost.atPlace(-30.5e-3));
    CHECK_FALSE(ghost.atPlace(10.5e-3));
    CHECK_FALSE(ghost.atPlace(std::nan("")));
}

TEST_CASE("by time the ghost waits where it struck, goes its own way, and is gone when it let go", "[training]") {
    const GhostPath ghost = expertGhost();
    REQUIRE(ghost.atTime(-5));
    CHECK(ghost.atTime(-5)->place * 1e3 == Approx(-30).margin(0.1));
    CHECK(ghost.atTime(0)->torch.time == Approx(1).margin(0.011));
    const double start = ghost.atTime(0)->torch.time;
    REQUIRE(ghost.atTime(5));
    CHECK(ghost.atTime(5)->torch.time == Approx(start + 5).margin(1e-9));
    CHECK(ghost.atTime(5)->place * 1e3 == Approx(-30 + 4 * (start + 4)).margin(1e-3));
    CHECK(ghost.atTime(ghost.duration()));
    CHECK_FALSE(ghost.atTime(ghost.duration() + 0.1));
}

TEST_CASE("the delta is the hand's less the ghost's, and told in words", "[training]") {
    const Seam seam = test::plateSeam();
    const GhostPath ghost = expertGhost();
    Hand hand;
    hand.workDeg = 4;
    hand.travelDeg = 0;
    // Another speed: 6 mm/s, now at 0 mm.
    const Technique technique = test::weldWith(seam, 2, [=](double time) {
        Hand now = hand;
        now.placeMm = -12 + 6 * time;
        return now;
    });
    const auto there = ghost.atPlace(technique.place());
    REQUIRE(there);
    const GhostDelta delta = ghostDelta(technique, 1, *there, ghost);
    CHECK(delta.speed * 1e3 == Approx(2).margin(0.01));
    CHECK(glm::degrees(delta.workAngle) == Approx(-6).margin(0.01));
    CHECK(glm::degrees(delta.travelAngle) == Approx(15).margin(0.3));
    CHECK(delta.ahead * 1e3 == Approx(0).margin(1e-3));
    const GhostWords words(delta, GhostPace::place);
    REQUIRE(words.lines() == 3);
    CHECK(words.line(0) == "2.0 mm/s faster");
    CHECK(words.line(1) == "work angle 6\xC2\xB0 less");
    CHECK(words.line(2) == "travel angle 15\xC2\xB0 more");

    const auto then = ghost.atTime(5);
    const GhostDelta late = ghostDelta(technique, 1, *then, ghost);
    CHECK(late.ahead * 1e3 == Approx(-then->place * 1e3).margin(1e-3));
    const GhostWords timed(late, GhostPace::time);
    REQUIRE(timed.lines() == 4);
    CHECK(timed.line(3) == "10 mm ahead");

    // Unknown values have no line, such as the travel angle before the direction is known.
    CHECK(std::isnan(ghostDelta(technique, 0, *there, ghost).travelAngle));
    CHECK(GhostWords(ghostDelta(technique, 0, *there, ghost), GhostPace::place).lines() == 2);
    CHECK(GhostWords({0.00004, 0.008, -0.008, 0.0004}, GhostPace::time).lines() == 0);
}

TEST_CASE("a path that travels backwards is met the other way round", "[training]") {
    const Seam seam = test::plateSeam();
    const GhostPath ghost(pathOf(seam, 6,
                                 [](double time) {
                                     Hand hand;
                                     hand.direction = -1;
                                     hand.travelDeg = 12;
                                     hand.placeMm = 20 - 5 * time;
                                     return hand;
                                 }),
                          seam);
    CHECK(ghost.direction() == -1);
    const auto moment = ghost.atPlace(5e-3);
    REQUIRE(moment);
    CHECK(moment->torch.time == Approx(3).margin(1e-3));
    CHECK(moment->speed * 1e3 == Approx(5).margin(0.01));
    CHECK(glm::degrees(moment->travelAngle) == Approx(12).margin(0.1));
    CHECK_FALSE(ghost.atPlace(21e-3));
    CHECK_FALSE(ghost.atPlace(-11e-3));
}

TEST_CASE("strokes back are left out, and where the ghost went on without an arc there is none", "[training]") {
    const Seam seam = test::plateSeam();
    // The path whips: 1 s forward at 6 mm/s, 0.5 s back at 4 mm/s. After 6 s it continues by 10 mm with the trigger
    // released.
    const GhostPath whip(pathOf(seam, 12,
                                [](double time) {
                                    Hand hand;
                                    const double t = std::min(time, 6.0), period = std::floor(t / 1.5);
                                    const double in = t - 1.5 * period;
                                    hand.placeMm = -30 + 4 * period + (in < 1 ? 6 * in : 6 - 4 * (in - 1));
                                    if (time > 6) hand.placeMm = -14 + std::min((time - 6) * 10, 10.0);
                                    if (time > 8) hand.placeMm = -4 + 4 * (time - 8);
                                    hand.burns = time <= 6 || time > 8;
                                    return hand;
                                }),
                         seam);
    double last = -1;
    for (double mm = -29.9; mm < -12.1; mm += 0.05) {
        const auto moment = whip.atPlace(mm * 1e-3);
        INFO(mm);
        REQUIRE(moment);
        CHECK(moment->place * 1e3 == Approx(mm).margin(0.05));
        CHECK(moment->torch.time >= last);
        last = moment->torch.time;
    }
    CHECK_FALSE(whip.atPlace(-8e-3)); // the torch passed this place without an arc
    CHECK(whip.atPlace(2e-3));
}

TEST_CASE("around a pipe a ghost is met at its place, whichever turn the hand counts", "[training]") {
    WorkpieceParameters pipe;
    pipe.kind = static_cast<int>(WorkpieceKind::Pipe);
    const Seam seam = seamOf(pipe);
    const double turn = seam.length() * 1e3; // mm
    // The path goes from a tenth of a turn before the top to a tenth behind it.
    const GhostPath ghost(pathOf(seam, 10,
                                 [=](double time) {
                                     Hand hand;
                                     hand.placeMm = turn * (0.9 + 0.02 * time);
                                     return hand;
                                 }),
                          seam);
    REQUIRE(ghost.direction() == 1);
    for (const double turns : {-0.05, 0.95, 1.95}) {
        const auto moment = ghost.atPlace(turns * seam.length());
        REQUIRE(moment);
        CHECK(moment->torch.time == Approx(2.5).margin(0.01));
    }
    CHECK(ghost.atPlace(0.05 * seam.length())->torch.time == Approx(7.5).margin(0.01));
    CHECK_FALSE(ghost.atPlace(0.5 * seam.length()));
}

TEST_CASE("a path that never welds is no ghost", "[training]") {
    const Seam seam = test::plateSeam();
    CHECK(GhostPath().empty());
    CHECK_FALSE(GhostPath().atPlace(0));
    CHECK_FALSE(GhostPath().atTime(0));
    CHECK(GhostPath(TorchPath(), seam).empty());
    CHECK(GhostPath(pathOf(seam, 1,
                           [](double) {
                               Hand hand;
                               hand.burns = false;
                               return hand;
                           }),
                    seam)
              .empty());
}

TEST_CASE("help that shows all at once fades with what is mastered least of what the lesson judges", "[training]") {
    TechniqueBands bands;
    bands.bands = {{TechniqueQuantity::travelSpeed, 5, 1, 3}, {TechniqueQuantity::workAngle, 0, 5, 15}};
    CueSkill skill;
    CHECK(skill.strength(&bands) == 1);
    skill.setGood(TechniqueQuantity::travelSpeed, CueSkill::kMastered);
    CHECK(skill.strength(&bands) == 1);
    skill.setGood(TechniqueQuantity::workAngle, 1);
    CHECK(skill.strength(&bands) == 0.75);
    skill.setGood(TechniqueQuantity::workAngle, CueSkill::kMastered);
    CHECK(skill.strength(&bands) == 0); // the lesson does not judge the aim, so it has no effect
    CHECK(skill.strength(static_cast<const TechniqueBands*>(nullptr)) == 1);
}

TEST_CASE("a lesson says whether it allows a ghost", "[training]") {
    const auto file = test::scratchFolder("ghost") / "lesson.toml";
    const auto allowedBy = [&](const std::string& cues) {
        writeTextFileAtomically(file, "model = \"weld\"\n" + cues);
        return readLesson(file).ghost;
    };
    CHECK(allowedBy(""));
    CHECK(allowedBy("[cues]\nallowed = [\"aim\"]\n"));
    CHECK_FALSE(allowedBy("[cues]\nallowed = []\n"));
    CHECK(allowedBy("[cues]\nallowed = []\nghost = true\n"));
    CHECK_FALSE(allowedBy("[cues]\nghost = false\n"));
}
