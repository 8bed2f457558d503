// The table of figures and imperfections: complete, with unique keys, units that keys name, and words.
#include "core/weld/gauge/weld_figures.hpp"

#include "core/base/words.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace meltpool;

namespace {

/// Returns the ending of a figure's key in files.
std::string endingOf(std::string_view unit) {
    if (unit == "%") return "_percent";
    return unit.empty() ? "" : "_" + std::string(unit);
}

WeldStation fillet() {
    WeldStation station;
    station.leg1 = 6e-3;
    station.leg2 = 4.5e-3;
    station.throat = 3.5e-3;
    station.toeWidth = 7e-3;
    station.overlap1 = -0.2e-3;
    station.overlap2 = 0.8e-3;
    station.undercut1 = 0.3e-3;
    station.edgeAngle1 = 2;
    station.edgeAngle2 = 1;
    return station;
}

std::optional<ImperfectionValue> judged(std::string_view key, const NominalWeld& nominal = {},
                                        const WeldStation& station = fillet()) {
    return findImperfection(key)->judged(station, nominal, WeldKind::fillet);
}

std::optional<ImperfectionValue> judgedOther(std::string_view key, const WeldStation& station = fillet()) {
    return findImperfection(key)->judgedOther(station, {}, WeldKind::fillet);
}

} // namespace

TEST_CASE("every member of a station has one row, whose key names the unit", "[figures]") {
    constexpr size_t kMembers = (sizeof(WeldStation) - sizeof(WeldStation::place)) / sizeof(WeldStation::Value);
    CHECK(stationFigures().size() == kMembers);
    std::set<std::string_view> keys;
    for (const WeldFigure& figure : stationFigures()) {
        INFO(figure.key);
        REQUIRE(figure.member != nullptr);
        CHECK(&stationFigure(figure.member) == &figure); // each member has a single row
        CHECK(findStationFigure(figure.key) == &figure);
        CHECK(keys.insert(figure.key).second);
        CHECK(figure.key.ends_with(endingOf(figure.unit)));
        CHECK_FALSE(figure.name().empty());
        CHECK_FALSE(figure.pageWords().empty());
        for (const char* told : {".more", ".less"})
            CHECK((findPhrase("figure." + std::string(figure.key) + told) != nullptr) == (figure.scale.much > 0));
    }
    CHECK(stationFigure(&WeldStation::height).name() == "reinforcement");
    CHECK(stationFigure(&WeldStation::height).panelWords() == "height over the plate");
    CHECK(stationFigure(&WeldStation::height).pageWords() == "reinforcement"); // uses the general words
    CHECK(stationFigure(&WeldStation::middle).drawnWords().empty());
    for (const WeldFigure& figure : wholeWeldFigures())
        CHECK_FALSE(figure.name().empty());
    CHECK(findStationFigure("overlap") == nullptr);
}

TEST_CASE("every imperfection has one row with a name", "[figures]") {
    std::set<std::string_view> keys, names;
    for (const WeldFigure& each : imperfections()) {
        INFO(each.key);
        CHECK(findImperfection(each.key) == &each);
        CHECK(keys.insert(each.key).second);
        CHECK_FALSE(each.name().empty());
        CHECK(names.insert(each.name()).second);
        CHECK((each.unit == "mm" || each.unit == "deg"));
        CHECK(each.standard.number.empty() == each.standard.name.empty());
        CHECK(each.standard.number.find_first_not_of("0123456789, ") == std::string_view::npos);
        CHECK((each.judged == nullptr || each.judgedWhole == nullptr)); // belongs to a station or to the whole weld
        if (each.estimate.empty()) continue;
        CHECK_FALSE(each.isMeasured()); // imperfections inside the metal are not measured
        CHECK(findImperfection(each.estimate) != nullptr);
    }
    CHECK(imperfectionName("incompletely_filled_groove") == "incompletely filled groove");
    CHECK(imperfectionName("of_a_newer_program") == "of a newer program");
    // Files of earlier versions have other keys.
    CHECK(findImperfection("throat_too_small") == findImperfection("insufficient_throat"));
    CHECK(imperfectionName("plates_offset") == "linear misalignment");
    CHECK(findImperfection("") == nullptr);
}

TEST_CASE("an imperfection is in millimetres on each side, with the width of its limit", "[figures]") {
    CHECK(judged("undercut")->value == Approx(0.3));
    CHECK_FALSE(judgedOther("undercut"));
    CHECK(judged("undercut")->width == Approx(7));
    CHECK(judged("toe_angle")->value == Approx(180 - 2 * 57.29578));
    CHECK(judgedOther("toe_angle")->value == Approx(180 - 57.29578));
    CHECK(judged("excessive_asymmetry")->value == Approx(1.5));
    CHECK(judgedOther("excessive_asymmetry")->value == Approx(-1.5));
    CHECK_FALSE(judged("burn_through"));
    CHECK_FALSE(judged("insufficient_throat")); // no nominal throat
    NominalWeld nominal;
    nominal.throat = 4e-3;
    nominal.linearMisalignment = 0.5e-3;
    CHECK(judged("insufficient_throat", nominal)->value == Approx(4 - 4.5 / std::sqrt(2.0))); // by leg 2
    CHECK(judged("excessive_throat", nominal)->value == Approx(-0.5));
    CHECK(judged("linear_misalignment", nominal)->value == Approx(0.5));
    CHECK(findImperfection("crack")->judged == nullptr);
    nominal.leg = 5e-3; // leg 1 is 6 mm
    CHECK(judged("leg_too_small", nominal)->value == Approx(-1));
    // A toe that runs out at 8 degrees has no certain place: 0.15 particles of height move it by more than one.
    WeldStation flat = fillet();
    flat.edgeAngle1 = 8 / 57.29578;
    CHECK_FALSE(judged("leg_too_small", nominal, flat));
    CHECK_FALSE(judged("excessive_asymmetry", nominal, flat));
    CHECK_FALSE(judgedOther("excessive_asymmetry", flat));
    flat.edgeAngle1 = 9 / 57.29578;
    CHECK(judged("excessive_asymmetry", nominal, flat));
}

TEST_CASE("a fillet has the throat of the largest triangle with equal sides in it", "[figures]") {
    NominalWeld nominal;
    nominal.throat = 4e-3;
    WeldStation station = fillet(); // legs of 6 and 4.5 mm
    station.throat = 3.8e-3;        // a convex face: the legs hold 4.5 / sqrt(2) = 3.18 mm
    CHECK(judged("insufficient_throat", nominal, station)->value == Approx(4 - 4.5 / std::sqrt(2.0)));
    CHECK(judged("excessive_throat", nominal, station)->value == Approx(-0.2)); // all the metal over the corner
    nominal.betweenEdges = true; // an outside corner: the edges end its legs
    CHECK(judged("insufficient_throat", nominal, station)->value == Approx(0.2));
    nominal.betweenEdges = false;
    station.throat = 3e-3;                                                      // hollow: the face limits it
    CHECK(judged("insufficient_throat", nominal, station)->value == Approx(1));
    station.throat = 3.8e-3;
    station.edgeAngle2 = 8 / 57.29578; // this toe has no certain place, the other leg holds 4.24 mm
    CHECK(judged("insufficient_throat", nominal, station)->value == Approx(0.2));
    station.throat.reset();
    CHECK_FALSE(judged("insufficient_throat", nominal, station));
}

TEST_CASE("an overlap counts under a toe that stands over the plate, and a flat toe rules it out", "[figures]") {
    WeldStation station = fillet(); // side 1 overhangs by 2 rad, side 2 has a toe of 123 degrees
    CHECK(judged("overlap")->value == Approx(-0.2));
    CHECK_FALSE(judged("overlap")->ruledOut);
    CHECK(judgedOther("overlap")->value == 0);
    CHECK(judgedOther("overlap")->ruledOut);
    station.edgeAngle2 = 1.4; // 100 degrees: too near to 90 to be sure
    CHECK(judgedOther("overlap", station)->value == 0);
    CHECK_FALSE(judgedOther("overlap", station)->ruledOut);
    station.edgeAngle2 = 1.6;
    CHECK(judgedOther("overlap", station)->value == Approx(0.8));
    CHECK(judgedOther("overlap", station)->width == Approx(7));
    station.edgeAngle2.reset();
    CHECK(judgedOther("overlap", station)->value == Approx(0.8));
}

TEST_CASE("a station resolves a spacing of a length and 15 degrees, a mean the gauge's own error", "[figures]") {
    CHECK(resolvedOf(*findImperfection("undercut"), 1e-3) == Approx(1));
    CHECK(gaugeErrorOf(*findImperfection("undercut"), 1e-3) == Approx(0.5));
    CHECK(gaugeErrorOf(*findImperfection("insufficient_throat"), 2e-3) == Approx(0.3));
    CHECK(gaugeErrorOf(*findImperfection("leg_too_small"), 1e-3) == Approx(0.2));
    CHECK(gaugeErrorOf(*findImperfection("toe_angle"), 1e-3) == 6);
    CHECK(gaugeErrorOf(*findImperfection("burn_through"), 1e-3) == 0);
    CHECK(resolvedOf(stationFigure(&WeldStation::throat), 1e-3) == Approx(0.5));
    CHECK(resolvedOf(*findImperfection("overlap"), 1e-3) == Approx(1));
    CHECK(resolvedOf(*findImperfection("toe_angle"), 1e-3) == 15);
    CHECK(resolvedOf(*findImperfection("burn_through"), 1e-3) == 0);
    CHECK(resolvedOf(stationFigure(&WeldStation::deposited), 1e-3) == Approx(4));
    CHECK(stationFigure(&WeldStation::deposited).inSi() == 1e-6);
}
