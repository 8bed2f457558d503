// The score of a technique: a perfect path, bent ones, missing weld, and welds that cannot be scored.
#include "core/training/judging/score.hpp"

#include "core/base/error.hpp"
#include "core/base/toml_table.hpp"
#include "core/gl/state_archive.hpp"
#include "core/weld/process/processes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/judging/synthetic_weld.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

using namespace meltpool;
using namespace meltpool::test;
using enum TechniqueQuantity;

namespace {

/// Returns a lesson's targets: 80 mm at 5.5 mm/s.
TechniqueBands lessonBands() {
    TechniqueBands bands;
    bands.lengthFromMm = -40;
    bands.lengthToMm = 40;
    bands.bands = {{aim, 0, 1, 3, 1},
                   {distance, 15, 2, 6, 1},
                   {workAngle, 0, 5, 15, 1},
                   {travelAngle, 10, 5, 15, 1},
                   {travelSpeed, 5.5, 0.8, 2.5, 2}};
    return bands;
}

/// A path within all of lessonBands(), with one bend at a time.
struct Bend {
    double timeScale = 1; ///< time scale of the whole path
    double farther = 0;   ///< longer arc, mm
    double turned = 0;    ///< rotation about the seam, degrees
    double beside = 0;    ///< offset from the seam, mm
    double tilted = 0;    ///< extra push, degrees
};

constexpr double kSpeed = 5.5;

Technique bentWeld(const Bend& bend, double fromMm = -42, double toMm = 42) {
    const double seconds = (toMm - fromMm) / kSpeed * bend.timeScale;
    return weldWith(plateSeam(), seconds, [&](double time) {
        Hand hand;
        hand.placeMm = fromMm + kSpeed * time / bend.timeScale;
        hand.aimMm = bend.beside;
        hand.workDeg = bend.turned;
        hand.travelDeg = 10 + bend.tilted;
        hand.distanceMm = 15 + bend.farther;
        hand.tipHeightMm = 2 + bend.farther;
        return hand;
    });
}

TechniqueScore scoreOf(const Technique& technique, const TechniqueBands& bands = lessonBands()) {
    return scoreTechnique(technique.faults(), alongSeam(technique), unknownPlaces(technique), bands);
}

/// Returns the parameter with the lowest score; expects a single lowest one.
TechniqueQuantity lowestOf(const TechniqueScore& score) {
    ParameterScore lowest = score.parameters[0];
    for (const ParameterScore& each : score.parameters)
        if (each.score < lowest.score) lowest = each;
    int others = 0;
    for (const ParameterScore& each : score.parameters)
        others += each.score <= lowest.score ? 1 : 0;
    CHECK(others == 1);
    return lowest.quantity;
}

} // namespace

TEST_CASE("points are full inside the inner band and fall to nothing at the outer one", "[training][technique]") {
    const TechniqueBand band{travelSpeed, 5.5, 0.8, 2.5, 1};
    CHECK(band.points(5.5) == 100);
    CHECK(band.points(6.2) == 100);
    CHECK(band.points(4.8) == 100);
    CHECK(band.points(5.5 + 0.8 + 0.85) == Approx(50));
    CHECK(band.points(5.5 - 0.8 - 0.425) == Approx(75));
    CHECK(band.points(8) == 0);
    CHECK(band.points(-30) == 0);
    CHECK(band.points(std::nan("")) == 0);
    CHECK(TechniqueBand{aim, 0, 2, 2, 1}.points(2) == 100); // no slope between the limits
    CHECK(TechniqueBand{aim, 0, 2, 2, 1}.points(2.1) == 0);
}

TEST_CASE("a perfect path has 100 and nothing to correct", "[training][technique]") {
    const TechniqueScore score = scoreOf(bentWeld({}));
    CHECK(score.scored);
    CHECK(score.reason.empty());
    CHECK(score.total == 100);
    CHECK(score.coverage == 1);
    CHECK(score.wantedMm == 80);
    CHECK(score.weldedMm == 80);
    CHECK(score.judgedMm > 75);
    for (const ParameterScore& each : score.parameters)
        CHECK(each.score == 100);
    CHECK(corrections(score, lessonBands()).empty());
    // A hand that reaches only within 2 mm of the ends has welded the whole seam.
    CHECK(scoreOf(bentWeld({}, -38.5, 38.5)).total == 100);
}

TEST_CASE("an aim beside the joint line is scored and told against the line that the lesson asks for") {
    TechniqueBands bands = lessonBands();
    bands.bands[0].ideal = -0.5;
    const auto scored = [&](double beside) { return scoreOf(bentWeld({1, 0, 0, beside, 0}), bands); };
    CHECK(scored(-0.5).total == 100);
    CHECK(scored(0.5).find(aim)->score == 100);
    CHECK(scored(-1.4).find(aim)->score == 100);
    CHECK(scored(1.5).find(aim)->score == Approx(50));
    const auto told = corrections(scored(1.5), bands);
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0].sentence, test::containsText("2 mm off the lesson's line, on your side."));
    bands.tee = true;
    CHECK(corrections(scored(1.5), bands).at(0).sentence ==
          "Aim nearer the upright plate: 2 mm too far out on the base plate.");
    CHECK(corrections(scored(-2.5), bands).at(0).sentence ==
          "Aim nearer the base plate: 2 mm too far up the upright plate.");
}

TEST_CASE("a bent path is marked down, and its own parameter is the lowest", "[training][technique]") {
    struct Case {
        const char* what;
        Bend bend;
        TechniqueQuantity own;
        const char* sentence;
    };
    const Case cases[]{
        {"0.55 of its time", {0.55, 0, 0, 0, 0}, travelSpeed, "Travel slower: 10 mm/s, target 5.5."},
        {"slow", {2, 0, 0, 0, 0}, travelSpeed, "Travel faster: 2.8 mm/s, target 5.5."},
        {"7 mm off", {1, 7, 0, 0, 0}, distance, "Hold the torch closer: 22 mm from tip to work, target 15."},
        {"turned", {1, 0, 28, 0, 0}, workAngle, "Lean the torch less towards you: 28°, target 0°."},
        {"beside", {1, 0, 0, 4, 0}, aim, "Aim farther away from you: 4 mm off, on your side."},
        {"dragged", {1, 0, 0, 0, -25}, travelAngle, "Push more: -15°, target 10°"}};
    for (const Case& each : cases) {
        INFO(each.what);
        const TechniqueScore score = scoreOf(bentWeld(each.bend));
        CHECK(score.scored);
        CHECK(score.total < 50);
        CHECK(lowestOf(score) == each.own);
        CHECK(score.find(each.own)->score == 0);
        for (const ParameterScore& other : score.parameters)
            if (other.quantity != each.own) CHECK(other.score == 100);
        const auto told = corrections(score, lessonBands());
        REQUIRE(told.size() == 1);
        CHECK(told[0].quantity == each.own);
        CHECK_THAT(told[0].sentence, test::containsText(each.sentence));
        CHECK(told[0].lost == Approx(100 - score.total));
    }
    const TechniqueScore fast = scoreOf(bentWeld({0.55, 0, 0, 0, 0}));
    CHECK(fast.find(travelSpeed)->mean == Approx(10).margin(0.1));
    CHECK(fast.find(travelSpeed)->deviation == Approx(4.5).margin(0.1));
    CHECK(fast.total == Approx(100 - 50 - 50 * 2.0 / 6)); // half by the lowest, half by weight
}

TEST_CASE("a path bent further never scores more", "[training][technique]") {
    const auto falls = [](const char* what, auto bendBy, TechniqueQuantity own) {
        double last = 100, first = 0, lastOwn = 100;
        for (int i = 0; i <= 8; ++i) {
            const TechniqueScore score = scoreOf(bentWeld(bendBy(i / 8.0)));
            INFO(what << " " << i << ": " << score.total);
            if (i == 0) first = score.total;
            CHECK(score.total <= last);
            CHECK(score.find(own)->score <= lastOwn);
            last = score.total;
            lastOwn = score.find(own)->score;
        }
        CHECK(first == 100);
        CHECK(lastOwn == 0);
    };
    falls(
        "fast",
        [](double by) {
            return Bend{1 - 0.45 * by, 0, 0, 0, 0};
        },
        travelSpeed);
    falls(
        "farther",
        [](double by) {
            return Bend{1, 7 * by, 0, 0, 0};
        },
        distance);
    falls(
        "turned",
        [](double by) {
            return Bend{1, 0, 28 * by, 0, 0};
        },
        workAngle);
    falls(
        "beside",
        [](double by) {
            return Bend{1, 0, 0, -4 * by, 0};
        },
        aim);
    falls(
        "pushed",
        [](double by) {
            return Bend{1, 0, 0, 0, 20 * by};
        },
        travelAngle);
}

TEST_CASE("every millimetre counts the same, however long the torch stayed there", "[training][technique]") {
    // Half of the seam has a wrong work angle and four times the speed of the other half.
    TechniqueBands bands = lessonBands();
    bands.bands = {{workAngle, 0, 5, 15, 1}};
    for (const double other : {1.0, 4.0}) {
        const Technique technique = weldWith(plateSeam(), 42 / 4.0 + 42 / (4 * other), [&](double time) {
            Hand hand;
            const bool second = time > 42 / 4.0;
            hand.placeMm = second ? 4 * other * (time - 42 / 4.0) : -42 + 4 * time;
            hand.workDeg = second ? 20 : 0;
            return hand;
        });
        CHECK(scoreOf(technique, bands).total == Approx(50).margin(1));
    }
}

TEST_CASE("a half weld has half of the points at most, and a hole costs its length", "[training][technique]") {
    const TechniqueScore half = scoreOf(bentWeld({}, -42, 0));
    CHECK(half.scored);
    CHECK(half.weldedMm == 40);
    CHECK(half.coverage == Approx(40.0 / 76));
    CHECK(half.total == Approx(100 * 40.0 / 76));
    const auto told = corrections(half, lessonBands());
    REQUIRE(told.size() == 1);
    CHECK_FALSE(told[0].quantity);
    CHECK(told[0].sentence == "Weld the whole seam: 40 of 80 mm are welded.");
    CHECK(told[0].lost + half.total == Approx(100));
    const Technique holed = weldWith(plateSeam(), 84 / kSpeed, [&](double time) {
        Hand hand;
        hand.placeMm = -42 + kSpeed * time;
        hand.travelDeg = 10;
        hand.distanceMm = 15;
        hand.burns = hand.placeMm < -10 || hand.placeMm > 10;
        return hand;
    });
    CHECK(scoreOf(holed).total == Approx(100 * 60.0 / 76).margin(2));
    // Losses add up to the points missing from 100.
    const TechniqueScore both = scoreOf(bentWeld({1, 5, 0, 0, 0}, -42, 0));
    double lost = both.lostToLength;
    for (const ParameterScore& each : both.parameters)
        lost += each.lost;
    CHECK(lost + both.total == Approx(100));
    CHECK(both.find(distance)->score == Approx(25));
}

TEST_CASE("strike and crater are not judged", "[training][technique]") {
    // Two seconds form the pool, badly held, and one fills the crater; two flashes precede them.
    const double weld = 84 / kSpeed;
    const auto hand = [&](double time) {
        Hand now;
        now.travelDeg = 10;
        now.distanceMm = 15;
        now.burns = time < 0.1 || (time >= 0.4 && time < 0.6) || time >= 1;
        const double travelled = std::clamp(time - 3, 0.0, weld);
        now.placeMm = -40.5 + 81 * travelled / weld;
        if (time < 3) now.workDeg = 40;
        return now;
    };
    const TechniqueScore score = scoreOf(weldWith(plateSeam(), 3 + weld + 1, hand));
    CHECK(score.scored);
    CHECK(score.total == Approx(100).margin(0.5));
    CHECK(score.weldedMm == 80);
    CHECK(score.judgedMm < 77);
}

TEST_CASE("a slow frame leaves out its millimetres; from 5 % of the seam on there is no score",
          "[training][technique]") {
    const auto weld = [](const std::vector<double>& slow, double seconds = 0.25) {
        Technique technique(plateSeam());
        size_t next = 0;
        for (int i = 0; i * kTimeStep < 84 / kSpeed; ++i) {
            const double time = i * kTimeStep;
            if (next < slow.size() && time >= slow[next]) {
                technique.noteDropped(seconds);
                ++next;
            }
            Hand hand;
            hand.placeMm = -42 + kSpeed * time;
            hand.travelDeg = 10;
            hand.distanceMm = 15;
            // The guessed poses are wrong.
            if (next > 0 && time < slow[next - 1] + seconds - kTimeStep) hand.workDeg = 40;
            technique.add(torchOf(plateSeam(), time, hand), arcOf(hand));
        }
        return technique;
    };
    const Technique once = weld({5.02});
    const TechniqueScore score = scoreOf(once);
    CHECK(score.scored);
    CHECK(score.total == 100);
    CHECK(score.coverage == 1);
    CHECK(score.unknownMm >= 2);
    CHECK(score.unknownMm <= 3);
    CHECK(score.weldedMm == 80 - score.unknownMm);
    CHECK_THAT(unknownSentence(score), test::containsText(" of the seam do not count: "));
    int left = 0;
    for (const SeamMillimetre& mm : alongSeam(once)) {
        left += mm.known ? 0 : 1;
        if (!mm.known) CHECK((!mm.judged && std::isnan(mm.values[workAngle]) && mm.seconds > 0));
    }
    CHECK(left == score.unknownMm);
    CHECK_THAT(techniqueCsv(alongSeam(once), DistanceKind::ctwd), test::containsText(",0,0,1,,,"));
    const TechniqueScore three = scoreOf(weld({3, 6, 9}));
    CHECK_FALSE(three.scored);
    CHECK(three.total == 0);
    CHECK_THAT(three.reason, test::containsText("The computer was too busy to see the torch at 3 moments while the arc "
                                                "burned. The hand is not known on ") &&
                                 test::containsText(" of 80 mm of the seam. From 5 % on"));
    // Beyond the required seam no millimetre is lost, and a stationary hand loses one.
    CHECK(scoreOf(weld({0.02, 0.1}, 0.1)).unknownMm == 0);
    CHECK(unknownSentence(scoreOf(bentWeld({}))).empty());
    // The frame's time is in records as text; older records lack it.
    CHECK(droppedSeconds(droppedText(0.2)) == 0.2);
    CHECK(droppedSeconds("dropped") == kLongestGuess);
    CHECK(droppedSeconds("dropped 1e9") == kLongestGuess);
    CHECK(droppedSeconds("dropped x") == kLongestGuess);
}

TEST_CASE("what was left out of the hand is the same after a state was saved and restored", "[training][technique]") {
    test::context(); // restoring waits for shaders
    Technique technique = bentWeld({}, -42, 0);
    technique.noteDropped(0.05);
    Hand hand;
    for (int i = 1; i <= 100; ++i) {
        hand.placeMm = i * kTimeStep * kSpeed;
        technique.add(torchOf(plateSeam(), technique.steps().back().time + kTimeStep, hand), arcOf(hand));
    }
    std::vector<std::byte> bytes;
    gl::StateArchive saving(bytes);
    technique.transferSteps(saving, 0, technique.steps().size());
    CHECK(bytes.size() == technique.steps().size() * kTechniqueStepBytes);
    Technique again(plateSeam());
    gl::StateArchive restoring{std::span<const std::byte>(bytes)};
    again.transferSteps(restoring, 0, technique.steps().size());
    REQUIRE_FALSE(unknownPlaces(technique).empty());
    CHECK(unknownPlaces(again) == unknownPlaces(technique));
}

TEST_CASE("an attempt that was not seen whole has no score, and says why", "[training][technique]") {
    const auto weld = [](auto change) {
        return scoreOf(weldWith(plateSeam(), 84 / kSpeed, [&](double time) {
            Hand hand;
            hand.placeMm = -42 + kSpeed * time;
            hand.travelDeg = 10;
            hand.distanceMm = 15;
            change(hand, time);
            return hand;
        }));
    };
    const TechniqueScore lost = weld([](Hand& hand, double time) { hand.tracked = time < 5 || time >= 5.75; });
    CHECK_FALSE(lost.scored);
    CHECK(lost.total == 0);
    CHECK_THAT(lost.reason, test::containsText("Tracking of the torch was lost for 0.75 s") &&
                                test::containsText(" of 80 mm of the seam. From 5 % on"));
    CHECK(corrections(lost, lessonBands()).empty());
    // The arc went out with the tracking: it burned when the torch was lost.
    CHECK_FALSE(weld([](Hand& hand, double time) { hand.tracked = hand.burns = time < 5 || time >= 5.75; }).scored);
    // A short loss of tracking costs its millimetres only; they count neither as welded nor as missing.
    const TechniqueScore moment = weld([](Hand& hand, double time) { hand.tracked = time < 5 || time >= 5.25; });
    CHECK(moment.total == 100);
    CHECK(moment.unknownMm >= 1);
    CHECK(moment.unknownMm <= 3);
    CHECK(moment.weldedMm == 80 - moment.unknownMm);
    // Before the strike the torch need not be tracked.
    CHECK(weld([](Hand& hand, double time) { hand.tracked = hand.burns = time >= 0.2; }).scored);
    const TechniqueScore never = weld([](Hand& hand, double) { hand.burns = false; });
    CHECK_FALSE(never.scored);
    CHECK(never.reason == "The arc was never lit, so there is nothing to score.");
    const TechniqueScore flash = weld([](Hand& hand, double time) { hand.burns = time > 5 && time < 5.9; });
    CHECK_FALSE(flash.scored);
    CHECK_THAT(flash.reason, test::containsText("too short to score"));
}

TEST_CASE("a demanded direction makes the other way's speed wrong", "[training][technique]") {
    const Technique technique = weldWith(plateSeam(), 84 / kSpeed, [&](double time) {
        Hand hand;
        hand.direction = -1;
        hand.placeMm = 42 - kSpeed * time;
        hand.travelDeg = 10;
        hand.distanceMm = 15;
        return hand;
    });
    TechniqueBands bands = lessonBands();
    CHECK(scoreOf(technique, bands).total == 100);
    bands.direction = TravelDirection::backward;
    CHECK(scoreOf(technique, bands).total == 100);
    bands.direction = TravelDirection::forward;
    CHECK(scoreOf(technique, bands).find(travelSpeed)->score == 0);
    CHECK(scoreOf(technique, bands).find(travelSpeed)->mean == Approx(-kSpeed).margin(0.02));
    const auto told = corrections(scoreOf(technique, bands), bands);
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0].sentence, test::containsText("Weld in the other direction: the torch went the wrong way"));
}

TEST_CASE("a difference that reads as inside the tolerance is never the advice", "[training][technique]") {
    const TechniqueBands bands = lessonBands();
    const auto advice = [&](double speed) {
        return corrections(scoreOf(bentWeld({kSpeed / speed, 0, 0, 0, 0})), bands);
    };
    CHECK(advice(6.2).empty()); // inside 5.5 ± 0.8
    const TechniqueScore over = scoreOf(bentWeld({kSpeed / 6.34, 0, 0, 0, 0}));
    CHECK(over.find(travelSpeed)->lost > 0.5);
    CHECK(corrections(over, bands).empty()); // reads as 6.3, which is 5.5 + 0.8
    REQUIRE(advice(6.5).size() == 1);
    CHECK(advice(6.5)[0].sentence == "Travel slower: 6.5 mm/s, target 5.5.");
    CHECK(advice(4.5)[0].sentence == "Travel faster: 4.5 mm/s, target 5.5.");

    const TechniqueBand band{travelSpeed, 6.5, 0.6, 2, 1};
    CHECK_FALSE(band.readsBeyond(6.7));
    CHECK_FALSE(band.readsBeyond(7.14));
    CHECK(band.readsBeyond(7.16));
    CHECK(band.readsBeyond(5.84));
    CHECK_FALSE(
        TechniqueBand{travelSpeed, 6.54, 0.54, 2, 1}.readsBeyond(7.06)); // reads 7.1 and 6.5 ± 0.5, and is inside
}

TEST_CASE("corrections are the costliest first, three of them, and name unevenness", "[training][technique]") {
    const Technique technique = weldWith(plateSeam(), 84 / kSpeed, [&](double time) {
        Hand hand;
        hand.placeMm = -42 + kSpeed * time;
        hand.travelDeg = 10 + 11;
        hand.distanceMm = 15 - 3.5;
        hand.workDeg = hand.placeMm < 0 ? 12 : -12;
        hand.aimMm = 1.5;
        return hand;
    });
    TechniqueBands bands = lessonBands();
    const auto told = corrections(scoreOf(technique, bands), bands);
    REQUIRE(told.size() == 3);
    CHECK(told[0].quantity == workAngle);
    CHECK(told[0].sentence == "Keep the work angle even: it went from -12° to 12°, target 0°.");
    CHECK(told[1].quantity == travelAngle);
    CHECK_THAT(told[1].sentence, test::containsText("Push less: 21°, target 10°."));
    CHECK(told[2].quantity == distance);
    CHECK_THAT(told[2].sentence, test::containsText("Hold the torch farther away"));
    bands.bands[0].weight = 100; // half of the score depends on the lowest parameter
    CHECK(corrections(scoreOf(technique, bands), bands)[0].quantity == workAngle);
    CHECK(corrections(scoreOf(technique, bands), bands)[1].quantity == aim);
    CHECK(corrections(scoreOf(technique, bands), bands, 1).size() == 1);
}

namespace {

TechniqueBands readBands(const std::string& text, DistanceKind distance_ = DistanceKind::ctwd) {
    const toml::table parsed = parseToml(text, "lesson.toml");
    TomlTable root(parsed, "lesson.toml");
    TomlTable table = root.table("technique");
    return readTechniqueBands(table, distance_, plateSeam());
}

} // namespace

TEST_CASE("a lesson's bands are read", "[training][technique]") {
    const TechniqueBands bands = readBands(R"([technique]
length_from_mm = -50
length_to_mm = 50
direction = "backward"
speed_window_s = 1.5
aim = { ideal = 0, inner = 1, outer = 3 }
travel_angle = { ideal = -10, inner = 5, outer = 15, weight = 0.5 }
arc_length = { ideal = 3, inner = 1, outer = 3, weight = 2 }
whip_length = { ideal = 6, inner = 1, outer = 3, weight = 2 }
)",
                                           DistanceKind::arcLength);
    CHECK(bands.distance == DistanceKind::arcLength);
    CHECK(bands.lengthFromMm == -50);
    CHECK(bands.lengthToMm == 50);
    CHECK(bands.direction == TravelDirection::backward);
    CHECK(bands.settings().speedWindow == 1.5);
    REQUIRE(bands.bands.size() == 4);
    CHECK(bands.find(aim)->weight == 1);
    CHECK(bands.find(travelAngle)->ideal == -10);
    CHECK(bands.find(travelAngle)->weight == 0.5);
    CHECK(bands.find(distance)->outer == 3);
    CHECK(bands.find(whipLength) != nullptr);
    CHECK(bands.find(travelSpeed) == nullptr);
}

TEST_CASE("faults of a lesson's bands are told with file, line and key", "[training][technique]") {
    const std::string head = "[technique]\nlength_from_mm = -40\nlength_to_mm = 40\n";
    const auto told = [&](const std::string& text) -> std::string {
        try {
            readBands(text);
        } catch (const InputError& fault) {
            return fault.what();
        }
        return "";
    };
    const auto checkTold = [&](const std::string& text, const std::string& words) {
        INFO(text);
        CHECK_THAT(told(text), test::containsText(words));
    };
    const std::string good = "aim = { ideal = 0, inner = 1, outer = 3 }\n";
    CHECK(told(head + good) == "");
    checkTold(head + good + "speed = { ideal = 1 }\n", "lesson.toml:5: [technique] speed: unknown key; did you mean");
    checkTold(head + "aim = { ideal = 0, inner = 2, outer = 1 }\n",
              "lesson.toml:4: [technique.aim] outer: is below inner; expected at least 2");
    checkTold(head + "aim = { ideal = 0, inner = 0, outer = 0 }\n", "[technique.aim] outer: is 0");
    checkTold(head + "aim = { ideal = 0, inner = -1, outer = 1 }\n", "[technique.aim] inner: expected a number from 0");
    checkTold(head + "aim = { ideal = 0, inner = 1, outer = 2, weight = -1 }\n", "weight: expected a number from 0");
    checkTold(head + "aim = { ideal = 0, inner = 1, outer = 2, width = 1 }\n", "[technique.aim] width: unknown key");
    checkTold(head + "aim = { inner = 1, outer = 2 }\n", "[technique.aim] ideal: is missing");
    checkTold(head + "aim = 3\n", "lesson.toml:4: [technique] aim: expected a table");
    checkTold(head + "work_angle = { ideal = 100, inner = 1, outer = 2 }\n", "ideal: expected a number from -90 to 90");
    checkTold(head + "arc_length = { ideal = 3, inner = 1, outer = 2 }\n",
              "arc_length: is not measured with this lesson's process; expected ctwd");
    checkTold(head + "direction = \"up\"\n" + good, "direction: is 'up'; expected one of either, forward, backward");
    checkTold(head, "judges nothing");
    checkTold(head + "aim = { ideal = 0, inner = 1, outer = 2, weight = 0 }\n", "judges nothing");
    checkTold("[technique]\nlength_from_mm = -40\n" + good, "length_to_mm: is missing");
    checkTold("[technique]\nlength_from_mm = -60\nlength_to_mm = 4\n",
              "length_from_mm: expected a number from -50 to 50");
    checkTold("[technique]\nlength_from_mm = 10\nlength_to_mm = 4\n", "length_to_mm: expected at least 1 mm more");
    checkTold(head + "speed_window_s = 0\n" + good, "speed_window_s: expected a number from 0.1 to 10");
}

TEST_CASE("wire, flame and iron are led by the tip's distance, electrodes by the arc's length",
          "[training][technique]") {
    ProcessSettings process;
    process.choose<Gmaw>();
    CHECK(traitsOf(process).distance == DistanceKind::ctwd);
    process.choose<Flame>();
    CHECK(traitsOf(process).distance == DistanceKind::ctwd);
    process.choose<Gtaw>();
    CHECK(traitsOf(process).distance == DistanceKind::arcLength);
    process.choose<Smaw>();
    CHECK(traitsOf(process).distance == DistanceKind::arcLength);
}
