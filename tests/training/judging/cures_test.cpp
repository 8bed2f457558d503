// Likely causes and remedies of failed imperfections, for synthetic attempts.
#include "core/training/judging/cures.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/cure_causes.hpp"
#include "core/weld/process/processes.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <map>

using namespace meltpool;
using enum TechniqueQuantity;

namespace {

/// Targets for all quantities of a wire process or, with an arc length, of a stick; no ideal of 0 that a negative value
/// could not leave.
TechniqueBands allBands(DistanceKind distanceKind = DistanceKind::ctwd) {
    TechniqueBands bands;
    bands.distance = distanceKind;
    bands.lengthFromMm = 0;
    bands.lengthToMm = 40;
    for (const QuantityInfo& info : quantities(distanceKind))
        if (!info.key.empty()) bands.bands.push_back({info.quantity, 10, 1, 4, 1});
    return bands;
}

/// A seam of 40 mm whose hand keeps every target except one quantity, which is off by `off` from `fromMm` on.
std::vector<SeamMillimetre> seamWith(const TechniqueBands& bands, std::optional<TechniqueQuantity> wrong = {},
                                     double off = 0, int fromMm = 0) {
    std::vector<SeamMillimetre> seam;
    for (int i = 0; i < 40; ++i) {
        SeamMillimetre mm;
        mm.place = (i + 0.5) * 1e-3;
        mm.judged = i >= 3 && i < 37;
        mm.direction = 1;
        for (const TechniqueBand& band : bands.bands) {
            const double value = band.ideal + (band.quantity == wrong && i >= fromMm ? off : 0);
            mm.values[band.quantity] = value / quantityInfo(band.quantity, bands.distance).perSi;
        }
        seam.push_back(mm);
    }
    return seam;
}

/// A verdict in which these fail from 10 to 30 mm, worst at `worstMm`.
Verdict failing(const std::vector<std::string>& names, double worstMm = 20) {
    Verdict verdict{"ISO 5817", "2014", "C", {}, false};
    VerdictItem passed;
    passed.name = "undercut";
    passed.state = VerdictState::pass;
    if (names != std::vector<std::string>{"undercut"}) verdict.items.push_back(passed);
    for (const std::string& name : names) {
        VerdictItem item;
        item.name = name;
        item.state = VerdictState::fail;
        item.place = worstMm * 1e-3;
        item.failing = {{10e-3, 30e-3}};
        verdict.items.push_back(item);
    }
    return verdict;
}

template <class P>
const ProcessTraits& traitsFor() {
    ProcessSettings settings;
    settings.choose<P>();
    return traitsOf(settings);
}

const ProcessTraits& wire() {
    return traitsFor<Gmaw>();
}

/// A process to which a row applies.
const ProcessTraits& processOf(const CureCause& row) {
    for (const ProcessTraits* each : {&wire(), &traitsFor<Smaw>(), &traitsFor<Gtaw>()})
        if (row.only == nullptr || row.only(*each)) return *each;
    FAIL("no process has the row");
    return wire();
}

SettingFact voltage(double value, double asked = 23) {
    return {"voltage", "voltage", "V", value, asked, asked * 0.98, asked * 1.02, 5, 60, true};
}

Cure only(const Verdict& verdict, const CureFacts& facts) {
    const std::vector<Cure> cures = curesOf(verdict, facts);
    REQUIRE(cures.size() == 1);
    return cures[0];
}

std::string effectOf(const CureCause& row) {
    return phraseOf("cure.effect", nameOf(row.effect));
}

} // namespace

TEST_CASE("every imperfection has at least two causes, in hand or machine, that lessons can have",
          "[training][cures]") {
    std::map<std::string_view, int> rows;
    for (const CureCause& row : cureCauses()) {
        INFO(row.imperfection << " " << row.setting);
        REQUIRE(findImperfection(row.imperfection) != nullptr);
        CHECK(findImperfection(row.imperfection)->key == row.imperfection);
        CHECK(row.hand.has_value() == row.setting.empty());
        CHECK((row.sign == 0 || row.sign == 1 || row.sign == -1));
        if (!row.setting.empty()) CHECK(row.sign != 0);
        CHECK(findPhrase("cure.effect." + std::string(nameOf(row.effect))) != nullptr);
        ++rows[row.imperfection];
    }
    for (const WeldFigure& each : imperfections()) {
        INFO(each.key);
        // The gap and the offset of the plates were set up so: no hand causes them.
        // A strike beside the seam is no deviation along it.
        const bool setUp = each.key == "linear_misalignment" || each.key == "joint_gap" || each.key == "stray_arc";
        CHECK(rows[each.key] >= (setUp ? 0 : 2));
    }
}

TEST_CASE("each deviation of the hand that explains a fault is named with its correction, none inside the tolerance",
          "[training][cures]") {
    for (const CureCause& row : cureCauses()) {
        if (!row.hand) continue;
        const ProcessTraits& traits = processOf(row);
        const TechniqueBands bands = allBands(traits.distance);
        for (const int sign : {1, -1}) {
            INFO(row.imperfection << ", " << quantityInfo(*row.hand, bands.distance).key << " " << sign);
            const Verdict verdict = failing({std::string(row.imperfection)});
            const std::string fault = capitalised(imperfectionName(row.imperfection)) + " at 20 mm: ";
            const auto seam = seamWith(bands, row.hand, 2.5 * sign);
            const Cure cure = only(verdict, {seam, traits, &bands, {}});
            const bool known = std::any_of(cureCauses().begin(), cureCauses().end(), [&](const CureCause& each) {
                return each.imperfection == row.imperfection && each.hand == row.hand &&
                       (each.sign == 0 || each.sign == sign) && (each.only == nullptr || each.only(traits));
            });
            const ParameterScore parameter = scoreStretch(seam, 0, 1, bands, *bands.find(*row.hand));
            const std::string correction = correctionSentence(parameter, *bands.find(*row.hand), bands);
            CHECK((cure.sentence.find(correction) != std::string::npos) == known);
            if (row.sign == sign) CHECK(cure.sentence == fault + effectOf(row) + " " + correction);
            // A quarter inside the tolerance: no advice about it.
            const auto inside = seamWith(bands, row.hand, 0.75 * sign);
            CHECK(only(verdict, {inside, traits, &bands, {}}).sentence ==
                  fault + "no likely cause was found. Cut the weld open there and look.");
        }
    }
}

TEST_CASE("each setting that explains a fault is named with the lesson's value, and a what-if tries it",
          "[training][cures]") {
    const TechniqueBands bands = allBands();
    const auto seam = seamWith(bands);
    for (const CureCause& row : cureCauses()) {
        if (row.setting.empty()) continue;
        INFO(row.imperfection << ", " << row.setting);
        const ProcessTraits& traits = processOf(row);
        const Verdict verdict = failing({std::string(row.imperfection)});
        SettingFact fact{std::string(row.setting), "knob", "V", 20.0 + 3 * row.sign, 20, 19.6, 20.4, 5, 60, true};
        const Cure cure = only(verdict, {seam, traits, &bands, std::span(&fact, 1)});
        CHECK_THAT(cure.sentence, test::containsText(" at 20 mm: " + effectOf(row) +
                                                     " Set the knob to 20 V as in the lesson: it was " +
                                                     (row.sign > 0 ? "23." : "17.")));
        CHECK(cure.whatIf == std::string(row.setting) + "=20");
        CHECK(cure.change == (row.sign > 0 ? "knob 20 V instead of 23" : "knob 20 V instead of 17"));
        fact.ofMachine = false;
        CHECK_THAT(only(verdict, {seam, traits, &bands, std::span(&fact, 1)}).sentence,
                   test::containsText("Set the knob back to 20 V: it was "));
        fact.ofMachine = true;
        fact.value = 20 + 0.3 * row.sign; // inside its tolerance, so not off the lesson's
        CHECK_THAT(only(verdict, {seam, traits, &bands, std::span(&fact, 1)}).sentence,
                   !test::containsText("as in the lesson: it was"));
    }
}

TEST_CASE("the place decides: the hand at the failure counts, not its mean over the seam", "[training][cures]") {
    const TechniqueBands bands = allBands();
    // 2.5 mm/s too slow on the last 5 mm only, beyond the failing stretch.
    const auto late = seamWith(bands, travelSpeed, -2.5, 35);
    CHECK_THAT(only(failing({"overlap"}), {late, wire(), &bands, {}}).sentence, test::containsText("no likely cause"));
    const auto local = seamWith(bands, travelSpeed, -2.5, 9);
    const Cure cure = only(failing({"overlap"}), {local, wire(), &bands, {}});
    CHECK(cure.sentence ==
          "Overlap at 20 mm: likely more metal there than the heat can spread. Travel faster: 7.5 mm/s, "
          "target 10.");
    CHECK(cure.whatIf == "speed=10mm/s");
    CHECK(cure.change == "travel speed 10 mm/s instead of 7.9");

    // Beyond at the failure only, while the mean over the seam is right: no what-if of the whole path would be a cure.
    auto few = seamWith(bands, travelSpeed, -2.5, 28);
    const Cure untried = only(failing({"overlap"}, 29), {few, wire(), &bands, {}});
    CHECK(untried.whatIf.empty());
}

TEST_CASE("the largest deviation of those that explain a fault comes first, then settings", "[training][cures]") {
    const TechniqueBands bands = allBands();
    auto seam = seamWith(bands, aim, 1.5);
    for (SeamMillimetre& mm : seam)
        mm.values[travelSpeed] = 13e-3;
    SettingFact low = voltage(17);
    const CureFacts facts{seam, wire(), &bands, std::span(&low, 1)};
    CHECK_THAT(only(failing({"lack_of_fusion"}), facts).sentence, test::containsText("Travel slower: 13 mm/s"));
    CHECK_THAT(only(failing({"excessive_asymmetry"}), facts).sentence, test::containsText("Aim farther away"));
    // Nothing of the hand explains an excess of throat: the voltage does.
    CHECK_THAT(only(failing({"excessive_throat"}), facts).sentence,
               test::containsText("Set the voltage to 23 V as in the lesson: it was 17."));
}

TEST_CASE("a hand and settings as asked are told so, with the change that would most likely help",
          "[training][cures]") {
    const TechniqueBands bands = allBands();
    const auto seam = seamWith(bands);
    std::vector<SettingFact> settings{voltage(23),
                                      {"wire_feed_m_min", "wire feed", "m/min", 4.5, 4.5, 4.4, 4.6, 0, 30, true}};
    const Cure overlap = only(failing({"overlap"}), {seam, wire(), &bands, settings});
    CHECK(overlap.sentence == "Overlap at 20 mm: likely too little heat for the plate there. Try a voltage of 26 V "
                              "instead of 23: hand and settings were as the lesson asks.");
    CHECK(overlap.whatIf == "voltage=26");
    const Cure throat = only(failing({"insufficient_throat"}), {seam, wire(), &bands, settings});
    CHECK_THAT(throat.sentence, test::containsText("Try a wire feed of 5 m/min instead of 4.5: hand and settings"));
    CHECK(throat.whatIf == "wire_feed_m_min=5");
    // A deviation that explains nothing is not called right either.
    const auto flat = seamWith(bands, rodAngle, 3);
    CHECK_THAT(only(failing({"overlap"}), {flat, wire(), &bands, settings}).sentence,
               test::containsText("no other cause was found."));
    CHECK_THAT(only(failing({"overlap"}), {seam, wire(), nullptr, settings}).sentence,
               test::containsText("no other cause was found."));
    // A machine at its end: the next likely setting.
    settings[0].highest = 23;
    CHECK_THAT(only(failing({"overlap"}), {seam, wire(), &bands, settings}).sentence,
               test::containsText("Try a wire feed of 4 m/min instead of 4.5"));
}

TEST_CASE("a chosen setting within its limits is held against the demonstration's", "[training][cures]") {
    const TechniqueBands bands = allBands();
    const auto seam = seamWith(bands);
    SettingFact chosen{"voltage", "voltage", "V", 20, 23, 20, 26, 20, 26, true};
    const Cure cure = only(failing({"overlap"}), {seam, wire(), &bands, std::span(&chosen, 1)});
    CHECK(cure.sentence == "Overlap at 20 mm: likely too little heat for the plate there. Try the voltage of the "
                           "demonstration, 23 V instead of 20.");
    CHECK(cure.whatIf == "voltage=23");
    // Burn-through does not come from a low voltage.
    CHECK_THAT(only(failing({"burn_through"}), {seam, wire(), &bands, std::span(&chosen, 1)}).sentence,
               !test::containsText("demonstration"));
}

TEST_CASE("a failure where no arc passed, or in strike or crater, has that as its cause", "[training][cures]") {
    const TechniqueBands bands = allBands();
    auto seam = seamWith(bands);
    Verdict verdict = failing({"lack_of_fusion"}, 38.5);
    verdict.items.back().failing = {{38e-3, 40e-3}};
    CHECK(
        only(verdict, {seam, wire(), &bands, {}}).sentence ==
        "Lack of fusion at 38.5 mm: the arc began or ended there. Strike before the seam that counts, and run on past "
        "its end.");
    Verdict crater = failing({"end_crater_pipe"}, 38.5);
    crater.items.back().failing = {{38e-3, 40e-3}};
    CHECK(only(crater, {seam, wire(), &bands, {}}).sentence ==
          "End crater pipe at 38.5 mm: hold the torch still for a moment before the arc goes out, so that the pool "
          "fills.");
    seam.resize(30);
    CHECK(only(verdict, {seam, wire(), &bands, {}}).sentence ==
          "Lack of fusion at 38.5 mm: no arc passed there. Weld the whole seam.");
    // Tracking was lost there: the arc may have passed.
    const std::vector<double> unknown{38.5e-3};
    CHECK_THAT(only(verdict, {seam, wire(), &bands, {}, unknown}).sentence, test::containsText("no likely cause"));
    seam.clear();
    CHECK_THAT(only(verdict, {seam, wire(), &bands, {}}).sentence, test::containsText("no arc passed there"));
}

TEST_CASE("only what fails has a cure, in the verdict's order", "[training][cures]") {
    const TechniqueBands bands = allBands();
    const auto seam = seamWith(bands);
    Verdict verdict = failing({"overlap", "toe_angle"});
    VerdictItem pores;
    pores.name = "surface_pore";
    pores.state = VerdictState::estimated;
    pores.beyond = true;
    verdict.items.push_back(pores);
    const std::vector<Cure> cures = curesOf(verdict, {seam, wire(), &bands, {}});
    REQUIRE(cures.size() == 2);
    CHECK(cures[0].imperfection == "overlap");
    CHECK(cures[1].imperfection == "toe_angle");
    CHECK(failedKeys(verdict) == std::vector<std::string>{"overlap", "toe_angle"});
}

TEST_CASE("the outcome of a tried remedy names what would have passed", "[training][cures]") {
    using Keys = std::vector<std::string>;
    const auto outcome = [](const Keys& failed, const Keys& then) {
        return whatIfOutcome("voltage 20 V instead of 17", failed, then);
    };
    CHECK(outcome({"overlap", "toe_angle"}, {}) ==
          "With voltage 20 V instead of 17 the weld would have been accepted: overlap, toe angle would have passed.");
    CHECK(outcome({"overlap", "toe_angle"}, {"toe_angle"}) ==
          "With voltage 20 V instead of 17 overlap would have passed. Still failing: toe angle.");
    CHECK(outcome({"overlap"}, {"overlap", "undercut"}) ==
          "With voltage 20 V instead of 17 nothing more would have passed. Still failing: overlap. Failing only then: "
          "undercut.");
    CHECK(outcome({}, {}) == "With voltage 20 V instead of 17 nothing more would have passed.");
}
