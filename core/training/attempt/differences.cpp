#include "core/training/attempt/differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kLeastPoints = 1;
/// Equal bits differ by nothing, and so does what they are after they have been written and read.
constexpr double kRounding = 1e-9;

/// What of a figure is resolved by metal of this spacing (m), in its unit.
double resolvedOf(const ComparedFigure& figure, double spacing) {
    return std::max({figure.least, figure.resolution * spacing / kMm, kRounding});
}

std::string fixed(double value, int decimals) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string amountText(double amount, int decimals, const std::string& unit) {
    if (unit == "°" || unit == "%") return fixed(amount, decimals) + unit;
    return fixed(amount, decimals) + " " + (unit == "mm2" ? "mm²" : unit);
}

std::vector<ScorePair> scorePairs(const AttemptFigures& first, const AttemptFigures& second) {
    if (!first.score && !second.score) return {};
    std::vector<ScorePair> pairs{{"score", first.score, second.score}};
    const auto pointsOf = [](const AttemptFigures& figures, const std::string& key) {
        const auto found = figures.points.find(key);
        return found != figures.points.end() ? std::optional(found->second) : std::nullopt;
    };
    for (const QuantityInfo& info : quantities(second.distance)) {
        const std::string key(info.key);
        ScorePair pair{std::string(info.words), pointsOf(first, key), pointsOf(second, key)};
        if (pair.first || pair.second) pairs.push_back(std::move(pair));
    }
    return pairs;
}

} // namespace

double FigurePair::difference() const {
    return figure.onlyOver ? std::max(second, 0.0) - std::max(first, 0.0) : second - first;
}

bool FigurePair::differs() const {
    return std::abs(difference()) >= resolved;
}

bool FigurePair::isDrawn() const {
    return differs() || figure.isSize;
}

int FigurePair::decimals() const {
    int decimals = figure.decimals;
    if (!differs()) return decimals;
    for (double step = std::pow(10.0, -decimals); decimals < 3 && std::abs(difference()) < step; step /= 10)
        ++decimals;
    return decimals;
}

std::vector<FigurePair> Comparison::differences() const {
    std::vector<FigurePair> found;
    for (const FigurePair& pair : pairs)
        if (pair.differs()) found.push_back(pair);
    std::stable_sort(found.begin(), found.end(),
                     [](const FigurePair& a, const FigurePair& b) { return a.weight() > b.weight(); });
    return found;
}

std::optional<double> Comparison::morePoints() const {
    if (scores.empty() || !scores.front().first || !scores.front().second) return std::nullopt;
    const double points = *scores.front().second - *scores.front().first;
    return std::abs(points) >= kLeastPoints ? std::optional(points) : std::nullopt;
}

Comparison compareAttempts(const AttemptFigures& first, const AttemptFigures& second) {
    const double spacing = std::max(first.spacing, second.spacing);
    Comparison made;
    made.halfSpacing = spacing / 2;
    for (const ComparedFigure& figure : comparedFigures(second.distance)) {
        const auto a = first.values.find(figure.key), b = second.values.find(figure.key);
        if (a == first.values.end() || b == second.values.end()) continue;
        made.pairs.push_back({figure, a->second, b->second, resolvedOf(figure, spacing)});
    }
    made.scores = scorePairs(first, second);
    return made;
}

std::string differenceText(const FigurePair& pair) {
    return amountText(std::abs(pair.difference()), pair.decimals(), pair.figure.unit) + " " + pair.words();
}

std::string comparisonText(const Comparison& comparison, size_t most) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    const std::vector<FigurePair> found = comparison.differences();
    for (size_t i = 0; i < std::min(found.size(), most); ++i)
        add(differenceText(found[i]));
    if (found.size() > most) add("and " + std::to_string(found.size() - most) + " more");
    if (const auto points = comparison.morePoints())
        add(fixed(std::abs(*points), 0) + (std::abs(*points) < 1.5 ? " point " : " points ") +
            (*points > 0 ? "more" : "less"));
    return text.empty() ? "no difference that the metal resolves" : text;
}

} // namespace meltpool
