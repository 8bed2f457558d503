#include "core/weld/gauge/weld_faults.hpp"

#include <algorithm>
#include <limits>

namespace meltpool {

namespace {

constexpr double kRoundedEnd = 1.5; ///< spacings at the end of a face that the particles' size rounds
constexpr int kPlaces = 64;         ///< number of places at which a stretch is measured
constexpr double kToeSlack = 0.5;   ///< spacings inside the toe in which a groove is looked for too
constexpr double kNoMetal = -std::numeric_limits<double>::infinity();

using Line = std::vector<glm::dvec2>;

/// Returns the height of a closed line's uppermost place at `along`; kNoMetal outside the line.
double upperHeight(const Line& line, double along) {
    double height = kNoMetal;
    for (size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 a = line[i], b = line[(i + 1) % line.size()];
        if ((a.x > along) == (b.x > along)) continue;
        height = std::max(height, a.y + (b.y - a.y) * (along - a.x) / (b.x - a.x));
    }
    return height;
}

double reachOf(double spacing) {
    return std::max(kUndercutReachSpacings * spacing, kUndercutReach);
}

} // namespace

std::optional<double> grooveDepth(const WeldOutline& outline, const PlateFace& face, const FaceStretch& stretch,
                                  double spacing) {
    const Line line = inFrame(outline, face);
    if (line.empty()) return std::nullopt;
    const auto [low, high] =
        std::minmax_element(line.begin(), line.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; });
    const double first = std::max(stretch.low, low->x + kRoundedEnd * spacing);
    const double last = std::min(stretch.high, high->x - kRoundedEnd * spacing);
    if (first > last) return std::nullopt;
    double depth = 0;
    for (int i = 0; i <= kPlaces; ++i) {
        const double height = upperHeight(line, first + (last - first) * i / kPlaces);
        if (height != kNoMetal) depth = std::max(depth, -height);
    }
    return depth;
}

std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& face,
                                                    const FaceStretch& weld, double spacing) {
    const double inside = std::min(kToeSlack * spacing, 0.5 * weld.length()), reach = reachOf(spacing);
    return {grooveDepth(outline, face, {weld.low - reach, weld.low + inside}, spacing),
            grooveDepth(outline, face, {weld.high - inside, weld.high + reach}, spacing)};
}

std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& base,
                                                    const FilletShape& fillet, double spacing) {
    const PlateFace upright{base.origin, base.out, base.along};
    const double inside = kToeSlack * spacing, reach = reachOf(spacing);
    const auto beside = [&](const PlateFace& face, double leg) {
        return grooveDepth(outline, face, {leg - inside, leg + reach}, spacing);
    };
    return {beside(base, fillet.toes[0].place), beside(upright, fillet.toes[1].place)};
}

} // namespace meltpool
