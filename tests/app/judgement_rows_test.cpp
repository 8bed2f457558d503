// The result panel's words for synthetic judgements.
#include "app/activities/judgement_rows.hpp"
#include "core/base/units.hpp"
#include "tests/support/catch.hpp"

#include <cmath>
#include <limits>

using namespace meltpool;

namespace {

TechniqueBands asked() {
    TechniqueBands bands;
    bands.lengthToMm = 40;
    bands.bands = {{TechniqueQuantity::travelAngle, 10, 5, 15, 1}, {TechniqueQuantity::travelSpeed, 8, 0.8, 3, 2}};
    return bands;
}

TechniqueScore scored() {
    TechniqueScore score;
    score.scored = true;
    score.total = 61.6;
    score.coverage = 1;
    score.wantedMm = 40;
    score.weldedMm = 39;
    ParameterScore angle, speed;
    angle.quantity = TechniqueQuantity::travelAngle;
    angle.score = 100;
    angle.mean = -3.2;
    speed.quantity = TechniqueQuantity::travelSpeed;
    speed.score = 42.4;
    speed.mean = 10.26;
    score.parameters = {angle, speed};
    return score;
}

WeldMeasures fillet() {
    WeldMeasures weld;
    weld.kind = WeldKind::fillet;
    weld.pitch = 2e-3;
    weld.spacing = 1e-3;
    weld.stations.resize(15);
    weld.mean.throat = 4.26e-3;
    weld.least.throat = 3.9e-3;
    weld.greatest.throat = 4.5e-3;
    weld.mean.rootFused = 0.93;
    return weld;
}

Verdict refused() {
    Verdict verdict{"ISO 5817", "2014", "C", {}, false};
    VerdictItem passed, failed, open, absent;
    passed = {"undercut", 0.2, 0.9, LimitKind::atMost, "mm", VerdictState::pass, false, 0.5, 0.012};
    open = {"toe_angle", 100.0, 110.0, LimitKind::atLeast, "deg", VerdictState::notResolved, false, 15, 0.004};
    failed = {"lack_of_fusion", 1.26, 0.0, LimitKind::notPermitted, "mm", VerdictState::fail, true, 0.5, -0.0081};
    absent.name = "surface_pore";
    absent.limit = 1.5;
    absent.unit = "mm";
    verdict.items = {passed, open, failed, absent};
    return verdict;
}

const JudgementRow& find(const JudgementSection& section, const std::string& name) {
    for (const JudgementRow& row : section.rows)
        if (row.name == name) return row;
    FAIL("there is no row " << name);
    return section.rows.front();
}

} // namespace

TEST_CASE("score and parameters are told with what was asked for, signs as sides", "[app]") {
    Judgement judgement;
    judgement.score = scored();
    judgement.corrections = {{TechniqueQuantity::travelSpeed, 38, "Travel slower."}};
    const TechniqueBands bands = asked();
    const JudgementRows rows = judgementRows(judgement, &bands);
    CHECK(rows.score == "Score 62 of 100");
    CHECK(rows.scoreNote == "39 of 40 mm of the seam are welded.");
    CHECK(rows.corrections == std::vector<std::string>{"Travel slower."});
    const JudgementRow& speed = find(rows.technique, "Travel speed");
    CHECK(speed.value == "42 of 100");
    CHECK(speed.detail == "Mean 10.3 mm/s, target 8 mm/s \xC2\xB1 0.8 mm/s");
    CHECK(speed.state == RowState::bad);
    const JudgementRow& angle = find(rows.technique, "Travel angle");
    CHECK(angle.detail == "Mean 3\xC2\xB0 drag, target 10\xC2\xB0 push \xC2\xB1 5\xC2\xB0");
    CHECK(angle.state == RowState::good);
}

TEST_CASE("the score names the quantities that the desk held; they are neither good nor bad", "[app]") {
    Judgement judgement;
    judgement.score = scored();
    const TechniqueBands bands = asked();
    QuantitySet held;
    held.set(static_cast<size_t>(TechniqueQuantity::travelAngle));
    held.set(static_cast<size_t>(TechniqueQuantity::rodAngle)); // not scored here
    const JudgementRows rows = judgementRows(judgement, &bands, held);
    CHECK(rows.scoreNote == "39 of 40 mm of the seam are welded. The desk held some of it: travel angle.");
    CHECK_THAT(find(rows.technique, "Travel angle").detail, test::containsText(". The desk held it."));
    CHECK(find(rows.technique, "Travel angle").state == RowState::plain);
    CHECK(find(rows.technique, "Travel speed").state == RowState::bad);
    CHECK_THAT(judgementRows(judgement, &bands, ~QuantitySet()).scoreNote,
               test::containsText("The desk held all of it"));
    CHECK(keysOf(held, DistanceKind::ctwd) == "travel_angle rod_angle");
    CHECK(wordsOfKeys("travel_angle arc_length new_one") == "travel angle, arc length, new_one");
}

TEST_CASE("an attempt that is not scored says why", "[app]") {
    Judgement judgement;
    judgement.score = scored();
    judgement.score->scored = false;
    judgement.score->reason = "Tracking was lost.";
    const JudgementRows rows = judgementRows(judgement, nullptr);
    CHECK(rows.score == "Not scored");
    CHECK(rows.scoreNote == "Tracking was lost.");
    CHECK(rows.technique.rows.empty());
}

TEST_CASE("a value that is nowhere known is said to be so", "[app]") {
    Judgement judgement;
    judgement.score = scored();
    judgement.score->parameters[1].mean = std::numeric_limits<double>::quiet_NaN();
    const JudgementRows rows = judgementRows(judgement, nullptr);
    CHECK(find(rows.technique, "Travel speed").detail == "Mean not measured");
}

TEST_CASE("the verdict names standard and level, and what failed comes first, what passed last", "[app]") {
    Judgement judgement;
    judgement.weld = fillet();
    judgement.verdict = refused();
    const JudgementRows rows = judgementRows(judgement, nullptr);
    CHECK(rows.verdict == "Not accepted by ISO 5817, level C");
    CHECK(rows.verdictState == RowState::bad);
    CHECK(rows.verdictNote == "Fails: Lack of fusion.");
    CHECK(rows.judged.note ==
          "1 failed, 1 passed, 1 too fine to see (it does not count), 1 not simulated. Edition 2014, level C.");
    REQUIRE(rows.judged.rows.size() == 4);
    CHECK(rows.judged.rows[0].name == "Lack of fusion");
    CHECK(rows.judged.rows[0].value == "FAIL");
    CHECK(rows.judged.rows[0].detail == "1.3 mm \xC2\xB1 0.5 mm; none is allowed, at -8 mm");
    CHECK(rows.judged.rows[0].state == RowState::bad);
    CHECK(rows.judged.rows[1].value == "too fine to see");
    CHECK(rows.judged.rows[1].detail == "100\xC2\xB0 \xC2\xB1 15\xC2\xB0; at least 110\xC2\xB0, at 4 mm");
    CHECK(rows.judged.rows[2].value == "not simulated");
    CHECK(rows.judged.rows[2].detail == "At most 1.5 mm");
    CHECK(rows.judged.rows[3].name == "Undercut");
    CHECK(rows.judged.rows[3].value == "pass");

    VerdictItem& pores = judgement.verdict->items[3];
    pores = {"surface_pore", 24.0, {}, LimitKind::atMost, "mm", VerdictState::estimated, true, 0, {}, "Too far off."};
    const JudgementRows told = judgementRows(judgement, nullptr);
    CHECK_THAT(told.judged.note, test::containsText(", 1 estimated. "));
    CHECK(find(told.judged, "Surface pore").value == "estimated: likely");
    CHECK(find(told.judged, "Surface pore").detail ==
          "Likely on 24 mm of the weld (estimate; does not count). Too far off.");
    CHECK(find(told.judged, "Surface pore").state == RowState::open);
    pores.beyond = false;
    CHECK(find(judgementRows(judgement, nullptr).judged, "Surface pore").value == "estimated: unlikely");
    CHECK_THAT(find(judgementRows(judgement, nullptr).judged, "Surface pore").detail,
               test::containsText("Unlikely with this technique"));

    judgement.verdict->accepted = true;
    const VerdictItem fusion = judgement.verdict->items[2];
    judgement.verdict->items.erase(judgement.verdict->items.begin() + 2);
    const JudgementRows yes = judgementRows(judgement, nullptr);
    CHECK(yes.verdict == "Accepted by ISO 5817, level C");
    CHECK(yes.verdictNote == "No fault found: 1 passed, 2 left to see on a real weld.");

    VerdictItem& mean = judgement.verdict->items.emplace_back(fusion);
    mean.uncertainty = 0.25;
    mean.meanOver = 30e-3;
    CHECK(find(judgementRows(judgement, nullptr).judged, "Lack of fusion").detail ==
          "Mean 1.3 mm \xC2\xB1 0.3 mm over 30 mm; none is allowed");
}

TEST_CASE("a throat that is too small says that short legs count", "[app]") {
    Judgement judgement;
    judgement.verdict = refused();
    const VerdictItem small = {
        "insufficient_throat", 0.8, 0.1, LimitKind::notPermitted, "mm", VerdictState::fail, true, 0.1, std::nullopt};
    judgement.verdict->items = {small};
    const auto detail = [&] { return judgementRows(judgement, nullptr).judged.rows.front().detail; };
    CHECK_THAT(detail(), test::containsText("a short leg counts, too"));
    judgement.verdict->items.front().state = VerdictState::pass;
    CHECK_THAT(detail(), !test::containsText("a short leg counts, too"));
}

TEST_CASE("a lesson without bands and acceptance says so and shows the measured weld", "[app]") {
    Judgement judgement;
    judgement.weld = fillet();
    const JudgementRows rows = judgementRows(judgement, nullptr);
    CHECK(rows.score == "No score");
    CHECK(rows.verdict == "Measured, not judged");
    CHECK_THAT(rows.judged.note, test::containsText("names no standard"));
    CHECK(find(rows.measured, "Throat").value == "4.3 mm");
    CHECK(find(rows.measured, "Throat").detail == "From 3.9 to 4.5 mm");
    CHECK(find(rows.measured, "Root fused").value == "93 %");
    CHECK_THAT(rows.measured.note, test::containsText("30 mm of seam, cut at 15 places"));

    CHECK(find(rows.measured, "Cooling from 800 to 500 \xC2\xB0\x43").value == "not known yet");

    judgement.weld->stations.clear();
    const JudgementRows empty = judgementRows(judgement, nullptr);
    CHECK(empty.verdict == "No weld to judge");
    CHECK(empty.measured.rows.empty());
}

TEST_CASE("each cure is a row, and what several share is tried once", "[app]") {
    Judgement judgement;
    judgement.weld = fillet();
    judgement.verdict = refused();
    judgement.cures = {{"overlap", "Overlap: set the voltage.", "voltage=20", "voltage 20 V instead of 17"},
                       {"toe_angle", "Toe angle: set the voltage.", "voltage=20", "voltage 20 V instead of 17"},
                       {"undercut", "Undercut: aim lower."}};
    const JudgementRows rows = judgementRows(judgement, nullptr);
    REQUIRE(rows.cures.size() == 3);
    CHECK(rows.cures[0].sentence == "Overlap: set the voltage.");
    CHECK(rows.cures[0].whatIf == "voltage=20");
    CHECK(rows.cures[0].change == "voltage 20 V instead of 17");
    CHECK(rows.cures[1].sentence == "Toe angle: set the voltage.");
    CHECK(rows.cures[1].whatIf.empty());
    CHECK(rows.cures[2].whatIf.empty());
}

TEST_CASE("in inches score, verdict and measured weld have no millimetres", "[app]") {
    chooseUnits(UnitSystem::inches);
    Judgement judgement;
    judgement.score = scored();
    judgement.weld = fillet();
    judgement.verdict = refused();
    const TechniqueBands bands = asked();
    const JudgementRows rows = judgementRows(judgement, &bands);
    chooseUnits(UnitSystem::metric);
    CHECK(rows.scoreNote == "1.54 of 1.57 in of the seam are welded.");
    CHECK(find(rows.technique, "Travel speed").detail == "Mean 24.3 in/min, target 19 in/min \xC2\xB1 1.9 in/min");
    CHECK(rows.judged.rows[0].detail == "0.051 in \xC2\xB1 0.020 in; none is allowed, at -0.31 in");
    CHECK(find(rows.measured, "Throat").value == "0.169 in");
    CHECK(find(rows.measured, "Throat").detail == "From 0.154 to 0.177 in");
    for (const auto* part : {&rows.technique, &rows.judged, &rows.measured})
        for (const JudgementRow& row : part->rows)
            CHECK_THAT(row.value + row.detail, !test::containsText("mm"));
    CHECK_THAT(rows.measured.note, !test::containsText("mm"));
}
