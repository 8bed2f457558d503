// An attempt judged: the hand by the lesson's bands, the weld by the acceptance's limits.
#pragma once

#include "core/training/technique/score.hpp"
#include "core/training/verdict/verdict.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// What an attempt is judged by; nothing where the lesson does not say.
struct JudgementRules {
    const std::optional<TechniqueBands>& technique;
    const std::optional<Acceptance>& acceptance;
    const NominalWeld& nominal;
};

struct Judgement {
    double realTime = 1;                        ///< simulated over real time while a person welded
    DistanceKind distance = DistanceKind::ctwd; ///< what TechniqueQuantity::distance is
    std::vector<SeamMillimetre> seam;           ///< the hand by the millimetre; empty where no arc burned
    std::optional<TechniqueScore> score;        ///< where the lesson has bands
    std::vector<Correction> corrections;        ///< what to correct first, dearest first
    std::optional<WeldMeasures> weld;           ///< where there is a weld to measure
    std::optional<Verdict> verdict;             ///< where the lesson has an acceptance and there is a weld to measure
};

/// Judges technique and weld, whichever there are rules and figures for.
Judgement judgeAttempt(const Technique& technique, std::optional<WeldMeasures> weld, const JudgementRules& rules);

} // namespace meltpool
