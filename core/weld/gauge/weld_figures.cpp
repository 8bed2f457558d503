#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace meltpool {

namespace {

constexpr double kMmPerMetre = 1e3;

using Value = WeldStation::Value;
using Member = Value WeldStation::*;
using Judged = std::optional<ImperfectionValue>;

Judged inMm(const Value& metres, const Value& width = {}) {
    if (!metres) return std::nullopt;
    return ImperfectionValue{*metres * kMmPerMetre, width.value_or(0) * kMmPerMetre};
}

Value greater(const Value& a, const Value& b) {
    return a && b ? std::max(*a, *b) : a ? a : b;
}

/// A figure of the station; `width` is the b with which its limit may grow.
template <Member figure, Member width = nullptr>
Judged measured(const WeldStation& s, const NominalWeld&, WeldKind) {
    if constexpr (width == nullptr)
        return inMm(s.*figure);
    else
        return inMm(s.*figure, s.*width);
}

/// The greater figure of both sides of the weld.
template <Member side1, Member side2>
Judged worseSide(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(greater(s.*side1, s.*side2), s.toeWidth);
}

/// A size of the workpiece as it was set up.
template <double NominalWeld::*size>
Judged setUp(const WeldStation&, const NominalWeld& nominal, WeldKind) {
    return inMm(nominal.*size);
}

/// Where a plate is fused nowhere, which may be a place without weld, all of the nominal weld is missing.
Judged lackOfFusion(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    if (!s.lackOfFusion || !s.facesFused || *s.facesFused > 0) return inMm(s.lackOfFusion);
    return inMm(std::max(*s.lackOfFusion, nominal.legOf().value_or(nominal.thickness)));
}

Judged toeAngle(const WeldStation& s, const NominalWeld&, WeldKind) {
    const Value inside = greater(s.edgeAngle1, s.edgeAngle2);
    if (!inside) return std::nullopt;
    return ImperfectionValue{180 - *inside * 180 / std::numbers::pi, s.toeWidth.value_or(0) * kMmPerMetre};
}

Judged unequalLegs(const WeldStation& s, const NominalWeld&, WeldKind) {
    return s.leg1 && s.leg2 ? inMm(std::abs(*s.leg1 - *s.leg2)) : std::nullopt;
}

Judged throatTooSmall(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto throat = nominal.throatOf(kind);
    return s.throat && throat ? inMm(*throat - *s.throat) : std::nullopt;
}

Judged throatTooBig(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto throat = nominal.throatOf(kind);
    return s.throat && throat ? inMm(*s.throat - *throat) : std::nullopt;
}

Judged legTooSmall(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    const auto leg = nominal.legOf();
    return s.leg1 && s.leg2 && leg ? inMm(*leg - std::min(*s.leg1, *s.leg2)) : std::nullopt;
}

constexpr double kHalf = kResolvedSpacings;
/// An overlap is the distance between two places, each known to half a spacing.
constexpr double kTwoPlaces = 2 * kResolvedSpacings;
/// mm of outline along which layers of particles are one more or one less, by half a spacing.
constexpr double kOutline = 8 * kResolvedSpacings;

/// A difference of `much` is one after which an inspector would speak of another weld: chosen for this program.
constexpr std::array kStationFigures{
    WeldFigure{.key = "toe_width_mm",
               .unit = "mm",
               .resolution = kHalf,
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
               .resolution = kHalf,
               .words = {.name = "fused width", .drawn = "fused width"},
               .member = &WeldStation::fusedWidth},
    WeldFigure{.key = "height_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "reinforcement",
                         .more = "higher",
                         .less = "lower",
                         .panel = "height over the plate",
                         .drawn = "height"},
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::height},
    WeldFigure{.key = "leg1_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "leg on the lying plate",
                         .more = "more leg on the lying plate",
                         .less = "less leg on the lying plate",
                         .drawn = "leg"},
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg1},
    WeldFigure{.key = "leg2_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "leg on the standing plate",
                         .more = "more leg on the standing plate",
                         .less = "less leg on the standing plate",
                         .drawn = "leg"},
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg2},
    WeldFigure{.key = "throat_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "throat", .more = "more throat", .less = "less throat", .drawn = "throat"},
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::throat},
    WeldFigure{.key = "convexity_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "convexity", .more = "more convex", .less = "less convex", .drawn = "convexity"},
               .scale = {.much = 0.5},
               .member = &WeldStation::convexity},
    WeldFigure{.key = "penetration_mm",
               .unit = "mm",
               .resolution = kHalf,
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
               .resolution = kHalf,
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
               .resolution = kHalf,
               .words = {.name = "lack of fusion",
                         .more = "more lack of fusion",
                         .less = "less lack of fusion",
                         .page = "lack of fusion (below 0: fused beyond)",
                         .drawn = "not fused"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::lackOfFusion},
    WeldFigure{.key = "root_missing_mm",
               .unit = "mm",
               .resolution = kHalf,
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
               .resolution = kHalf,
               .words = {.name = "overlap on side 1",
                         .more = "more overlap on side 1",
                         .less = "less overlap on side 1",
                         .page = "overlap, side 1 (below 0: none)",
                         .drawn = "overlap"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap1},
    WeldFigure{.key = "overlap_2_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "overlap on side 2",
                         .more = "more overlap on side 2",
                         .less = "less overlap on side 2",
                         .page = "overlap, side 2 (below 0: none)",
                         .drawn = "overlap"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap2},
    WeldFigure{.key = "undercut_1_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "undercut on side 1",
                         .more = "more undercut on side 1",
                         .less = "less undercut on side 1",
                         .page = "undercut, side 1",
                         .drawn = "undercut"},
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut1},
    WeldFigure{.key = "undercut_2_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "undercut on side 2",
                         .more = "more undercut on side 2",
                         .less = "less undercut on side 2",
                         .page = "undercut, side 2",
                         .drawn = "undercut"},
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut2},
    WeldFigure{.key = "underfill_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "underfill", .more = "more underfill", .less = "less underfill", .drawn = "underfill"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::underfill},
    WeldFigure{.key = "excess_penetration_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "excess penetration",
                         .more = "more excess penetration",
                         .less = "less excess penetration",
                         .panel = "root: metal under the plate",
                         .drawn = "root"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::excessPenetration},
    WeldFigure{.key = "root_width_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "root's breadth", .drawn = "root width"},
               .member = &WeldStation::rootWidth},
    WeldFigure{.key = "root_concavity_mm",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "root concavity",
                         .more = "more root concavity",
                         .less = "less root concavity",
                         .drawn = "hollow root"},
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::rootConcavity},
    WeldFigure{
        .key = "hole_mm",
        .unit = "mm",
        .resolution = kHalf,
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
               .resolution = kHalf,
               .words = {.name = "middle of the weld beside the seam"},
               .member = &WeldStation::middle},
    WeldFigure{.key = "haz_width_mm",
               .unit = "mm",
               .resolution = kHalf,
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

constexpr std::array kImperfections{
    WeldFigure{.key = "lack_of_fusion",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "lack of fusion"},
               .standard = {"401", "lack of fusion"},
               .judged = lackOfFusion},
    WeldFigure{.key = "burn_through",
               .unit = "mm",
               .words = {.name = "burn through"},
               .standard = {"510", "burn-through"},
               .judged = measured<&WeldStation::hole>},
    WeldFigure{.key = "root_penetration_missing",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "root penetration missing"},
               .standard = {"4021", "incomplete root penetration"},
               .judged = measured<&WeldStation::rootMissing>},
    WeldFigure{.key = "undercut",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "undercut"},
               .standard = {"5011, 5012", "undercut"},
               .judged = worseSide<&WeldStation::undercut1, &WeldStation::undercut2>},
    WeldFigure{.key = "excess_weld_metal",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "excess weld metal"},
               .standard = {"502", "excess weld metal"},
               .judged = measured<&WeldStation::height, &WeldStation::toeWidth>},
    WeldFigure{.key = "convexity",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "convexity"},
               .standard = {"503", "excessive convexity"},
               .judged = measured<&WeldStation::convexity, &WeldStation::toeWidth>},
    WeldFigure{.key = "excess_penetration",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "excess penetration"},
               .standard = {"504", "excess penetration"},
               .judged = measured<&WeldStation::excessPenetration, &WeldStation::rootWidth>},
    WeldFigure{.key = "toe_angle",
               .unit = "deg",
               .words = {.name = "toe angle"},
               .standard = {"505", "incorrect weld toe"},
               .judged = toeAngle},
    WeldFigure{.key = "overlap",
               .unit = "mm",
               .resolution = kTwoPlaces,
               .words = {.name = "overlap"},
               .standard = {"506", "overlap"},
               .judged = worseSide<&WeldStation::overlap1, &WeldStation::overlap2>},
    WeldFigure{.key = "unequal_legs",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "unequal legs"},
               .standard = {"512", "excessive asymmetry of fillet weld"},
               .judged = unequalLegs},
    WeldFigure{.key = "not_filled_up",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "not filled up"},
               .standard = {"511", "incompletely filled groove"},
               .judged = measured<&WeldStation::underfill>},
    WeldFigure{.key = "root_concavity",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "root concavity"},
               .standard = {"515", "root concavity"},
               .judged = measured<&WeldStation::rootConcavity>},
    WeldFigure{.key = "throat_too_small",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "throat too small"},
               .standard = {"5213", "insufficient throat thickness"},
               .judged = throatTooSmall},
    WeldFigure{.key = "throat_too_big",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "throat too big"},
               .standard = {"5214", "excessive throat thickness"},
               .judged = throatTooBig},
    WeldFigure{.key = "leg_too_small",
               .unit = "mm",
               .resolution = kHalf,
               .words = {.name = "leg too small"},
               .judged = legTooSmall},
    WeldFigure{.key = "plates_offset",
               .unit = "mm",
               .words = {.name = "plates offset"},
               .standard = {"507", "linear misalignment"},
               .judged = setUp<&NominalWeld::platesOffset>},
    WeldFigure{.key = "joint_gap",
               .unit = "mm",
               .words = {.name = "joint gap"},
               .standard = {"617", "incorrect root gap for fillet welds"},
               .judged = setUp<&NominalWeld::jointGap>},
    WeldFigure{.key = "crack", .unit = "mm", .words = {.name = "crack"}, .standard = {"100", "crack"}},
    WeldFigure{.key = "surface_pore",
               .unit = "mm",
               .words = {.name = "surface pore"},
               .standard = {"2017", "surface pore"},
               .estimate = "surface_pore"},
    WeldFigure{
        .key = "piping_porosity", .unit = "mm", .words = {.name = "piping porosity"}, .estimate = "surface_pore"},
    WeldFigure{.key = "unfilled_crater", .unit = "mm", .words = {.name = "unfilled crater"}},
    WeldFigure{.key = "spatter",
               .unit = "mm",
               .words = {.name = "spatter"},
               .standard = {"602", "spatter"},
               .estimate = "spatter"},
    WeldFigure{.key = "slag_inclusion",
               .unit = "mm",
               .words = {.name = "slag inclusion"},
               .standard = {"301", "slag inclusion"},
               .estimate = "slag_inclusion"},
};

const WeldFigure* find(std::span<const WeldFigure> rows, std::string_view key) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const WeldFigure& each) { return each.key == key; });
    return found == rows.end() ? nullptr : &*found;
}

} // namespace

std::optional<double> NominalWeld::throatOf(WeldKind kind) const {
    if (throat) return throat;
    if (leg) return *leg / std::numbers::sqrt2;
    return kind == WeldKind::butt ? std::optional(thickness) : std::nullopt;
}

std::optional<double> NominalWeld::legOf() const {
    if (leg) return leg;
    return throat ? std::optional(*throat * std::numbers::sqrt2) : std::nullopt;
}

double WeldFigure::inSi() const {
    if (unit == "mm") return 1e-3;
    if (unit == "mm2") return 1e-6;
    if (unit == "deg") return std::numbers::pi / 180;
    return unit == "%" ? 0.01 : 1;
}

std::span<const WeldFigure> stationFigures() {
    return kStationFigures;
}

const WeldFigure* findStationFigure(std::string_view key) {
    return find(kStationFigures, key);
}

const WeldFigure& stationFigure(WeldStation::Value WeldStation::*member) {
    for (const WeldFigure& each : kStationFigures)
        if (each.member == member) return each;
    throw std::out_of_range("the table of weld figures lacks a member of WeldStation");
}

std::span<const WeldFigure> wholeWeldFigures() {
    return kWholeWeldFigures;
}

std::span<const WeldFigure> imperfections() {
    return kImperfections;
}

const WeldFigure* findImperfection(std::string_view key) {
    return find(kImperfections, key);
}

std::string imperfectionName(std::string_view key) {
    if (const WeldFigure* known = findImperfection(key)) return std::string(known->words.name);
    std::string name(key);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

double resolvedOf(const WeldFigure& figure, double spacing) {
    if (figure.unit == "deg") return kResolvedAngle;
    return figure.resolution * spacing * kMmPerMetre;
}

} // namespace meltpool
