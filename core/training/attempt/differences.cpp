#include "core/training/attempt/differences.hpp"

#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kLeastPoints = 1;
/// Rounding of writing and reading a value; a difference below it does not count.
constexpr double kRounding = 1e-9;

/// Smallest difference of a figure that metal of this spacing (m) resolves, in the figure's unit.
double resolvedOf(const ComparedFigure& figure, double spacing) {
    return std::max({figure.least, figure.resolution * spacing / kMm, kRounding});
}

std::string amountText(double amount, int decimals, const std::string& unit) {
    std::string text(inShownUnit(PhraseNumber(amount, decimals), unit));
    if (unit != "°" && unit != "%") text += " ";
    const std::string_view shown = shownUnit(unit).name;
    return text + (shown == "mm2" ? "mm²" : std::string(shown));
}

std::vector<ScorePair> scorePairs(const AttemptFigures& first, const AttemptFigures& second) {
    if (!first.score && !second.score) return {};
    std::vector<ScorePair> pairs{{phrase("figure.differences.score"), first.score, second.score}};
    const auto pointsOf = [](const AttemptFigures& figures, const std::string& key) {
        const auto found = figures.points.find(key);
        return found != figures.points.end() ? std::optional(found->second) : std::nullopt;
    };
    for (const QuantityInfo& info : quantities(second.distance)) {
        const std::string key(info.key);
        ScorePair pair{std::string(info.words()), pointsOf(first, key), pointsOf(second, key)};
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

std::string FigurePair::told(std::string_view size) const {
    const std::string key = "figure." + figure.key + (difference() > 0 ? ".more" : ".less");
    return phrase(key, {{"size", size}});
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
    return pair.told(amountText(std::abs(pair.difference()), pair.decimals(), pair.figure.unit));
}

std::string comparisonText(const Comparison& comparison, size_t most) {
    std::string text;
    const auto add = [&](const std::string& part) {
        if (!text.empty()) text += phrase("list.separator");
        text += part;
    };
    const std::vector<FigurePair> found = comparison.differences();
    for (size_t i = 0; i < std::min(found.size(), most); ++i)
        add(differenceText(found[i]));
    if (const auto points = comparison.morePoints()) {
        const PhraseNumber shown(std::abs(*points));
        add(phraseOfCount(*points > 0 ? "figure.differences.points_more" : "figure.differences.points_less",
                          std::llround(std::abs(*points)), {{"points", shown}}));
    }
    if (found.size() > most) {
        const size_t further = found.size() - most;
        add(phraseOfCount("figure.differences.further", static_cast<long long>(further),
                          {{"count", std::to_string(further)}}));
    }
    return text.empty() ? phrase("figure.differences.none") : text;
}

} // namespace meltpool
