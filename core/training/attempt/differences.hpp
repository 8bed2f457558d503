// Compares two attempts and says in words how the second differs from the first.
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
    double first = 0, second = 0; ///< values in the figure's unit
    double resolved = 0;          ///< least difference that counts, in the figure's unit
    bool differs() const;
    /// True if the figure is worth a curve along the seam: a main size of a weld, or a figure that differs.
    bool isDrawn() const;
    double difference() const; ///< second minus first, by the rule of ComparedFigure::onlyOver
    /// Size of the difference relative to ComparedFigure::much; 1 is much.
    double weight() const { return std::abs(difference()) / figure.much; }
    int decimals() const; ///< decimals of the printed difference: enough to show it
    /// "0.4 mm more penetration" from a size "0.4 mm"; the size may be HTML.
    std::string told(std::string_view size) const;
};

/// Points of a quantity of the hand; empty for an attempt that was not judged by it.
struct ScorePair {
    std::string name; ///< "travel speed"; "score" for the whole score, which comes first
    std::optional<double> first, second;
};

struct Comparison {
    std::vector<FigurePair> pairs; ///< every figure that both attempts have, in the order of comparedFigures()
    std::vector<ScorePair> scores; ///< whole score first; empty if neither attempt has a score
    double halfSpacing = 0;        ///< m, half the spacing of the coarser metal, the smallest length it resolves; 0:
                                   ///< unknown

    /// Figures that differ, the heaviest first.
    std::vector<FigurePair> differences() const;
    /// Points that the second attempt has more; empty if either is not scored or they differ by less than a point.
    std::optional<double> morePoints() const;
};

/// A length, area or hole of the weld differs if the difference is at least half a particle spacing: less is chance of
/// the particles' places. Figures of the hand and the arc differ if a person would notice it.
Comparison compareAttempts(const AttemptFigures& first, const AttemptFigures& second);

/// "0.4 mm more penetration"
std::string differenceText(const FigurePair& pair);

/// "0.4 mm more penetration, 1.1 mm narrower, 12 points more": the heaviest first, at most `most` of them, the score
/// last. Without a difference: "no difference that the metal resolves".
std::string comparisonText(const Comparison& comparison, size_t most = 6);

} // namespace meltpool
