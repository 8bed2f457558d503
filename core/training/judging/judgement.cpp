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
    const std::vector<double> unknown = unknownPlaces(technique);
    const TechniqueBands* bands = rules.technique ? &*rules.technique : nullptr;
    if (bands != nullptr) {
        made.score = scoreTechnique(technique.faults(), made.seam, unknown, *bands);
        made.corrections = corrections(*made.score, *bands);
    }
    made.weld = std::move(weld);
    if (!rules.acceptance || !made.weld) return made;
    made.verdict = judge(*made.weld, *rules.acceptance, rules.nominal,
                         estimateImperfections(made.seam, rules.process, askedSpeed(rules.technique)));
    made.cures = curesOf(*made.verdict, {made.seam, traitsOf(rules.process), bands, rules.settings, unknown});
    return made;
}

} // namespace meltpool
