// Judges an attempt: the hand by the lesson's bands, the weld by the acceptance's limits.
#pragma once

#include "core/training/judging/cures.hpp"
#include "core/training/judging/score.hpp"
#include "core/training/judging/verdict.hpp"
#include "core/weld/process/processes.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// Rules for judging an attempt; a rule that the lesson does not give is empty.
struct JudgementRules {
    const std::optional<TechniqueBands>& technique;
    const std::optional<Acceptance>& acceptance;
    NominalWeld nominal;
    const ProcessSettings& process;
    std::vector<SettingFact> settings = {}; ///< settings of machine and workpiece
};

/// Account of an attempt's arc, over the time that it burned.
struct ArcAccount {
    double seconds = 0;
    double charge = 0; ///< A s
    double energy = 0; ///< J, voltage times current, before any loss

    void add(const ArcState& arc, double seconds);
    double meanCurrent() const { return seconds > 0 ? charge / seconds : 0; } ///< A
    double meanVoltage() const { return charge > 0 ? energy / charge : 0; }   ///< V
    /// J/m of heat input by EN 1011-1: efficiency times voltage times current over travel speed, here as energy over
    /// `length` (m). 0 for no length.
    double heatInput(double efficiency, double length) const { return length > 0 ? efficiency * energy / length : 0; }
};

struct Judgement {
    ArcAccount arc;
    double realTime = 1;                        ///< simulated over real time while a person welded
    DistanceKind distance = DistanceKind::ctwd; ///< meaning of TechniqueQuantity::distance
    std::vector<SeamMillimetre> seam;           ///< the hand by the millimetre; empty without an arc
    std::optional<TechniqueScore> score;        ///< set if the lesson has bands
    std::vector<Correction> corrections;        ///< corrections, the costliest first
    std::optional<WeldMeasures> weld;           ///< set if there is a weld to measure
    std::optional<Verdict> verdict;             ///< set if the lesson has an acceptance and there is a weld to measure
    std::vector<Cure> cures;                    ///< one for each imperfection that fails
};

/// Measures the hand in a weld lesson of this workpiece and process, with the lesson's bands if it has some.
Technique techniqueOf(const WorkpieceParameters& workpiece, const ProcessSettings& process,
                      const std::optional<TechniqueBands>& bands);

/// Judges technique and weld, as far as rules and figures exist.
Judgement judgeAttempt(const Technique& technique, std::optional<WeldMeasures> weld, const JudgementRules& rules);

} // namespace meltpool
