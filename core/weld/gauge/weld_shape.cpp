#include "core/weld/gauge/weld_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr double kLeastHeight = 0.25; ///< spacings: a lower place cannot be distinguished from the face
constexpr double kLeastBead = 0.75;   ///< spacings of height that toes need
constexpr double kLeastThroat = 1.1;  ///< spacings
constexpr double kRounded = 0.75;     ///< spacings over a face in which the particles' size rounds the edge
constexpr double kRoundedShare = 0.3; ///< share of the height that is left out at most
constexpr double kFoot = 1;           ///< spacings above that from which a toe is extrapolated
constexpr double kFootShare = 0.1;    ///< share of the height for it, at least
constexpr int kHeights = 24;          ///< number of heights at which a flank is sampled
constexpr int kRounds = 30;           ///< iterations of toes and arc until they agree

using Line = std::vector<glm::dvec2>;

/// Returns the place on the line from `a` to `b` that has the value `wanted` of a coordinate.
glm::dvec2 between(glm::dvec2 a, glm::dvec2 b, glm::length_t axis, double wanted) {
    const double way = b[axis] - a[axis];
    return way == 0 ? b : a + (b - a) * ((wanted - a[axis]) / way);
}

/// Returns the places of a closed line from `start` on, in one direction or the other, as long as a coordinate is above
/// `least`; the last one is at it. Empty if the line never falls so low.
Line walk(const Line& closed, size_t start, bool forwards, glm::length_t axis, double least) {
    if (closed[start][axis] <= least) return {};
    Line run{closed[start]};
    const size_t count = closed.size();
    for (size_t i = 1; i < count; ++i) {
        const glm::dvec2 next = closed[(start + (forwards ? i : count - i)) % count];
        if (next[axis] <= least) {
            run.push_back(between(run.back(), next, axis, least));
            return run;
        }
        run.push_back(next);
    }
    return {};
}

/// Returns the height over a face below which the particles' size rounds a weld's edge; a little even without
/// particles, so that the face itself stays out.
double roundedHeight(double height, double spacing) {
    return std::clamp(kRounded * spacing, 1e-3 * height, kRoundedShare * height);
}

/// One end of a weld's surface. The run's last place is next to the toe.
struct Flank {
    const Line& run;
    glm::length_t along, out; ///< the face's axes in the run
    double low, high;         ///< heights over the face from which the toe is extrapolated

    Flank(const Line& line, glm::length_t out_, double height, double spacing)
        : run(line),
          along(1 - out_),
          out(out_),
          low(roundedHeight(height, spacing)),
          high(low + std::clamp(kFoot * spacing, kFootShare * height, 0.6 * height - low)) {}

    /// Returns the first place along the face, from the toe upwards, at which the surface has a height.
    double at(double height) const {
        for (size_t i = run.size() - 1; i > 0; --i)
            if (run[i - 1][out] >= height) return between(run[i], run[i - 1], out, height)[along];
        return run.front()[along];
    }

    /// Returns the mean over heights of at() less the value of `shape` for the place at a height from the toe.
    template <class Shape>
    double toe(Shape shape) const {
        double sum = 0;
        for (int i = 0; i < kHeights; ++i) {
            const double height = low + (high - low) * (i + 0.5) / kHeights;
            sum += at(height) - shape(height);
        }
        return sum / kHeights;
    }
};

/// A circle's arc that rises from the face, at `reach` from its crown, to the crown of height `height`.
struct CrownArc {
    double reach, height;

    double radius() const { return 0.5 * (reach * reach + height * height) / height; }
    /// Returns the distance by which the arc at a height is nearer to the crown's middle than the toe.
    double inwards(double at) const {
        const double up = at - height + radius();
        return reach - std::sqrt(std::max(radius() * radius() - up * up, 0.0));
    }
    double angle() const { return 2 * std::atan2(height, reach); }
};

/// Finds a toe. `side`: 1 for the toe at the high end.
WeldToe beadToe(const Flank& flank, double middle, double height, double side) {
    CrownArc arc{std::max(side * (flank.at(flank.low) - middle), 1e-3 * height), height};
    for (int round = 0; round < kRounds; ++round) {
        const double place = flank.toe([&](double at) { return -side * arc.inwards(at); });
        arc.reach = std::max(side * (place - middle), 1e-3 * height);
    }
    return {middle + side * arc.reach, arc.angle()};
}

/// Returns the middle between a bead's flanks in the upper half of its height.
double middleOf(const Flank& first, const Flank& second, double height) {
    double sum = 0;
    for (int i = 0; i < kHeights; ++i) {
        const double at = height * (0.5 + 0.4 * (i + 0.5) / kHeights);
        sum += 0.5 * (first.at(at) + second.at(at));
    }
    return sum / kHeights;
}

/// The surface of a fillet as a flat arc (a parabola) over the straight line between its toes.
struct FilletArc {
    glm::dvec2 legs; ///< on the base plate and on the upright plate
    double rise = 0; ///< height in the middle, negative for a hollow surface

    double chord() const { return glm::length(legs); }
    glm::dvec2 normal() const { return glm::dvec2(legs.y, legs.x) / chord(); }
    /// Returns the distance by which the arc, at a height over the face whose leg is legs[face], is nearer to the
    /// corner than the toe.
    double inwards(double height, glm::length_t face) const {
        const double other = legs[1 - face], k = 4 * rise * normal()[1 - face];
        const double root = std::sqrt(std::max((other + k) * (other + k) - 4 * k * height, 0.0));
        const double share = 2 * height / std::max(other + k + root, 1e-12);
        return legs[face] * share - 4 * rise * normal()[face] * share * (1 - share);
    }
    double angle(glm::length_t face) const {
        return std::atan2(legs[1 - face], legs[face]) + 2 * std::atan2(2 * rise, chord());
    }
};

/// Returns the rise of a surface over the line between its toes, from the middle of that line, by least squares.
double riseOf(const Line& surface, const FilletArc& arc) {
    const glm::dvec2 toe(arc.legs.x, 0), way = glm::dvec2(-arc.legs.x, arc.legs.y) / arc.chord();
    double sum = 0, squares = 0;
    for (const glm::dvec2 place : surface) {
        const double share = glm::dot(place - toe, way) / arc.chord();
        if (share < 0.2 || share > 0.8) continue;
        const double shape = 4 * share * (1 - share);
        sum += shape * glm::dot(place - toe, arc.normal());
        squares += shape * shape;
    }
    return squares > 0 ? sum / squares : 0;
}

/// Returns the area between the surface of a weld, given as two runs that begin at one place, and the places that close
/// it.
double areaUnder(const Line& back, const Line& ahead, std::span<const glm::dvec2> closing) {
    Line line(back.rbegin(), back.rend());
    line.insert(line.end(), ahead.begin() + 1, ahead.end());
    line.insert(line.end(), closing.begin(), closing.end());
    return areaInside(line);
}

FilletArc filletArc(const Line& back, const Line& ahead, double spacing) {
    const Flank base(back, 1, ahead.back().y, spacing), upright(ahead, 0, back.back().x, spacing);
    Line surface(back.rbegin(), back.rend());
    surface.insert(surface.end(), ahead.begin() + 1, ahead.end());
    FilletArc arc{{back.back().x, ahead.back().y}};
    for (int round = 0; round < kRounds; ++round) {
        arc.rise = riseOf(surface, arc);
        arc.legs = {base.toe([&](double at) { return -arc.inwards(at, 0); }),
                    upright.toe([&](double at) { return -arc.inwards(at, 1); })};
    }
    return arc;
}

/// Returns the place on a piece of line that is nearest to the origin.
glm::dvec2 nearestTo(glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    return a + way * (square > 0 ? std::clamp(-glm::dot(a, way) / square, 0.0, 1.0) : 0.0);
}

/// Returns the least distance from the corner to the surface between the faces; infinite if there is none. The plates'
/// backs, which may be nearer, are not between the faces.
double throatOf(const Line& line) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 place = nearestTo(line[i], line[(i + 1) % line.size()]);
        if (place.x > 0 && place.y > 0) least = std::min(least, glm::length(place));
    }
    return least;
}

/// Adds the place of the surface that is farthest from both faces to the closed line, and returns its number there.
size_t addMiddle(Line& line) {
    const auto depth = [](glm::dvec2 place) { return std::min(place.x, place.y); };
    glm::dvec2 middle = line[0];
    size_t behind = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 a = line[i], b = line[(i + 1) % line.size()];
        // The lesser distance along a straight piece is greatest at an end or at the place of equal distances.
        const double before = a.x - a.y, after = b.x - b.y;
        const glm::dvec2 equal = before * after < 0 ? a + (b - a) * (before / (before - after)) : a;
        for (const glm::dvec2 place : {a, equal})
            if (depth(place) > depth(middle)) {
                middle = place;
                behind = i;
            }
    }
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(behind) + 1, middle);
    return behind + 1;
}

/// Returns the greatest height of the surface, in two runs, over the line from toe to toe.
double convexityOf(const Line& back, const Line& ahead, const FilletArc& arc) {
    const glm::dvec2 toe(arc.legs.x, 0), way = glm::dvec2(-arc.legs.x, arc.legs.y) / arc.chord();
    double most = 0;
    for (const Line* run : {&back, &ahead})
        for (const glm::dvec2 place : *run) {
            const double share = glm::dot(place - toe, way) / arc.chord();
            if (share > 0.1 && share < 0.9) most = std::max(most, glm::dot(place - toe, arc.normal()));
        }
    return most;
}

} // namespace

std::vector<glm::dvec2> inFrame(const WeldOutline& outline, const PlateFace& face) {
    Line line;
    for (const glm::dvec2 place : outline)
        line.push_back({glm::dot(place - face.origin, face.along), glm::dot(place - face.origin, face.out)});
    return line;
}

std::array<double, 2> BeadShape::overlap(const std::optional<FaceStretch>& fused) const {
    if (!toes) return {0, 0};
    if (!fused) return {0.5 * cover.length(), 0.5 * cover.length()};
    return {std::max(fused->low - cover.low, 0.0), std::max(cover.high - fused->high, 0.0)};
}

BeadShape measureBead(const WeldOutline& outline, const PlateFace& face, double spacing) {
    BeadShape bead;
    const Line line = inFrame(outline, face);
    const auto lower = [](glm::dvec2 a, glm::dvec2 b) { return a.y < b.y; };
    const auto crown = std::max_element(line.begin(), line.end(), lower);
    if (crown == line.end() || crown->y <= kLeastHeight * spacing) return bead;
    bead.height = crown->y;
    if (bead.height < kLeastBead * spacing) return bead;
    const double low = roundedHeight(bead.height, spacing);
    const auto top = static_cast<size_t>(crown - line.begin());
    // The outline, with the metal on its left, comes from the face's high end.
    const Line back = walk(line, top, false, 1, low), ahead = walk(line, top, true, 1, low);
    if (back.empty() || ahead.empty()) return bead;
    const Flank lowFlank(ahead, 1, bead.height, spacing), highFlank(back, 1, bead.height, spacing);
    const double middle = middleOf(lowFlank, highFlank, bead.height);
    bead.toes = {beadToe(lowFlank, middle, bead.height, -1), beadToe(highFlank, middle, bead.height, 1)};
    const glm::dvec2 lowToe((*bead.toes)[0].place, 0), highToe((*bead.toes)[1].place, 0);
    bead.cover = {lowToe.x, highToe.x};
    for (const Line* run : {&back, &ahead})
        for (const glm::dvec2 place : *run) {
            bead.cover.low = std::min(bead.cover.low, place.x);
            bead.cover.high = std::max(bead.cover.high, place.x);
        }
    bead.reinforcement = areaUnder(back, ahead, std::array{lowToe, highToe});
    return bead;
}

std::optional<FilletShape> measureFillet(const WeldOutline& outline, const PlateFace& base, double spacing) {
    Line line = inFrame(outline, base);
    FilletShape fillet;
    fillet.throat = throatOf(line);
    if (!std::isfinite(fillet.throat) || fillet.throat < kLeastThroat * spacing) return std::nullopt;
    const size_t middle = addMiddle(line);
    const double low = std::min(roundedHeight(fillet.throat, spacing), 0.6 * std::min(line[middle].x, line[middle].y));
    // The outline, with the metal on its left, comes along the base plate.
    const Line back = walk(line, middle, false, 1, low), ahead = walk(line, middle, true, 0, low);
    if (back.empty() || ahead.empty() || back.back().x <= low || ahead.back().y <= low) return std::nullopt;
    const FilletArc arc = filletArc(back, ahead, spacing);
    fillet.toes = {{{arc.legs.x, arc.angle(0)}, {arc.legs.y, arc.angle(1)}}};
    const std::array<glm::dvec2, 3> closing{{{0, fillet.toes[1].place}, {0, 0}, {fillet.toes[0].place, 0}}};
    fillet.area = areaUnder(back, ahead, closing);
    fillet.convexity = convexityOf(back, ahead, arc);
    return fillet;
}

} // namespace meltpool
