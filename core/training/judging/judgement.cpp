#include "core/training/judging/judgement.hpp"

#include <utility>

namespace meltpool {

namespace {

/// Travel speed that the lesson asks for, m/s.
std::optional<double> askedSpeed(const std::optional<TechniqueBands>& bands) {
    const TechniqueBand* band = bands ? bands->find(TechniqueQuantity::travelSpeed) : nullptr;
    if (band == nullptr) return std::nullopt;
    return band->ideal / quantityInfo(band->quantity, bands->distance).perSi;
}

} // namespace

void ArcAccount::add(const ArcState& arc, double step) {
    if (!arc.burns() || arc.current <= 0) return;
    seconds += step;
    charge += static_cast<double>(arc.current) * step;
    energy += static_cast<double>(arc.current) * static_cast<double>(arc.voltage) * step;
}

Technique techniqueOf(const WorkpieceParameters& workpiece, const ProcessSettings& process,
                      const std::optional<TechniqueBands>& bands) {
    TechniqueSettings settings;
    settings.distance = traitsOf(process).distance;
    return Technique(seamOf(workpiece), bands ? bands->settings() : settings);
}

Judgement judgeAttempt(const Technique& technique, std::optional<WeldMeasures> weld, const JudgementRules& rules) {
    Judgement made;
    made.distance = technique.settings().distance;
    made.seam = alongSeam(technique);
    if (rules.technique) {
        made.score = scoreTechnique(technique.faults(), made.seam, unknownPlaces(technique), *rules.technique);
        made.corrections = corrections(*made.score, *rules.technique);
    }
    made.weld = std::move(weld);
    if (rules.acceptance && made.weld)
        made.verdict = judge(*made.weld, *rules.acceptance, rules.nominal,
                             estimateImperfections(made.seam, rules.process, askedSpeed(rules.technique)));
    return made;
}

} // namespace meltpool
