#include "core/training/judgement.hpp"

#include <utility>

namespace meltpool {

void ArcAccount::add(const ArcState& arc, double step) {
    if (!arc.burns() || arc.current <= 0) return;
    seconds += step;
    charge += static_cast<double>(arc.current) * step;
    energy += static_cast<double>(arc.current) * static_cast<double>(arc.voltage) * step;
}

std::optional<double> standardEfficiency(const ProcessSettings& process) {
    if (process.is<Gtaw>()) return 0.6;
    if (process.is<Gmaw>() || process.is<Smaw>()) return 0.8;
    return std::nullopt;
}

Judgement judgeAttempt(const Technique& technique, std::optional<WeldMeasures> weld, const JudgementRules& rules) {
    Judgement made;
    made.distance = technique.settings().distance;
    made.seam = alongSeam(technique);
    if (rules.technique) {
        made.score = scoreTechnique(technique.faults(), made.seam, *rules.technique);
        made.corrections = corrections(*made.score, *rules.technique);
    }
    made.weld = std::move(weld);
    if (rules.acceptance && made.weld) made.verdict = judge(*made.weld, *rules.acceptance, rules.nominal);
    return made;
}

} // namespace meltpool
