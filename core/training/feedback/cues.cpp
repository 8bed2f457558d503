#include "core/training/feedback/cues.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, kCueKinds.size()> kNames{"speed", "angles", "distance", "aim", "seam", "arc"};

constexpr std::array<CuedQuantity, 5> kCued{{
    {TechniqueQuantity::travelSpeed, CueKind::speed, "travel_speed"},
    {TechniqueQuantity::workAngle, CueKind::angles, "work_angle"},
    {TechniqueQuantity::travelAngle, CueKind::angles, "travel_angle"},
    {TechniqueQuantity::distance, CueKind::distance, "distance"},
    {TechniqueQuantity::aim, CueKind::aim, "aim"},
}};

int demandedDirection(const TechniqueBands* bands) {
    if (bands == nullptr || bands->direction == TravelDirection::either) return 0;
    return bands->direction == TravelDirection::forward ? 1 : -1;
}

/// 1: the torch is too far from the metal, -1: too near, 0: neither helps; empty if the arc burns or is not wanted.
std::optional<double> arcFault(NoArc reason) {
    switch (reason) {
    case NoArc::burns:
    case NoArc::released:
    case NoArc::feeding:
        return std::nullopt;
    case NoArc::tooLong:
    case NoArc::tooFar:
        return 1;
    case NoArc::touched:
    case NoArc::touching:
    case NoArc::stuck:
        return -1;
    case NoArc::metalLeft:
    case NoArc::noMetal:
    case NoArc::noWire:
    case NoArc::usedUp:
        return 0;
    }
    return std::nullopt;
}

/// Returns the distance (m) where technique knows none, or NaN. From a contact tip that was pushed into the metal no
/// surface is ahead: it is too near by its depth. Before the arc the way to the metal is shown while it is longer than
/// the lesson's arc, but not to a hand that touches, sticks, or has welded.
double distanceWithoutArc(const Technique& technique, const ArcState& arc, const TechniqueBands& bands) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const double height = technique.now()[TechniqueQuantity::height];
    if (technique.settings().distance == DistanceKind::ctwd) return height < 0 ? height : kUnknown;
    const TechniqueBand* band = bands.find(TechniqueQuantity::distance);
    const bool welded = arc.noArc == NoArc::released && technique.faults().arcSeconds > 0;
    const bool mayApproach = arc.noArc != NoArc::usedUp && arcFault(arc.noArc).value_or(1) >= 0;
    if (band == nullptr || arc.burns() || welded || !mayApproach) return kUnknown;
    const double way = std::isfinite(arc.distance) ? static_cast<double>(arc.distance) : height;
    const double perSi = quantityInfo(TechniqueQuantity::distance, bands.distance).perSi;
    return way * perSi > band->ideal ? way : kUnknown;
}

/// Present values of the hand as cues show them; the travel angle counts along the demanded direction while none is
/// sensed.
TechniqueValues valuesOf(const Technique& technique, const ArcState& arc, const TechniqueBands& bands) {
    TechniqueValues values = technique.now();
    const int demanded = demandedDirection(&bands);
    double& angle = values[TechniqueQuantity::travelAngle];
    if (std::isnan(angle) && demanded != 0) angle = demanded * technique.steps().back().lean;
    double& distance = values[TechniqueQuantity::distance];
    if (std::isnan(distance)) distance = distanceWithoutArc(technique, arc, bands);
    return values;
}

/// False while the torch weaves: its centre line is unknown before the swing ends.
bool knownAtOnce(const TechniqueBands& bands, TechniqueQuantity quantity) {
    const TechniqueBand* weave = bands.find(TechniqueQuantity::weaveWidth);
    return quantity != TechniqueQuantity::aim || weave == nullptr || weave->ideal <= 0;
}

std::optional<Cue> cueOf(const CuedQuantity& cued, const TechniqueBand& band, double value, double strength) {
    if (std::isnan(value)) return std::nullopt;
    Cue cue;
    cue.kind = cued.kind;
    cue.quantity = cued.quantity;
    cue.offset = value - band.ideal;
    cue.share = cue.offset / band.outer;
    cue.inner = band.inner / band.outer;
    cue.zone = band.zone(value);
    cue.opacity = strength * (cue.zone == BandZone::inside ? kQuietCue : 1.0);
    return cue;
}

bool isPutAside(const TechniqueValues& values, const ArcState& arc) {
    return !arc.burns() && !(std::abs(values[TechniqueQuantity::height]) < kCueReach &&
                             std::abs(values[TechniqueQuantity::aim]) < kCueReach);
}

} // namespace

std::string_view cueName(CueKind kind) {
    return kNames[static_cast<size_t>(kind)];
}

std::optional<CueKind> findCue(std::string_view name) {
    for (const CueKind kind : kCueKinds)
        if (cueName(kind) == name) return kind;
    return std::nullopt;
}

CueSet CueSet::all() {
    CueSet every;
    for (const CueKind kind : kCueKinds)
        every.set(kind);
    return every;
}

std::string CueSet::names() const {
    std::string text;
    for (const CueKind kind : kCueKinds)
        if (has(kind)) text += (text.empty() ? "" : " ") + std::string(cueName(kind));
    return text;
}

std::span<const CuedQuantity> cuedQuantities() {
    return kCued;
}

CueSkill CueSkill::after(const TechniqueScore& score, const QuantitySet& held) const {
    CueSkill next = *this;
    if (!score.scored || score.coverage < kLeastCoverage) return next;
    for (const CuedQuantity& cued : kCued) {
        const ParameterScore* parameter = score.find(cued.quantity);
        if (parameter == nullptr) continue;
        const int gain = held.test(static_cast<size_t>(cued.quantity)) ? 0 : 1;
        const int step = parameter->score >= kGood ? gain : parameter->score < kPoor ? -1 : 0;
        next.setGood(cued.quantity, std::clamp(good(cued.quantity) + step, 0, kMastered));
    }
    return next;
}

double CueSkill::strength(CueKind kind) const {
    if (kind == CueKind::arc) return 1;
    if (kind == CueKind::seam) return strength(TechniqueQuantity::aim);
    double most = 0;
    for (const CuedQuantity& cued : kCued)
        if (cued.kind == kind) most = std::max(most, strength(cued.quantity));
    return most;
}

double CueSkill::strength(const TechniqueBands* bands) const {
    double most = 0;
    bool judged = false;
    for (const CuedQuantity& cued : kCued) {
        if (bands == nullptr || bands->find(cued.quantity) == nullptr) continue;
        most = std::max(most, strength(cued.quantity));
        judged = true;
    }
    return judged ? most : 1;
}

const Cue* CueList::find(CueKind kind) const {
    const auto found = std::find_if(all().begin(), all().end(), [kind](const Cue& each) { return each.kind == kind; });
    return found == all().end() ? nullptr : &*found;
}

const Cue* CueList::find(TechniqueQuantity quantity) const {
    const auto found = std::find_if(all().begin(), all().end(), [quantity](const Cue& each) {
        return each.kind != CueKind::seam && each.kind != CueKind::arc && each.quantity == quantity;
    });
    return found == all().end() ? nullptr : &*found;
}

int cueDirection(const Technique& technique, const TechniqueBands* bands) {
    return technique.direction() != 0 ? technique.direction() : demandedDirection(bands);
}

CueList liveCues(const Technique& technique, const ArcState& arc, const TechniqueBands* bands, CueSet shown,
                 const CueSkill& skill) {
    CueList list;
    if (technique.steps().empty()) return list;
    const bool near = !isPutAside(technique.now(), arc);
    if (bands != nullptr && near) {
        const TechniqueValues values = valuesOf(technique, arc, *bands);
        for (const CuedQuantity& cued : kCued) {
            const TechniqueBand* band = bands->find(cued.quantity);
            if (band == nullptr || !shown.has(cued.kind) || !knownAtOnce(*bands, cued.quantity)) continue;
            // Both angles share one shape, which fades as a whole.
            const double value = bands->judged(values, technique.direction(), cued.quantity);
            const auto cue = cueOf(cued, *band, value, skill.strength(cued.kind));
            if (cue && cue->opacity > 0) list.add(*cue);
        }
    }
    if (near && shown.has(CueKind::seam) && skill.strength(CueKind::seam) > 0) {
        Cue seam;
        seam.kind = CueKind::seam;
        seam.opacity = skill.strength(CueKind::seam);
        list.add(seam);
    }
    if (const auto fault = arcFault(arc.noArc); shown.has(CueKind::arc) && fault && !arc.burns()) {
        Cue out;
        out.kind = CueKind::arc;
        out.offset = *fault;
        out.zone = wentOut(arc.noArc) ? BandZone::beyond : BandZone::between;
        list.add(out);
    }
    return list;
}

} // namespace meltpool
