// The imperfections of the table of weld figures, each with its measure at a station.
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMmPerMetre = 1e3;

using Value = WeldStation::Value;
using Member = Value WeldStation::*;
using Judged = std::optional<ImperfectionValue>;

constexpr double kUprightToe = 90; ///< degrees

/// A station alone resolves a length no finer than one particle: its outline is a mean over five layers of metal in
/// disorder, and an extreme of many stations is their worst.
constexpr double kOneParticle = 1;

/// Errors of the gauge on known shapes, in spacings (tests/weld/gauge/weld_shape_test.cpp). Lengths that no known shape
/// was measured for have kResolvedSpacings.
constexpr double kThroatError = 0.15;
constexpr double kHeightError = 0.15; ///< moves the toe of an edge angle under 8.5 degrees by more than a particle
constexpr double kLegError = 0.2;
constexpr double kLegDifferenceError = 0.3; ///< of two legs

Judged inMm(const Value& metres, const Value& width = {}) {
    if (!metres) return std::nullopt;
    return ImperfectionValue{*metres * kMmPerMetre, width.value_or(0) * kMmPerMetre};
}

/// Takes the figure of the station; `width` is the b with which its limit may grow.
template <Member figure, Member width = nullptr>
Judged measured(const WeldStation& s, const NominalWeld&, WeldKind) {
    if constexpr (width == nullptr)
        return inMm(s.*figure);
    else
        return inMm(s.*figure, s.*width);
}

/// Takes a size of the workpiece as it was set up.
template <double NominalWeld::*size>
Judged setUp(const WeldStation&, const NominalWeld& nominal, WeldKind) {
    return inMm(nominal.*size);
}

/// A plate that is fused nowhere, perhaps at a place without weld, lacks all of the nominal weld.
Judged lackOfFusion(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    if (!s.lackOfFusion || !s.facesFused || *s.facesFused > 0) return inMm(s.lackOfFusion);
    return inMm(std::max(*s.lackOfFusion, nominal.legOf().value_or(nominal.thickness)));
}

/// Toe angle outside the weld metal, degrees.
Value outerAngle(const Value& inside) {
    return inside ? Value(180 - *inside * 180 / std::numbers::pi) : std::nullopt;
}

template <Member edgeAngle>
Judged toeAngle(const WeldStation& s, const NominalWeld&, WeldKind) {
    const Value outside = outerAngle(s.*edgeAngle);
    if (!outside) return std::nullopt;
    return ImperfectionValue{*outside, s.toeWidth.value_or(0) * kMmPerMetre};
}

/// Metal that overlaps a plate stands over it at less than a right angle. Where the toe is flatter, what the gauge
/// takes for overlap is too little to see; where it is flatter by more than an angle's resolution there is none.
template <Member overlap, Member edgeAngle>
Judged overlapAt(const WeldStation& s, const NominalWeld&, WeldKind) {
    Judged found = inMm(s.*overlap, s.toeWidth);
    const Value angle = outerAngle(s.*edgeAngle);
    if (!found || !angle || *angle < kUprightToe) return found;
    found->value = std::min(found->value, 0.0);
    found->ruledOut = *angle >= kUprightToe + kResolvedAngle;
    return found;
}

/// Takes a leg whose toe has a place; nothing for metal that runs out too flat.
Value placedLeg(const Value& leg, const Value& edgeAngle) {
    return edgeAngle && *edgeAngle < std::atan(kHeightError / kOneParticle) ? std::nullopt : leg;
}

/// Takes the difference of the legs with its sign, so that a mean does not add up scatter.
template <bool other>
Judged excessiveAsymmetry(const WeldStation& s, const NominalWeld&, WeldKind) {
    const Value leg1 = placedLeg(s.leg1, s.edgeAngle1), leg2 = placedLeg(s.leg2, s.edgeAngle2);
    return leg1 && leg2 ? inMm(other ? *leg2 - *leg1 : *leg1 - *leg2) : std::nullopt;
}

/// Throat that a drawing asks for: the height of the largest triangle with two equal sides along the plates that the
/// fillet's section holds (nominal throat, ISO 2553). It reaches no farther along the plates than the shorter leg, so a
/// convex bead with short legs has less of it than of metal above the corner. A groove between two edges has no such
/// legs: they end with the edges.
Value inscribedThroat(const WeldStation& s, const NominalWeld& nominal) {
    Value throat = s.throat;
    if (!throat || nominal.betweenEdges) return throat;
    for (const Value& leg : {placedLeg(s.leg1, s.edgeAngle1), placedLeg(s.leg2, s.edgeAngle2)})
        if (leg) throat = std::min(*throat, *leg / std::numbers::sqrt2);
    return throat;
}

Judged insufficientThroat(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto asked = nominal.throatOf(kind);
    const Value throat = inscribedThroat(s, nominal);
    return throat && asked ? inMm(*asked - *throat) : std::nullopt;
}

Judged excessiveThroat(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto throat = nominal.throatOf(kind);
    return s.throat && throat ? inMm(*s.throat - *throat) : std::nullopt;
}

std::optional<PlacedImperfection> placedAtStop(const Judged& found, const WeldMeasures& weld) {
    return found ? std::optional(PlacedImperfection{*found, weld.stop}) : std::nullopt;
}

std::optional<PlacedImperfection> craterPit(const WeldMeasures& weld, const NominalWeld&) {
    return placedAtStop(inMm(weld.craterDepth), weld);
}

/// Missing size in the crater: of a fillet's throat; of other welds the depth under the plate.
std::optional<PlacedImperfection> craterLack(const WeldMeasures& weld, const NominalWeld& nominal) {
    const Value full = weld.kind == WeldKind::fillet ? nominal.throatOf(weld.kind) : Value(0.0);
    if (!full || !weld.craterSurface) return std::nullopt;
    return placedAtStop(inMm(*full - *weld.craterSurface), weld);
}

template <Member measuredLeg, Member edgeAngle>
Judged legTooSmall(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    const auto asked = nominal.legOf();
    const Value leg = placedLeg(s.*measuredLeg, s.*edgeAngle);
    return leg && asked ? inMm(*asked - *leg) : std::nullopt;
}

/// Rows whose words are among those of imperfections, not of figures.
template <size_t count>
constexpr std::array<WeldFigure, count> withTheirWords(std::array<WeldFigure, count> rows) {
    for (WeldFigure& each : rows)
        each.table = "imperfection.";
    return rows;
}

constexpr std::array kImperfections = withTheirWords(std::array{
    WeldFigure{.key = "lack_of_fusion",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"401", "lack of fusion"},
               .judged = lackOfFusion},
    WeldFigure{.key = "burn_through",
               .unit = "mm",
               .standard = {"510", "burn-through"},
               .judged = measured<&WeldStation::hole>},
    WeldFigure{.key = "root_penetration_missing",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"4021", "incomplete root penetration"},
               .judged = measured<&WeldStation::rootMissing>},
    WeldFigure{.key = "undercut",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"5011, 5012", "undercut"},
               .judged = measured<&WeldStation::undercut1, &WeldStation::toeWidth>,
               .judgedOther = measured<&WeldStation::undercut2, &WeldStation::toeWidth>},
    WeldFigure{.key = "excess_weld_metal",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kHeightError,
               .standard = {"502", "excess weld metal"},
               .judged = measured<&WeldStation::height, &WeldStation::toeWidth>},
    WeldFigure{.key = "convexity",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"503", "excessive convexity"},
               .judged = measured<&WeldStation::convexity, &WeldStation::toeWidth>},
    WeldFigure{.key = "excess_penetration",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"504", "excess penetration"},
               .judged = measured<&WeldStation::excessPenetration, &WeldStation::rootWidth>},
    WeldFigure{.key = "toe_angle",
               .unit = "deg",
               .standard = {"505", "incorrect weld toe"},
               .judged = toeAngle<&WeldStation::edgeAngle1>,
               .judgedOther = toeAngle<&WeldStation::edgeAngle2>},
    WeldFigure{.key = "overlap",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"506", "overlap"},
               .judged = overlapAt<&WeldStation::overlap1, &WeldStation::edgeAngle1>,
               .judgedOther = overlapAt<&WeldStation::overlap2, &WeldStation::edgeAngle2>},
    WeldFigure{.key = "excessive_asymmetry",
               .formerKey = "unequal_legs",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kLegDifferenceError,
               .standard = {"512", "excessive asymmetry of fillet weld"},
               .judged = excessiveAsymmetry<false>,
               .judgedOther = excessiveAsymmetry<true>},
    WeldFigure{.key = "incompletely_filled_groove",
               .formerKey = "not_filled_up",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"509, 511", "sagging, incompletely filled groove"},
               .judged = measured<&WeldStation::underfill>},
    WeldFigure{.key = "root_concavity",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kResolvedSpacings,
               .standard = {"515", "root concavity"},
               .judged = measured<&WeldStation::rootConcavity>},
    WeldFigure{.key = "insufficient_throat",
               .formerKey = "throat_too_small",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kThroatError,
               .standard = {"5213", "insufficient throat thickness"},
               .judged = insufficientThroat,
               .meanDecides = true},
    WeldFigure{.key = "excessive_throat",
               .formerKey = "throat_too_big",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kThroatError,
               .standard = {"5214", "excessive throat thickness"},
               .judged = excessiveThroat,
               .meanDecides = true},
    WeldFigure{.key = "leg_too_small",
               .unit = "mm",
               .resolution = kOneParticle,
               .gaugeError = kLegError,
               .judged = legTooSmall<&WeldStation::leg1, &WeldStation::edgeAngle1>,
               .judgedOther = legTooSmall<&WeldStation::leg2, &WeldStation::edgeAngle2>,
               .meanDecides = true},
    WeldFigure{.key = "linear_misalignment",
               .formerKey = "plates_offset",
               .unit = "mm",
               .standard = {"507", "linear misalignment"},
               .judged = setUp<&NominalWeld::linearMisalignment>},
    WeldFigure{.key = "joint_gap",
               .unit = "mm",
               .standard = {"617", "incorrect root gap for fillet welds"},
               .judged = setUp<&NominalWeld::jointGap>},
    WeldFigure{.key = "root_groove", .unit = "mm", .standard = {"5013", "shrinkage groove"}},
    WeldFigure{.key = "end_crater_pipe",
               .unit = "mm",
               .resolution = kOneParticle,
               .standard = {"2025", "end crater pipe"},
               .judgedWhole = craterPit},
    WeldFigure{.key = "poor_restart", .unit = "mm", .standard = {"517", "poor restart"}},
    WeldFigure{.key = "stray_arc", .unit = "mm", .standard = {"601", "stray arc"}},
    WeldFigure{.key = "crack", .unit = "mm", .standard = {"100", "crack"}},
    WeldFigure{.key = "surface_pore", .unit = "mm", .standard = {"2017", "surface pore"}, .estimate = "surface_pore"},
    WeldFigure{.key = "piping_porosity", .unit = "mm", .estimate = "surface_pore"},
    WeldFigure{.key = "unfilled_crater", .unit = "mm", .resolution = kOneParticle, .judgedWhole = craterLack},
    WeldFigure{.key = "spatter", .unit = "mm", .standard = {"602", "spatter"}, .estimate = "spatter"},
    WeldFigure{
        .key = "slag_inclusion", .unit = "mm", .standard = {"301", "slag inclusion"}, .estimate = "slag_inclusion"},
});

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

std::span<const WeldFigure> imperfections() {
    return kImperfections;
}

const WeldFigure* findImperfection(std::string_view key) {
    if (const WeldFigure* known = findByKey(kImperfections, key)) return known;
    for (const WeldFigure& each : kImperfections)
        if (!key.empty() && each.formerKey == key) return &each;
    return nullptr;
}

std::string imperfectionName(std::string_view key) {
    if (const WeldFigure* known = findImperfection(key)) return std::string(known->name());
    std::string name(key);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

} // namespace meltpool
