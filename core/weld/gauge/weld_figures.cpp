#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace meltpool {

namespace {

constexpr double kMmPerMetre = 1e3;

/// mm of outline along which layers of particles are one more or one less, by half a spacing.
constexpr double kOutline = 8 * kResolvedSpacings;

/// A difference of `much` is one after which an inspector would speak of another weld: chosen for this program.
constexpr std::array kStationFigures{
    WeldFigure{.key = "toe_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "width",
                         .more = "wider",
                         .less = "narrower",
                         .panel = "width from toe to toe",
                         .page = "width, toe to toe",
                         .drawn = "toe to toe"},
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::toeWidth},
    WeldFigure{.key = "fused_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "fused width", .drawn = "fused width"},
               .member = &WeldStation::fusedWidth},
    WeldFigure{.key = "height_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "reinforcement",
                         .more = "higher",
                         .less = "lower",
                         .panel = "height over the plate",
                         .drawn = "height"},
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::height},
    WeldFigure{.key = "leg1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "leg on the lying plate",
                         .more = "more leg on the lying plate",
                         .less = "less leg on the lying plate",
                         .drawn = "leg"},
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg1},
    WeldFigure{.key = "leg2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "leg on the standing plate",
                         .more = "more leg on the standing plate",
                         .less = "less leg on the standing plate",
                         .drawn = "leg"},
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg2},
    WeldFigure{.key = "throat_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "throat", .more = "more throat", .less = "less throat", .drawn = "throat"},
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::throat},
    WeldFigure{.key = "convexity_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "convexity", .more = "more convex", .less = "less convex", .drawn = "convexity"},
               .scale = {.much = 0.5},
               .member = &WeldStation::convexity},
    WeldFigure{.key = "penetration_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "penetration",
                         .more = "more penetration",
                         .less = "less penetration",
                         .drawn = "penetration"},
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::penetration},
    WeldFigure{.key = "root_fused_percent",
               .unit = "%",
               .digits = 0,
               .words = {.name = "fused root",
                         .more = "more of the root fused",
                         .less = "less of the root fused",
                         .panel = "root fused",
                         .page = "root fused"},
               .scale = {.much = 20, .least = 5},
               .member = &WeldStation::rootFused},
    WeldFigure{.key = "root_fusion_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "root fusion",
                         .more = "more root fusion",
                         .less = "less root fusion",
                         .page = "root fused beyond the corner by",
                         .drawn = "root fused"},
               .scale = {.much = 0.5},
               .member = &WeldStation::rootFusion},
    WeldFigure{.key = "faces_fused_percent",
               .unit = "%",
               .digits = 0,
               .words = {.name = "faces fused", .panel = "both plates fused"},
               .member = &WeldStation::facesFused},
    WeldFigure{.key = "lack_of_fusion_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "lack of fusion",
                         .more = "more lack of fusion",
                         .less = "less lack of fusion",
                         .page = "lack of fusion (below 0: fused beyond)",
                         .drawn = "not fused"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::lackOfFusion},
    WeldFigure{.key = "root_missing_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "missing root",
                         .more = "more of the root missing",
                         .less = "less of the root missing",
                         .page = "root missing (below 0: fused beyond)",
                         .drawn = "not fused"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::rootMissing},
    WeldFigure{.key = "edge_angle_1_deg",
               .unit = "deg",
               .words = {.name = "edge angle, side 1", .drawn = "angle"},
               .member = &WeldStation::edgeAngle1},
    WeldFigure{.key = "edge_angle_2_deg",
               .unit = "deg",
               .words = {.name = "edge angle, side 2", .drawn = "angle"},
               .member = &WeldStation::edgeAngle2},
    WeldFigure{.key = "overlap_1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "overlap on side 1",
                         .more = "more overlap on side 1",
                         .less = "less overlap on side 1",
                         .page = "overlap, side 1 (below 0: none)",
                         .drawn = "overlap"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap1},
    WeldFigure{.key = "overlap_2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "overlap on side 2",
                         .more = "more overlap on side 2",
                         .less = "less overlap on side 2",
                         .page = "overlap, side 2 (below 0: none)",
                         .drawn = "overlap"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap2},
    WeldFigure{.key = "undercut_1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "undercut on side 1",
                         .more = "more undercut on side 1",
                         .less = "less undercut on side 1",
                         .page = "undercut, side 1",
                         .drawn = "undercut"},
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut1},
    WeldFigure{.key = "undercut_2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "undercut on side 2",
                         .more = "more undercut on side 2",
                         .less = "less undercut on side 2",
                         .page = "undercut, side 2",
                         .drawn = "undercut"},
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut2},
    WeldFigure{.key = "underfill_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "underfill", .more = "more underfill", .less = "less underfill", .drawn = "underfill"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::underfill},
    WeldFigure{.key = "excess_penetration_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "excess penetration",
                         .more = "more excess penetration",
                         .less = "less excess penetration",
                         .panel = "root: metal under the plate",
                         .drawn = "root"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::excessPenetration},
    WeldFigure{.key = "root_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "root's breadth", .drawn = "root width"},
               .member = &WeldStation::rootWidth},
    WeldFigure{.key = "root_concavity_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "root concavity",
                         .more = "more root concavity",
                         .less = "less root concavity",
                         .drawn = "hollow root"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::rootConcavity},
    WeldFigure{
        .key = "hole_mm",
        .unit = "mm",
        .resolution = kResolvedSpacings,
        .words = {.name = "burn-through", .more = "more burn-through", .less = "less burn-through", .drawn = "open"},
        .scale = {.much = 0.5, .onlyOver = true},
        .member = &WeldStation::hole},
    WeldFigure{.key = "deposited_mm2",
               .unit = "mm2",
               .resolution = kOutline,
               .words = {.name = "deposited metal",
                         .more = "more deposited metal",
                         .less = "less deposited metal",
                         .page = "section of deposited metal"},
               .scale = {.much = 8},
               .member = &WeldStation::deposited},
    WeldFigure{.key = "middle_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "middle of the weld beside the seam"},
               .member = &WeldStation::middle},
    WeldFigure{.key = "haz_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .words = {.name = "heat-affected zone",
                         .more = "more heat-affected zone",
                         .less = "less heat-affected zone",
                         .panel = "heat-affected zone on each side"},
               .scale = {.much = 1},
               .member = &WeldStation::hazWidth},
    WeldFigure{.key = "t85_s",
               .unit = "s",
               .words = {.name = "cooling time t8/5",
                         .more = "longer cooling (t8/5)",
                         .less = "shorter cooling (t8/5)",
                         .panel = "cooling from 800 to 500 °C",
                         .page = "cooling from 800 to 500 °C"},
               .scale = {.much = 3, .least = 0.5},
               .member = &WeldStation::coolingTime},
};

constexpr std::array kWholeWeldFigures{
    WeldFigure{.key = "straightness_mm",
               .unit = "mm",
               .words = {.name = "distance from a straight line", .panel = "off a straight line"},
               .whole = &WeldMeasures::straightness},
    WeldFigure{.key = "stations", .unit = "", .digits = 0, .words = {.name = "sections measured"}},
    WeldFigure{.key = "pitch_mm", .unit = "mm", .words = {.name = "seam that each stands for"}},
    WeldFigure{.key = "spacing_mm", .unit = "mm", .words = {.name = "particles lie apart"}},
};

} // namespace

double WeldFigure::inSi() const {
    if (unit == "mm") return 1e-3;
    if (unit == "mm2") return 1e-6;
    if (unit == "deg") return std::numbers::pi / 180;
    return unit == "%" ? 0.01 : 1;
}

const WeldFigure* findByKey(std::span<const WeldFigure> rows, std::string_view key) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const WeldFigure& each) { return each.key == key; });
    return found == rows.end() ? nullptr : &*found;
}

std::span<const WeldFigure> stationFigures() {
    return kStationFigures;
}

const WeldFigure* findStationFigure(std::string_view key) {
    return findByKey(kStationFigures, key);
}

const WeldFigure& stationFigure(WeldStation::Value WeldStation::*member) {
    for (const WeldFigure& each : kStationFigures)
        if (each.member == member) return each;
    throw std::out_of_range("the table of weld figures lacks a member of WeldStation");
}

std::span<const WeldFigure> wholeWeldFigures() {
    return kWholeWeldFigures;
}

double resolvedOf(const WeldFigure& figure, double spacing) {
    if (figure.unit == "deg") return kResolvedAngle;
    return figure.resolution * spacing * kMmPerMetre;
}

} // namespace meltpool
