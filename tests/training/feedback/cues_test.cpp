// Cues as figures: direction and distance by the lesson's bands alone, fading, and the lesson's permissions.
#include "core/training/feedback/cues.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/judging/synthetic_weld.hpp"

#include <limits>

using namespace meltpool;
using test::Hand;

namespace {

TechniqueBands bandsOfBead(TravelDirection direction = TravelDirection::either) {
    TechniqueBands bands;
    bands.lengthFromMm = -40;
    bands.lengthToMm = 40;
    bands.direction = direction;
    bands.bands = {{TechniqueQuantity::aim, 0, 1, 3},
                   {TechniqueQuantity::distance, 15, 2, 6},
                   {TechniqueQuantity::workAngle, 0, 5, 15},
                   {TechniqueQuantity::travelAngle, 10, 5, 15},
                   {TechniqueQuantity::travelSpeed, 5, 1, 3}};
    return bands;
}

/// Returns a hand that welds from -20 mm on at this speed.
Technique weldAt(double speed, Hand hand) {
    return test::weldWith(test::plateSeam(), 2, [=](double time) {
        Hand now = hand;
        now.placeMm = -20 + speed * time * hand.direction;
        return now;
    });
}

CueList cuesOf(const Technique& technique, const TechniqueBands& bands) {
    ArcState arc;
    arc.action = ArcAction::burning;
    return liveCues(technique, arc, &bands, CueSet::all(), {});
}

} // namespace

TEST_CASE("a cue has the sign, amount and zone of what technique measures, and the score is made of the same values",
          "[training]") {
    const TechniqueBands bands = bandsOfBead();
    Hand hand;
    hand.aimMm = 2;
    hand.distanceMm = 12;
    hand.workDeg = -4;
    hand.travelDeg = 27;
    const Technique technique = weldAt(6.5, hand);
    const CueList cues = cuesOf(technique, bands);
    const auto check = [&](TechniqueQuantity quantity, double offset, double outer, BandZone zone, int correction) {
        const Cue* cue = cues.find(quantity);
        REQUIRE(cue != nullptr);
        INFO(quantityInfo(quantity, bands.distance).words());
        CHECK(cue->offset == Approx(offset).margin(0.02));
        CHECK(cue->share == Approx(offset / outer).margin(0.01));
        CHECK(cue->zone == zone);
        CHECK(cue->correction() == correction);
        CHECK(cue->opacity == (zone == BandZone::inside ? kQuietCue : 1.0));
    };
    check(TechniqueQuantity::aim, 2, 3, BandZone::between, -1);
    check(TechniqueQuantity::distance, -3, 6, BandZone::between, 1);
    check(TechniqueQuantity::workAngle, -4, 15, BandZone::inside, 0);
    check(TechniqueQuantity::travelAngle, 17, 15, BandZone::beyond, -1);
    check(TechniqueQuantity::travelSpeed, 1.5, 3, BandZone::between, -1);
    const TechniqueScore score =
        scoreTechnique(technique.faults(), alongSeam(technique), unknownPlaces(technique), bands);
    for (const CuedQuantity& cued : cuedQuantities()) {
        const ParameterScore* parameter = score.find(cued.quantity);
        REQUIRE(parameter != nullptr);
        CHECK(parameter->deviation == Approx(cues.find(cued.quantity)->offset).margin(0.05));
    }
}

TEST_CASE("a zone ends where the points do", "[training]") {
    const TechniqueBand band{TechniqueQuantity::travelSpeed, 5, 1, 3};
    for (double value = 0; value < 10; value += 0.125) {
        INFO(value);
        const BandZone zone = band.zone(value);
        CHECK((zone == BandZone::inside) == (band.points(value) == 100));
        CHECK((zone == BandZone::beyond) == (band.points(value) == 0));
    }
}

TEST_CASE("what is not known has no cue; before the strike the demanded direction serves for the travel angle",
          "[training]") {
    Hand resting;
    resting.burns = false;
    resting.travelDeg = 20;
    resting.direction = -1;
    const Technique technique = weldAt(0, resting);
    const CueList either = cuesOf(technique, bandsOfBead());
    CHECK(either.find(TechniqueQuantity::travelSpeed) == nullptr);
    CHECK(either.find(TechniqueQuantity::travelAngle) == nullptr);
    CHECK(either.find(TechniqueQuantity::aim) != nullptr);
    const TechniqueBands backward = bandsOfBead(TravelDirection::backward);
    const CueList demanded = cuesOf(technique, backward);
    REQUIRE(demanded.find(TechniqueQuantity::travelAngle) != nullptr);
    CHECK(demanded.find(TechniqueQuantity::travelAngle)->offset == Approx(10).margin(0.01));
    CHECK(cueDirection(technique, &backward) == -1);
    CHECK(liveCues(Technique(test::plateSeam()), {}, &backward, CueSet::all(), {}).empty());
    // Without bands there is no reference, but a seam ahead.
    const CueList none = liveCues(technique, {}, nullptr, CueSet::all(), {});
    REQUIRE(none.all().size() == 1);
    CHECK(none.find(CueKind::seam) != nullptr);
    // The centre line of a weave is known only after the swing.
    TechniqueBands weaving = bandsOfBead();
    weaving.bands.push_back({TechniqueQuantity::weaveWidth, 6, 1, 3});
    CHECK(cuesOf(technique, weaving).find(TechniqueQuantity::aim) == nullptr);
}

TEST_CASE("a contact tip that was pushed into the metal is too near by its depth", "[training]") {
    Hand hand;
    hand.burns = false;
    hand.distanceMm = std::numeric_limits<double>::infinity(); // no surface is ahead of it
    hand.tipHeightMm = -4;
    const CueList pushedIn = cuesOf(weldAt(0, hand), bandsOfBead());
    REQUIRE(pushedIn.find(TechniqueQuantity::distance) != nullptr);
    CHECK(pushedIn.find(TechniqueQuantity::distance)->offset == Approx(-19).margin(0.02));
    CHECK(pushedIn.find(TechniqueQuantity::distance)->zone == BandZone::beyond);
    hand.tipHeightMm = 20;
    CHECK(cuesOf(weldAt(0, hand), bandsOfBead()).find(TechniqueQuantity::distance) == nullptr);
}

TEST_CASE("before the arc a torch that is higher than the arc is long is too far, and no lower one is wrong",
          "[training]") {
    TechniqueBands bands = bandsOfBead();
    bands.distance = DistanceKind::arcLength;
    bands.bands[1] = {TechniqueQuantity::distance, 3, 1, 2};
    TechniqueSettings tungsten;
    tungsten.distance = DistanceKind::arcLength;
    const auto distanceCue = [&](double heightMm, bool burns, NoArc reason = NoArc::tooFar,
                                 float wayMm = std::numeric_limits<float>::infinity(),
                                 double welded = 0) -> std::optional<Cue> {
        Hand hand;
        hand.distanceMm = 3.5;
        hand.tipHeightMm = heightMm;
        const auto holds = [&](double time) {
            hand.burns = burns || time < welded;
            return hand;
        };
        const Technique held = test::weldWith(test::plateSeam(), 1, holds, tungsten);
        ArcState arc;
        arc.action = burns ? ArcAction::burning : ArcAction::out;
        arc.noArc = burns ? NoArc::burns : reason;
        arc.distance = wayMm * 1e-3F;
        const CueList cues = liveCues(held, arc, &bands, CueSet::all(), {});
        const Cue* cue = cues.find(TechniqueQuantity::distance);
        return cue == nullptr ? std::nullopt : std::optional(*cue);
    };
    const auto high = distanceCue(12, false);
    REQUIRE(high);
    CHECK(high->offset == Approx(9).margin(0.02));
    CHECK(high->zone == BandZone::beyond);
    CHECK(high->correction() == -1);
    CHECK_FALSE(distanceCue(2, false)); // the way down to the strike
    // The way from a burnt electrode's own end counts, where metal is ahead.
    REQUIRE(distanceCue(2, false, NoArc::tooLong, 20));
    CHECK(distanceCue(2, false, NoArc::tooLong, 20)->offset == Approx(17).margin(0.02));
    CHECK_FALSE(distanceCue(12, false, NoArc::tooFar, 2));
    for (const NoArc reason : {NoArc::touching, NoArc::touched, NoArc::stuck, NoArc::usedUp})
        CHECK_FALSE(distanceCue(12, false, reason));
    CHECK(distanceCue(12, false, NoArc::released));
    CHECK_FALSE(distanceCue(12, false, NoArc::released, 12, 0.5)); // the weld is over
    CHECK(distanceCue(12, false, NoArc::tooLong, 12, 0.5));
    REQUIRE(distanceCue(12, true));
    CHECK(distanceCue(12, true)->offset == Approx(0.5).margin(0.02)); // the arc's own length
}

TEST_CASE("travel against the demanded direction is a speed below zero", "[training]") {
    const Technique technique = weldAt(5, {});
    const CueList cues = cuesOf(technique, bandsOfBead(TravelDirection::backward));
    REQUIRE(cues.find(TechniqueQuantity::travelSpeed) != nullptr);
    CHECK(cues.find(TechniqueQuantity::travelSpeed)->offset == Approx(-10).margin(0.02));
    CHECK(cues.find(TechniqueQuantity::travelSpeed)->correction() == 1);
}

TEST_CASE("why the arc is out points to the metal or away from it", "[training]") {
    const Technique technique = weldAt(5, {});
    const auto cueOf = [&](NoArc reason, ArcAction action = ArcAction::out) {
        ArcState arc;
        arc.action = action;
        arc.noArc = reason;
        const CueList cues = liveCues(technique, arc, nullptr, CueSet::all(), {});
        const Cue* found = cues.find(CueKind::arc);
        return found != nullptr ? std::optional(*found) : std::nullopt;
    };
    CHECK_FALSE(cueOf(NoArc::burns, ArcAction::burning));
    CHECK_FALSE(cueOf(NoArc::released));
    CHECK_FALSE(cueOf(NoArc::feeding));
    REQUIRE(cueOf(NoArc::tooLong));
    CHECK(cueOf(NoArc::tooLong)->correction() == -1);
    CHECK(cueOf(NoArc::tooLong)->zone == BandZone::beyond);
    CHECK(cueOf(NoArc::tooFar)->correction() == -1);
    CHECK(cueOf(NoArc::tooFar)->zone == BandZone::between);
    CHECK(cueOf(NoArc::stuck)->correction() == 1);
    CHECK(cueOf(NoArc::touched)->correction() == 1);
    CHECK(cueOf(NoArc::noMetal)->correction() == 0);
}

TEST_CASE("a torch that is put aside has no cues, however it is held; one that welds has them anywhere", "[training]") {
    const TechniqueBands bands = bandsOfBead();
    for (const bool burns : {false, true}) {
        Hand hand;
        hand.burns = burns;
        ArcState arc;
        arc.action = burns ? ArcAction::burning : ArcAction::out;
        hand.tipHeightMm = 50;
        CHECK_FALSE(liveCues(weldAt(5, hand), arc, &bands, CueSet::all(), {}).empty());
        hand.tipHeightMm = 70;
        CHECK(liveCues(weldAt(5, hand), arc, &bands, CueSet::all(), {}).empty() == !burns);
        hand.tipHeightMm = 2;
        hand.aimMm = -65;
        CHECK(liveCues(weldAt(5, hand), arc, &bands, CueSet::all(), {}).empty() == !burns);
    }
}

TEST_CASE("a cue that is switched off is not there", "[training]") {
    const Technique technique = weldAt(5, {});
    const TechniqueBands bands = bandsOfBead();
    for (const CueKind off : kCueKinds) {
        CueSet shown = CueSet::all();
        shown.set(off, false);
        const CueList cues = liveCues(technique, {}, &bands, shown, {});
        INFO(cueName(off));
        CHECK(cues.find(off) == nullptr);
        CHECK_FALSE(cues.empty());
    }
    CHECK(liveCues(technique, {}, &bands, {}, {}).empty());
}

TEST_CASE("a cue fades with good attempts, comes back with poor ones, and a short or unscored one counts nothing",
          "[training]") {
    TechniqueScore score;
    score.scored = true;
    score.coverage = 1;
    score.parameters.resize(2);
    score.parameters[0].quantity = TechniqueQuantity::travelSpeed;
    score.parameters[1].quantity = TechniqueQuantity::workAngle;
    const auto points = [&](double speed, double work) {
        score.parameters[0].score = speed;
        score.parameters[1].score = work;
    };
    CueSkill skill;
    CHECK(skill.strength(CueKind::speed) == 1);
    points(80, 70);
    skill = skill.after(score);
    CHECK(skill.strength(CueKind::speed) == 0.75);
    CHECK(skill.strength(CueKind::angles) == 1);
    for (int i = 0; i < 9; ++i)
        skill = skill.after(score);
    CHECK(skill.strength(CueKind::speed) == 0);
    CHECK(skill.strength(CueKind::arc) == 1);
    points(59, 100);
    skill = skill.after(score);
    CHECK(skill.strength(CueKind::speed) == 0.25);
    CHECK(skill.strength(TechniqueQuantity::workAngle) == 0.75);
    CHECK(skill.strength(CueKind::angles) == 1); // the travel angle is not mastered
    score.coverage = 0.4;
    CHECK(skill.after(score) == skill);
    score.coverage = 1;
    score.scored = false;
    CHECK(skill.after(score) == skill);

    const Technique technique = weldAt(6.5, {});
    const TechniqueBands bands = bandsOfBead();
    ArcState arc;
    CHECK(liveCues(technique, arc, &bands, CueSet::all(), skill).find(CueKind::speed)->opacity == 0.25);
    skill.setGood(TechniqueQuantity::travelSpeed, CueSkill::kMastered);
    CHECK(liveCues(technique, arc, &bands, CueSet::all(), skill).find(CueKind::speed) == nullptr);
}

TEST_CASE("what the desk held by itself makes no progress, but a poor attempt with it counts", "[training]") {
    TechniqueScore score;
    score.scored = true;
    score.coverage = 1;
    score.parameters.resize(2);
    score.parameters[0].quantity = TechniqueQuantity::distance;
    score.parameters[1].quantity = TechniqueQuantity::aim;
    score.parameters[0].score = score.parameters[1].score = 100;
    QuantitySet held;
    held.set(static_cast<size_t>(TechniqueQuantity::distance));
    CueSkill skill = CueSkill().after(score, held);
    CHECK(skill.good(TechniqueQuantity::distance) == 0);
    CHECK(skill.good(TechniqueQuantity::aim) == 1);
    skill.setGood(TechniqueQuantity::distance, 2);
    score.parameters[0].score = 50;
    CHECK(skill.after(score, held).good(TechniqueQuantity::distance) == 1);
}

TEST_CASE("a lesson says which cues it allows; a name that is none is refused with its line", "[training]") {
    const auto file = test::scratchFolder("cues") / "lesson.toml";
    const auto lessonWith = [&](const std::string& cues) {
        writeTextFileAtomically(file, "model = \"weld\"\n" + cues);
        return readLesson(file);
    };
    CHECK(lessonWith("").cues == CueSet::all());
    CHECK(lessonWith("[cues]\nallowed = [\"aim\", \"speed\"]\n").cues.names() == "speed aim");
    CHECK(lessonWith("[cues]\nallowed = []\n").cues.empty());
    CHECK(lessonWith("[cues]\n").cues == CueSet::all());
    const auto refusal = [&](const std::string& cues) -> std::string {
        try {
            lessonWith(cues);
        } catch (const InputError& fault) {
            return fault.what();
        }
        return "";
    };
    CHECK_THAT(
        refusal("[cues]\nallowed = [\"voice\"]\n"),
        test::containsText("lesson.toml:3: [cues] allowed: has 'voice'; expected some of speed angles distance"));
    CHECK_THAT(refusal("[cues]\nallowed = 3\n"), test::containsText("lesson.toml:3: "));
    CHECK_THAT(refusal("[cues]\nshown = []\n"), test::containsText("unknown key"));
}
