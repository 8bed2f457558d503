#include "core/training/judgement.hpp"

#include <utility>

namespace meltpool {

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
