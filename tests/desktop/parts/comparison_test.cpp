// Tests the description of two attempts in words, without a window and without metal.
#include "app/activities/comparison_rows.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

AttemptFigures attempt(double penetration, double speed, double points) {
    AttemptFigures figures;
    figures.spacing = 0.5e-3;
    figures.values = {{"penetration_mm", penetration}, {"travel_speed", speed}, {"mean_current_a", 110}};
    figures.score = points;
    figures.points = {{"travel_speed", points}};
    return figures;
}

Judgement judged(bool accepted, const std::vector<std::string>& fails) {
    Judgement judgement;
    judgement.verdict.emplace();
    judgement.verdict->accepted = accepted;
    for (const std::string& name : fails) {
        VerdictItem item;
        item.name = name;
        item.state = VerdictState::fail;
        judgement.verdict->items.push_back(item);
    }
    return judgement;
}

const ComparedRow* find(const ComparisonRows& rows, const std::string& name) {
    for (const ComparedSection& section : rows.sections)
        for (const ComparedRow& row : section.rows)
            if (row.name == name) return &row;
    return nullptr;
}

} // namespace

TEST_CASE("two attempts stand beside each other with score, verdict, weld, hand and arc") {
    const Comparison comparison = compareAttempts(attempt(2, 5, 70), attempt(2.5, 4, 82));
    const ComparisonRows rows =
        comparisonRows(judged(false, {"lack_of_fusion", "undercut"}), judged(true, {}), comparison);
    CHECK(rows.words == "The second: 0.5 mm more penetration, 1.0 mm/s slower travel, score +12.");
    REQUIRE(rows.notes.size() == 1);
    CHECK_THAT(rows.notes[0], test::containsText("0.25 mm (half a particle spacing)"));
    REQUIRE(rows.sections.size() == 5);
    const auto shown = [&](const std::string& name) {
        const ComparedRow* row = find(rows, name);
        return row == nullptr ? "" : row->first + " | " + row->second + " | " + row->difference;
    };
    CHECK(shown("Verdict") == "not accepted | accepted | different");
    CHECK(shown("Fails") == "lack of fusion, undercut | nothing | different");
    CHECK(shown("Score") == "70 | 82 | +12");
    CHECK(shown("Penetration") == "2.0 mm | 2.5 mm | +0.5 mm");
    CHECK(shown("Mean current") == "110 A | 110 A | ");
    CHECK(rows.sections[1].rows.size() == 2);
}

TEST_CASE("attempts without a score or a weld say so") {
    const ComparisonRows rows = comparisonRows({}, {}, compareAttempts({}, {}));
    CHECK(rows.words == "The second: no difference that the metal resolves.");
    CHECK(rows.notes.empty());
    REQUIRE(rows.sections.size() == 1);
    CHECK(rows.sections[0].rows.size() == 1);
    CHECK(rows.sections[0].rows[0].first == "no weld");
    CHECK(rows.sections[0].rows[0].difference.empty());
}

} // namespace meltpool
