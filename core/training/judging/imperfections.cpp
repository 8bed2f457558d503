#include "core/training/judging/imperfections.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kPerMetre = 1e3; ///< mm

using Told = std::optional<ImperfectionValue>;
using Value = WeldStation::Value;

Told inMm(const Value& metres, const Value& width = {}) {
    if (!metres) return std::nullopt;
    return ImperfectionValue{*metres * kPerMetre, width.value_or(0) * kPerMetre};
}

Value greater(const Value& a, const Value& b) {
    return a && b ? std::max(*a, *b) : a ? a : b;
}

/// Where a plate is fused nowhere, which may be a place without weld, all of the nominal weld is missing.
Told lackOfFusion(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    if (!s.lackOfFusion || !s.facesFused || *s.facesFused > 0) return inMm(s.lackOfFusion);
    return inMm(std::max(*s.lackOfFusion, nominal.legOf().value_or(nominal.thickness)));
}

Told burnThrough(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.hole);
}

Told rootMissing(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.rootMissing);
}

Told undercut(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(greater(s.undercut1, s.undercut2), s.toeWidth);
}

Told excessWeldMetal(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.height, s.toeWidth);
}

Told convexity(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.convexity, s.toeWidth);
}

Told excessPenetration(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.excessPenetration, s.rootWidth);
}

Told toeAngle(const WeldStation& s, const NominalWeld&, WeldKind) {
    const Value inside = greater(s.edgeAngle1, s.edgeAngle2);
    if (!inside) return std::nullopt;
    return ImperfectionValue{180 - *inside * 180 / std::numbers::pi, s.toeWidth.value_or(0) * kPerMetre};
}

Told overlap(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(greater(s.overlap1, s.overlap2), s.toeWidth);
}

Told unequalLegs(const WeldStation& s, const NominalWeld&, WeldKind) {
    return s.leg1 && s.leg2 ? inMm(std::abs(*s.leg1 - *s.leg2)) : std::nullopt;
}

Told notFilledUp(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.underfill);
}

Told rootConcavity(const WeldStation& s, const NominalWeld&, WeldKind) {
    return inMm(s.rootConcavity);
}

Told throatTooSmall(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto throat = nominal.throatOf(kind);
    return s.throat && throat ? inMm(*throat - *s.throat) : std::nullopt;
}

Told throatTooBig(const WeldStation& s, const NominalWeld& nominal, WeldKind kind) {
    const auto throat = nominal.throatOf(kind);
    return s.throat && throat ? inMm(*s.throat - *throat) : std::nullopt;
}

Told legTooSmall(const WeldStation& s, const NominalWeld& nominal, WeldKind) {
    const auto leg = nominal.legOf();
    return s.leg1 && s.leg2 && leg ? inMm(*leg - std::min(*s.leg1, *s.leg2)) : std::nullopt;
}

Told platesOffset(const WeldStation&, const NominalWeld& nominal, WeldKind) {
    return inMm(nominal.platesOffset);
}

Told jointGap(const WeldStation&, const NominalWeld& nominal, WeldKind) {
    return inMm(nominal.jointGap);
}

/// An overlap is the distance of two places that are each told to half a spacing.
constexpr double kTwoPlaces = 2 * kResolvedSpacings;

constexpr std::array kImperfections{
    Imperfection{"lack_of_fusion", "mm", kResolvedSpacings, lackOfFusion},
    Imperfection{"burn_through", "mm", 0, burnThrough},
    Imperfection{"root_penetration_missing", "mm", kResolvedSpacings, rootMissing},
    Imperfection{"undercut", "mm", kResolvedSpacings, undercut},
    Imperfection{"excess_weld_metal", "mm", kResolvedSpacings, excessWeldMetal},
    Imperfection{"convexity", "mm", kResolvedSpacings, convexity},
    Imperfection{"excess_penetration", "mm", kResolvedSpacings, excessPenetration},
    Imperfection{"toe_angle", "deg", 0, toeAngle},
    Imperfection{"overlap", "mm", kTwoPlaces, overlap},
    Imperfection{"unequal_legs", "mm", kResolvedSpacings, unequalLegs},
    Imperfection{"not_filled_up", "mm", kResolvedSpacings, notFilledUp},
    Imperfection{"root_concavity", "mm", kResolvedSpacings, rootConcavity},
    Imperfection{"throat_too_small", "mm", kResolvedSpacings, throatTooSmall},
    Imperfection{"throat_too_big", "mm", kResolvedSpacings, throatTooBig},
    Imperfection{"leg_too_small", "mm", kResolvedSpacings, legTooSmall},
    Imperfection{"plates_offset", "mm", 0, platesOffset},
    Imperfection{"joint_gap", "mm", 0, jointGap},
    Imperfection{"crack", "mm"},
    Imperfection{"surface_pore", "mm"},
    Imperfection{"piping_porosity", "mm"},
    Imperfection{"unfilled_crater", "mm"},
    Imperfection{"spatter", "mm"},
    Imperfection{"slag_inclusion", "mm"},
};

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

std::span<const Imperfection> imperfections() {
    return kImperfections;
}

const Imperfection* findImperfection(std::string_view name) {
    const auto* found = std::find_if(kImperfections.begin(), kImperfections.end(),
                                     [&](const Imperfection& each) { return each.name == name; });
    return found == kImperfections.end() ? nullptr : found;
}

} // namespace meltpool
