// Scores an attempt's technique by a lesson's bands, and lists the corrections.
#pragma once

#include "core/training/judging/along_seam.hpp"
#include "core/training/judging/bands.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// mm at each end of the wanted seam that need not be welded, at most kFreeEndShare of it.
inline constexpr double kFreeEndMm = 2;
inline constexpr double kFreeEndShare = 0.05;

/// Share of the whole score that the lowest parameter has in addition to its weight: one fault spoils a weld however
/// good the rest is.
inline constexpr double kLowestShare = 0.5;

/// Result of one parameter over the judged length, in its band's unit.
struct ParameterScore {
    TechniqueQuantity quantity = TechniqueQuantity::aim;
    double score = 0;     ///< 0..100: the mean of TechniqueBand::points() over the judged millimetres
    double mean = 0;      ///< mean of the values; NaN without a known value, as are the next four
    double deviation = 0; ///< deviation of the mean from the ideal; positive is too much
    double spread = 0;    ///< mean distance from the ideal, regardless of its sign
    double least = 0, most = 0;
    double worstPlaceMm = 0; ///< place on the seam of the largest deviation
    double lost = 0;         ///< points of the whole score that this parameter cost
};

/// Share of the wanted seam with an unknown hand from which on an attempt has no score.
inline constexpr double kMostUnknownShare = 0.05;

struct TechniqueScore {
    bool scored = false;
    std::string reason; ///< reason without a score, a sentence; else empty
    double total = 0;   ///< 0..100: half the lowest parameter's score and half the weighted mean of all, times coverage
    double coverage = 0;                    ///< welded share 0..1 of the wanted seam, the free ends left out
    double wantedMm = 0;                    ///< length of the wanted seam
    double weldedMm = 0;                    ///< welded part of it, as far as the hand is known
    double judgedMm = 0;                    ///< judged part of it: without strike and crater
    double unknownMm = 0;                   ///< left out of the wanted seam: see unknownPlaces()
    double lostToLength = 0;                ///< points of the whole score that the missing length cost
    std::vector<ParameterScore> parameters; ///< one for each band, in their order
    /// The parameter with the fewest points among those that have a weight; empty without a score.
    std::optional<TechniqueQuantity> lowest;

    /// Null for a parameter that is not judged.
    const ParameterScore* find(TechniqueQuantity quantity) const;
};

/// Judges each millimetre of the wanted seam by its mean values, so that every millimetre counts alike however long the
/// torch stayed there. A millimetre that was not welded has no points: over the wanted seam that equals the mean over
/// the welded part times its share, the coverage. A parameter without a known value has 0. The millimetres at `unknown`
/// places are left out, as if the wanted seam were shorter by them.
///
/// Not scored, with a reason: tracking was lost or samples were missing on kMostUnknownShare of the wanted seam, the
/// arc was never lit, or strike and crater leave no part of the wanted seam to judge.
TechniqueScore scoreTechnique(const TechniqueFaults& faults, const std::vector<SeamMillimetre>& seam,
                              const std::vector<double>& unknown, const TechniqueBands& bands);

/// "Left out of the score: 3 mm of the seam, where ..."; empty without unknown places.
std::string unknownSentence(const TechniqueScore& score);

/// One thing to correct.
struct Correction {
    std::optional<TechniqueQuantity> quantity; ///< empty: the seam's length
    double lost = 0;                           ///< points of the whole score
    std::string sentence;                      ///< such as "Travel slower: 7.6 mm/s, target 5.5."
};

/// Means and extremes of a quantity over the judged millimetres from `from` to `to` (m along the seam); NaN if none of
/// them has a known value.
ParameterScore scoreStretch(const std::vector<SeamMillimetre>& seam, double from, double to,
                            const TechniqueBands& bands, const TechniqueBand& band);

/// Sentence that corrects a parameter, such as "Travel slower: 7.6 mm/s, target 5.5."
std::string correctionSentence(const ParameterScore& parameter, const TechniqueBand& band, const TechniqueBands& bands);

/// The corrections, costliest first, at most `most` and none below half a point, and none for a parameter that stayed
/// within its tolerance by the digits that its sentence shows. Empty if the attempt is not scored.
std::vector<Correction> corrections(const TechniqueScore& score, const TechniqueBands& bands, size_t most = 3);

} // namespace meltpool
