#include "core/weld/gauge/weld_figures.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace meltpool {

namespace {

constexpr double kMmPerMetre = 1e3;

/// Length of outline, mm, along which layers of particles are one more or one less, by half a spacing.
constexpr double kOutline = 8 * kResolvedSpacings;

/// A difference of `much` is one for which an inspector would speak of another weld: chosen for this program.
constexpr std::array kStationFigures{
    WeldFigure{.key = "toe_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::toeWidth},
    WeldFigure{
        .key = "fused_width_mm", .unit = "mm", .resolution = kResolvedSpacings, .member = &WeldStation::fusedWidth},
    WeldFigure{.key = "height_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::height},
    WeldFigure{.key = "leg1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg1},
    WeldFigure{.key = "leg2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 1, .isSize = true},
               .member = &WeldStation::leg2},
    WeldFigure{.key = "throat_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::throat},
    WeldFigure{.key = "convexity_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5},
               .member = &WeldStation::convexity},
    WeldFigure{.key = "penetration_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .isSize = true},
               .member = &WeldStation::penetration},
    WeldFigure{.key = "root_fused_percent",
               .unit = "%",
               .digits = 0,
               .scale = {.much = 20, .least = 5},
               .member = &WeldStation::rootFused},
    WeldFigure{.key = "root_fusion_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5},
               .member = &WeldStation::rootFusion},
    WeldFigure{.key = "faces_fused_percent", .unit = "%", .digits = 0, .member = &WeldStation::facesFused},
    WeldFigure{.key = "lack_of_fusion_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::lackOfFusion},
    WeldFigure{.key = "root_missing_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::rootMissing},
    WeldFigure{.key = "edge_angle_1_deg", .unit = "deg", .member = &WeldStation::edgeAngle1},
    WeldFigure{.key = "edge_angle_2_deg", .unit = "deg", .member = &WeldStation::edgeAngle2},
    WeldFigure{.key = "overlap_1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap1},
    WeldFigure{.key = "overlap_2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::overlap2},
    WeldFigure{.key = "undercut_1_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut1},
    WeldFigure{.key = "undercut_2_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.3, .onlyOver = true},
               .member = &WeldStation::undercut2},
    WeldFigure{.key = "underfill_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::underfill},
    WeldFigure{.key = "excess_penetration_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::excessPenetration},
    WeldFigure{
        .key = "root_width_mm", .unit = "mm", .resolution = kResolvedSpacings, .member = &WeldStation::rootWidth},
    WeldFigure{.key = "root_concavity_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::rootConcavity},
    WeldFigure{.key = "hole_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 0.5, .onlyOver = true},
               .member = &WeldStation::hole},
    WeldFigure{.key = "deposited_mm2",
               .unit = "mm2",
               .resolution = kOutline,
               .scale = {.much = 8},
               .member = &WeldStation::deposited},
    WeldFigure{.key = "middle_mm", .unit = "mm", .resolution = kResolvedSpacings, .member = &WeldStation::middle},
    WeldFigure{.key = "haz_width_mm",
               .unit = "mm",
               .resolution = kResolvedSpacings,
               .scale = {.much = 1},
               .member = &WeldStation::hazWidth},
    WeldFigure{.key = "t85_s", .unit = "s", .scale = {.much = 3, .least = 0.5}, .member = &WeldStation::coolingTime},
};

constexpr std::array kWholeWeldFigures{
    WeldFigure{.key = "straightness_mm", .unit = "mm", .whole = &WeldMeasures::straightness},
    WeldFigure{.key = "crater_depth_mm", .unit = "mm", .whole = &WeldMeasures::craterDepth},
    WeldFigure{.key = "stations", .unit = "", .digits = 0},
    WeldFigure{.key = "pitch_mm", .unit = "mm"},
    WeldFigure{.key = "spacing_mm", .unit = "mm"},
};

/// Without toes the width is unknown.
void takeBead(const BeadShape& bead, const std::optional<FaceStretch>& fused, WeldStation& station) {
    if (bead.toes || !fused) station.toeWidth = bead.toeWidth();
    station.height = bead.height;
    if (bead.toes) {
        station.edgeAngle1 = (*bead.toes)[0].angle;
        station.edgeAngle2 = (*bead.toes)[1].angle;
        station.middle = 0.5 * ((*bead.toes)[0].place + (*bead.toes)[1].place);
        station.overlap1 = fused ? fused->low - bead.cover.low : 0.5 * bead.cover.length();
        station.overlap2 = fused ? bead.cover.high - fused->high : 0.5 * bead.cover.length();
    } else if (fused) {
        station.middle = 0.5 * (fused->low + fused->high);
    }
}

void takeButt(const Section& section, WeldStation& station) {
    station.rootFused = section.rootFused;
    station.facesFused = section.facesFused;
    station.rootConcavity = section.rootConcavity;
    if (!section.unfusedEdges) return;
    const auto [less, more] = std::minmax((*section.unfusedEdges)[0], (*section.unfusedEdges)[1]);
    station.rootMissing = less > 0 ? less : -section.root.height;
    station.lackOfFusion = more > 0 ? more - less : -section.root.height;
}

/// Returns the length of a fillet's face that is not fused from the corner outwards.
double unfusedFrom(const FaceStretch& fused, double leg) {
    return fused.length() > 0 ? std::min(fused.low, leg) : leg;
}

void takeFillet(const Section& section, WeldStation& station) {
    const FilletShape fillet = section.fillet.value_or(FilletShape{});
    station.leg1 = fillet.toes[0].place;
    station.leg2 = fillet.toes[1].place;
    station.throat = fillet.throat;
    station.convexity = fillet.convexity;
    station.toeWidth = fillet.faceWidth();
    station.rootFused = section.rootFused;
    station.facesFused = section.facesFused;
    station.rootFusion = section.rootFusion;
    if (section.fillet) {
        station.edgeAngle1 = fillet.toes[0].angle;
        if (!section.coveredEdge) station.edgeAngle2 = fillet.toes[1].angle;
        station.middle = (*station.leg1 - *station.leg2) / (2 * std::numbers::sqrt2);
    }
    if (!section.fusedFaces) return;
    const auto& [base, upright] = *section.fusedFaces;
    const double unfused = std::max(unfusedFrom(base, *station.leg1), unfusedFrom(upright, *station.leg2));
    station.lackOfFusion = unfused > 0 ? unfused : -section.rootFusion.value_or(0);
    if (!section.fillet) return;
    station.overlap1 = *station.leg1 - base.high;
    station.overlap2 = section.coveredEdge.value_or(*station.leg2) - upright.high;
}

} // namespace

WeldStation stationOf(const Section& section, WeldKind kind, double place) {
    WeldStation station;
    station.place = place;
    if (section.layers == 0) return station;
    station.fusedWidth = section.fusion.width;
    station.penetration = section.fusion.depth;
    station.undercut1 = section.undercut[0];
    station.undercut2 = section.undercut[1];
    if (!section.openCorner) {
        station.excessPenetration = section.root.height;
        station.rootWidth = section.root.toeWidth();
    }
    station.hole = section.hole;
    station.deposited = section.deposited;
    if (section.heatAffected)
        station.hazWidth = std::max(0.5 * (section.heatAffected->width - section.fusion.width), 0.0);
    station.coolingTime = section.coolingTime;
    if (kind == WeldKind::fillet) {
        takeFillet(section, station);
        return station;
    }
    takeBead(section.bead.value_or(BeadShape{}), section.fusedTop, station);
    station.underfill = section.underfill;
    if (kind == WeldKind::butt) {
        takeButt(section, station);
        return station;
    }
    station.facesFused = section.fusion.depth > 0 ? 1 : 0;
    station.lackOfFusion = section.fusion.depth > 0 ? -section.fusion.depth : station.toeWidth.value_or(0);
    return station;
}

double WeldFigure::inSi() const {
    if (unit == "mm") return 1e-3;
    if (unit == "mm2") return 1e-6;
    if (unit == "deg") return std::numbers::pi / 180;
    return unit == "%" ? 0.01 : 1;
}

std::string_view WeldFigure::wordsOf(std::string_view place) const {
    const std::string* words = findPhrase(std::string(table).append(key).append(".").append(place));
    return words != nullptr ? std::string_view(*words) : std::string_view();
}

std::string_view WeldFigure::panelWords() const {
    const std::string_view words = wordsOf("panel");
    return words.empty() ? name() : words;
}

std::string_view WeldFigure::pageWords() const {
    const std::string_view words = wordsOf("page");
    return words.empty() ? name() : words;
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

double gaugeErrorOf(const WeldFigure& imperfection, double spacing) {
    if (imperfection.unit == "deg") return kGaugeAngle;
    return imperfection.gaugeError * spacing * kMmPerMetre;
}

} // namespace meltpool
