// Two attempts held against each other: what the second has more or less of than the first, in words.
#pragma once

#include "core/training/attempt/attempt_figures.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A figure that both attempts have.
struct FigurePair {
    ComparedFigure figure;
    double first = 0, second = 0; ///< in the figure's unit
    double resolved = 0;          ///< in it: a difference below is none
    bool differs() const;
    /// Worth a curve along the seam: a size that every weld is known by, and of all others what differs.
    bool isDrawn() const;
    double difference() const; ///< second less first, as it counts: see ComparedFigure::onlyOver
    /// Of one that differs: its size by what differs as much; 1 is much.
    double weight() const { return std::abs(difference()) / figure.much; }
    int decimals() const; ///< with which the difference is told: no fewer than it needs to be seen
    /// "0.4 mm more penetration" of a size "0.4 mm", which may stand in HTML.
    std::string told(std::string_view size) const;
};

/// Points that the quantities of the hand had; nothing where an attempt was not judged by it.
struct ScorePair {
    std::string name; ///< "travel speed"; "score" of the whole, which comes first
    std::optional<double> first, second;
};

struct Comparison {
    std::vector<FigurePair> pairs; ///< every figure that both have, in the order of comparedFigures()
    std::vector<ScorePair> scores; ///< the whole first; empty where neither attempt has a score
    double halfSpacing = 0;        ///< m, of the coarser metal: what of a length is resolved; 0: not known

    /// Those that differ, what weighs most first.
    std::vector<FigurePair> differences() const;
    /// Points that the second has more; nothing where one is not scored or they are less than a point apart.
    std::optional<double> morePoints() const;
};

/// A length, area or hole of the weld differs where it does so by half a particle spacing at least: less is chance of
/// where particles lie. Figures of the hand and the arc differ where it would be seen.
Comparison compareAttempts(const AttemptFigures& first, const AttemptFigures& second);

/// "0.4 mm more penetration"
std::string differenceText(const FigurePair& pair);

/// "0.4 mm more penetration, 1.1 mm narrower, 12 points more": the heaviest first, at most `most` of them, the score
/// last. Where there is nothing: "no difference that the metal resolves".
std::string comparisonText(const Comparison& comparison, size_t most = 6);

} // namespace meltpool
