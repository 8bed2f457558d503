// Comparison of two attempts in words: resolved differences, the heaviest first, and no others.
#include "core/training/attempt/differences.hpp"

#include "core/base/words.hpp"
#include "core/training/judging/bands.hpp"
#include "tests/support/catch.hpp"

#include <set>

using namespace meltpool;

namespace {

AttemptFigures figures(double penetration, double width, double score) {
    AttemptFigures made;
    made.spacing = 0.5e-3;
    made.values = {
        {"penetration_mm", penetration}, {"toe_width_mm", width}, {"undercut_1_mm", -1}, {"travel_speed", 8}};
    made.score = score;
    made.points = {{"travel_speed", score}};
    return made;
}

} // namespace

TEST_CASE("every figure that is compared has its words once", "[training][comparison]") {
    for (const DistanceKind kind : {DistanceKind::ctwd, DistanceKind::arcLength}) {
        std::set<std::string> keys;
        for (const ComparedFigure& figure : comparedFigures(kind)) {
            INFO(figure.key);
            CHECK(keys.insert(figure.key).second);
            CHECK_FALSE(figure.name.empty());
            CHECK_FALSE(figure.unit.empty());
            const std::string *more = findPhrase("figure." + figure.key + ".more"),
                              *less = findPhrase("figure." + figure.key + ".less");
            REQUIRE((more != nullptr && less != nullptr));
            CHECK(*more != *less);
            CHECK(more->find_first_of("<&") == std::string::npos); // HTML contains these words too
            CHECK(less->find_first_of("<&") == std::string::npos);
            CHECK(figure.much > 0);
            CHECK(figure.resolution + figure.least > 0);
        }
        for (const QuantityInfo& info : quantities(kind))
            if (!info.key.empty()) CHECK(keys.count(std::string(info.key)) == 1);
    }
}

TEST_CASE("differences are told with number, unit and the field's word, the heaviest first", "[training][comparison]") {
    const Comparison made = compareAttempts(figures(2, 8, 70), figures(2.4, 6.9, 82));
    CHECK(comparisonText(made) == "1.1 mm narrower, 0.4 mm more penetration, score +12");
    CHECK(made.halfSpacing == Approx(0.25e-3));
    REQUIRE(made.scores.size() == 2);
    CHECK(made.scores[0].name == "score");
    CHECK(made.scores[1].name == "travel speed");
    CHECK(*made.scores[1].second == 82);
    CHECK(comparisonText(made, 1) == "1.1 mm narrower, score +12, 1 smaller difference");
}

TEST_CASE("less than half a spacing is no difference, and neither is the same attempt", "[training][comparison]") {
    const AttemptFigures first = figures(2, 8, 70);
    CHECK(comparisonText(compareAttempts(first, first)) == "no difference that the metal resolves");
    CHECK(compareAttempts(first, figures(2.2, 7.8, 70.5)).differences().empty());
    CHECK_FALSE(compareAttempts(first, figures(2.2, 7.8, 70.5)).morePoints());
    CHECK(compareAttempts(first, figures(2.3, 8, 70)).differences().size() == 1);
    // The coarser metal determines the resolution.
    AttemptFigures coarse = figures(2.3, 8, 70);
    coarse.spacing = 1e-3;
    CHECK(compareAttempts(first, coarse).differences().empty());
}

TEST_CASE("an undercut that is not there does not differ, however far away it is", "[training][comparison]") {
    AttemptFigures first = figures(2, 8, 70), second = figures(2, 8, 70);
    first.values["undercut_1_mm"] = -3;
    CHECK(compareAttempts(first, second).differences().empty());
    second.values["undercut_1_mm"] = 0.6;
    const Comparison made = compareAttempts(first, second);
    REQUIRE(made.differences().size() == 1);
    CHECK(differenceText(made.differences()[0]) == "0.6 mm more undercut on side 1");
    CHECK(made.pairs.size() == 4); // every figure of both remains available
}

TEST_CASE("what only one attempt has is not compared", "[training][comparison]") {
    AttemptFigures first = figures(2, 8, 70), second = figures(3, 8, 70);
    first.values.erase("penetration_mm");
    second.score.reset();
    second.points.clear();
    const Comparison made = compareAttempts(first, second);
    CHECK(comparisonText(made) == "no difference that the metal resolves");
    REQUIRE(made.scores.size() == 2);
    CHECK_FALSE(made.scores[0].second);
    CHECK(*made.scores[0].first == 70);
}

TEST_CASE("figures are those of the judgement, in their units", "[training][comparison]") {
    Judgement judgement;
    WeldStation station;
    station.penetration = 2e-3;
    station.rootFused = 0.5;
    judgement.weld = summarise({station}, WeldKind::bead, 2e-3, 1e-3);
    SeamMillimetre place;
    place.judged = true;
    place.values[TechniqueQuantity::travelSpeed] = 6e-3;
    judgement.seam = {place, place};
    judgement.seam.emplace_back(); // not judged, so not in the mean
    judgement.arc = {2, 400, 9000};
    TechniqueScore score;
    score.scored = true;
    score.total = 64;
    score.parameters.push_back({TechniqueQuantity::travelSpeed, 55});
    judgement.score = score;
    const AttemptFigures made = figuresOf(judgement, ProcessSettings{});
    CHECK(made.spacing == 1e-3);
    CHECK(made.values.at("penetration_mm") == Approx(2));
    CHECK(made.values.at("root_fused_percent") == Approx(50));
    CHECK(made.values.at("travel_speed") == Approx(6));
    CHECK(made.values.at("mean_current_a") == Approx(200));
    CHECK(made.values.at("mean_voltage_v") == Approx(22.5));
    CHECK(*made.score == 64);
    CHECK(made.points.at("travel_speed") == 55);
    CHECK(made.values.count("toe_width_mm") == 0);
}
