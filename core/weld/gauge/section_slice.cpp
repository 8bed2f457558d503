#include "core/weld/gauge/section_slice.hpp"

#include "core/base/function_ref.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace meltpool {

namespace {

constexpr glm::ivec2 kUp(0, 1);
constexpr std::array<glm::ivec2, 4> kWays{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Highest temperatures for the zone's measures: of cells, or of their faces.
using Peaks = FunctionRef<double(glm::ivec2)>;

/// Returns the distance of the zone's edge from a hot cell's centre towards a neighbour that is colder or air, cells.
double edgeFrom(Peaks peak, glm::ivec2 hot, glm::ivec2 way, double level) {
    const double inside = peak(hot), first = peak(hot + way);
    if (first == SectionSlice::kAir) return 0.5;
    if (std::isfinite(inside)) return 1 - (level - first) / (inside - first);
    // The hotter cell is gone: extrapolate towards its centre with a slope that grows as it did over the three cells
    // before it.
    const double second = peak(hot + 2 * way), third = peak(hot + 3 * way);
    const double slope = std::isfinite(second) ? first - second : 0;
    const double before = std::isfinite(second) && std::isfinite(third) ? second - third : 0;
    const double steeper = before > 0 ? std::max(slope, slope * slope / before) : slope;
    return 1 - (slope > 0 ? std::min(1.0, (level - first) / steeper) : 0.5);
}

/// Returns the excess of a cell's highest temperature over that of the next cell under its face, 0 if it is negative or
/// unknown.
double slopeUnderFace(const SectionSlice& slice, glm::ivec2 cell, glm::ivec2 side) {
    const double slope = slice.peak(cell) - slice.peak(cell - side);
    return std::isfinite(slope) ? std::max(slope, 0.0) : 0;
}

/// Returns the depth of a zone that ends above the centre of a colder face cell, cells; 0 if there is none.
double shallowDepth(const SectionSlice& slice, glm::ivec2 cell, glm::ivec2 side, double level) {
    const double slope = slopeUnderFace(slice, cell, side);
    return slope > 0 ? std::max(0.5 - (level - slice.peak(cell)) / slope, 0.0) : 0;
}

/// Returns the length of the hot surface from the centre of a hot face cell along `way`, in cells.
double surfaceReach(const SectionSlice& slice, Peaks peak, glm::ivec2 hot, glm::ivec2 way, glm::ivec2 side,
                    double level) {
    double reach = 0;
    for (;;) {
        glm::ivec2 next = hot + way;
        const bool gap = !slice.held(next);
        while (slice.inside(next) && !slice.held(next))
            next += way;
        const bool face = slice.isFace(next, side);
        if (!face || peak(next) < level) {
            // A corner ends the surface in the middle between two cells, as air does.
            return reach + (face && !gap ? edgeFrom(peak, hot, way, level) : 0.5);
        }
        reach += std::abs(next.x - hot.x) + std::abs(next.y - hot.y);
        hot = next;
    }
}

/// Width of a hot surface, and its first moment about the grid's corner.
struct SurfaceStretch {
    double width = 0, moment = 0;
};

/// Returns the hot surface on all faces that look to `side`, each plane of faces for itself.
SurfaceStretch hotSurface(const SectionSlice& slice, Peaks peak, glm::ivec2 side, double level) {
    const glm::ivec2 along(std::abs(side.y), std::abs(side.x));
    std::map<int, glm::ivec2> hottest; // hottest cells by the plane's place
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x) {
            const glm::ivec2 cell(x, y);
            if (!slice.isFace(cell, side) || peak(cell) < level) continue;
            const auto [place, isNew] = hottest.try_emplace(side.y != 0 ? y : x, cell);
            if (!isNew && peak(cell) > peak(place->second)) place->second = cell;
        }
    SurfaceStretch sum;
    for (const auto& [plane, cell] : hottest) {
        const double centre = 0.5 + (side.y != 0 ? cell.x : cell.y);
        const double high = centre + surfaceReach(slice, peak, cell, along, side, level);
        const double low = centre - surfaceReach(slice, peak, cell, -along, side, level);
        sum.width += high - low;
        sum.moment += 0.5 * (high * high - low * low);
    }
    return sum;
}

/// Returns a slice with the uppermost cell of each column in one row, and the cell under it in the row below.
SectionSlice topsOf(const SectionSlice& slice) {
    SectionSlice tops({slice.cells().x, 2});
    for (int x = 0; x < slice.cells().x; ++x) {
        int y = slice.cells().y - 1;
        while (y >= 0 && !slice.held({x, y}))
            --y;
        for (const int row : {1, 0})
            tops.setPeak({x, row}, slice.peak({x, y - 1 + row}));
    }
    return tops;
}

/// Returns the hot surface on the uppermost cells, by their centres.
SurfaceStretch hotTops(const SectionSlice& slice, double level) {
    const SectionSlice tops = topsOf(slice);
    return hotSurface(
        tops, [&](glm::ivec2 cell) { return tops.peak(cell); }, kUp, level);
}

/// Returns the area by strips of cells along `side`, whose ends are between cells.
double areaAlong(const SectionSlice& slice, glm::ivec2 side, double level) {
    const auto peak = [&](glm::ivec2 cell) { return slice.peak(cell); };
    double area = 0;
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x) {
            const glm::ivec2 cell(x, y);
            if (slice.peak(cell) < level) continue;
            for (const glm::ivec2 way : {side, -side})
                area += slice.peak(cell + way) < level ? edgeFrom(peak, cell, way, level) : 0.5;
        }
    return area;
}

/// Returns the area of the parts of the zone that end above the centres of the faces' cells.
double shallowArea(const SectionSlice& slice, glm::ivec2 side, double level) {
    double area = 0;
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x)
            if (slice.isFace({x, y}, side) && slice.peak({x, y}) < level)
                area += shallowDepth(slice, {x, y}, side, level);
    return area;
}

/// A face of the workpiece: its cell's edge, from the grid's corner.
struct Face {
    glm::dvec2 low, high;
};

std::vector<Face> facesOf(const SectionSlice& slice, std::span<const glm::ivec2> sides) {
    std::vector<Face> faces;
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x)
            for (const glm::ivec2 side : sides) {
                if (!slice.isFace({x, y}, side)) continue;
                const glm::dvec2 corner = glm::dvec2(x, y) + glm::dvec2(glm::max(side, glm::ivec2(0)));
                faces.push_back({corner, corner + glm::dvec2(side.y != 0, side.x != 0)});
            }
    return faces;
}

double distanceTo(const std::vector<Face>& faces, glm::dvec2 place) {
    double least = std::numeric_limits<double>::infinity();
    for (const Face& face : faces)
        least = std::min(least, glm::distance(place, glm::clamp(place, face.low, face.high)));
    return std::isfinite(least) ? least : 0;
}

/// Returns the edge places of the zone around a cell, from the grid's corner.
std::vector<glm::dvec2> edgesOf(const SectionSlice& slice, glm::ivec2 cell, std::span<const glm::ivec2> sides,
                                double level) {
    std::vector<glm::dvec2> edges;
    const glm::dvec2 centre = glm::dvec2(cell) + 0.5;
    if (slice.peak(cell) >= level) {
        const auto peak = [&](glm::ivec2 at) { return slice.peak(at); };
        for (const glm::ivec2 way : kWays)
            if (slice.peak(cell + way) < level)
                edges.push_back(centre + glm::dvec2(way) * edgeFrom(peak, cell, way, level));
        return edges;
    }
    for (const glm::ivec2 side : sides) {
        const double depth = slice.isFace(cell, side) ? shallowDepth(slice, cell, side, level) : 0;
        if (depth <= 0) continue;
        edges.push_back(centre + glm::dvec2(side) * 0.5);
        edges.push_back(centre + glm::dvec2(side) * (0.5 - depth));
    }
    return edges;
}

/// Returns the fused stretch of the face that begins in `cell` at a corner and goes on along `along`.
glm::dvec2 fusedFace(const SectionSlice& slice, glm::ivec2 cell, glm::ivec2 along, glm::ivec2 side, double level) {
    const auto peak = [&](glm::ivec2 at) {
        return slice.peak(at) + (slice.isFace(at, side) ? 0.5 * slopeUnderFace(slice, at, side) : 0);
    };
    std::optional<int> first;
    int last = 0;
    for (int i = 0; slice.isFace(cell + i * along, side); ++i) {
        if (peak(cell + i * along) < level) continue;
        if (!first) first = i;
        last = i;
    }
    if (!first) return {0, 0};
    const double inwards = *first > 0 ? edgeFrom(peak, cell + *first * along, -along, level) : 0.5;
    return {*first + 0.5 - inwards, last + 0.5 + edgeFrom(peak, cell + last * along, along, level)};
}

} // namespace

SectionSlice::SectionSlice(glm::ivec2 cells)
    : cells_(cells), peaks_(static_cast<size_t>(cells.x) * static_cast<size_t>(cells.y), kAir) {}

double SectionSlice::peak(glm::ivec2 cell) const {
    if (!inside(cell)) return kAir;
    return peaks_[static_cast<size_t>(cell.y) * static_cast<size_t>(cells_.x) + static_cast<size_t>(cell.x)];
}

void SectionSlice::setPeak(glm::ivec2 cell, double kelvin) {
    peaks_[static_cast<size_t>(cell.y) * static_cast<size_t>(cells_.x) + static_cast<size_t>(cell.x)] = kelvin;
}

bool SectionSlice::inside(glm::ivec2 cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < cells_.x && cell.y < cells_.y;
}

SliceZone measureZone(const SectionSlice& slice, std::span<const glm::ivec2> sides, double level) {
    SliceZone zone;
    const std::vector<Face> faces = facesOf(slice, sides);
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x)
            for (const glm::dvec2 edge : edgesOf(slice, {x, y}, sides, level)) {
                zone.depth = std::max(zone.depth, distanceTo(faces, edge));
                zone.low = glm::min(zone.low, edge);
                zone.high = glm::max(zone.high, edge);
            }
    const bool corner = sides.size() > 1;
    for (const glm::ivec2 side : sides) {
        const auto facePeak = [&](glm::ivec2 cell) {
            return slice.peak(cell) + (slice.isFace(cell, side) ? 0.5 * slopeUnderFace(slice, cell, side) : 0);
        };
        const SurfaceStretch hot = corner ? hotSurface(slice, facePeak, side, level) : hotTops(slice, level);
        zone.width += hot.width;
        if (!corner && hot.width > 0) zone.middle = hot.moment / hot.width;
        zone.area += areaAlong(slice, side, level) / static_cast<double>(sides.size());
        if (corner) zone.area += shallowArea(slice, side, level);
    }
    return zone;
}

std::optional<glm::ivec2> jointCorner(const SectionSlice& slice) {
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x)
            if (!slice.held({x, y}) && slice.held({x, y - 1}) && slice.held({x - 1, y})) return glm::ivec2(x, y);
    return std::nullopt;
}

double rootFusion(const SectionSlice& slice, glm::ivec2 corner, double level) {
    const glm::ivec2 inwards(-1, 0);
    SectionSlice joint({corner.x, 1});
    for (int x = 0; x < corner.x; ++x)
        joint.setPeak({x, 0}, std::min(slice.peak({x, corner.y}), slice.peak({x, corner.y - 1})));
    const auto peak = [&](glm::ivec2 cell) { return joint.peak(cell); };
    glm::ivec2 cell(corner.x - 1, 0);
    if (joint.peak(cell) < level) return shallowDepth(joint, cell, -inwards, level);
    while (joint.peak(cell + inwards) >= level)
        cell += inwards;
    return corner.x - (cell.x + 0.5) + edgeFrom(peak, cell, inwards, level);
}

std::array<glm::dvec2, 2> fusedFaces(const SectionSlice& slice, glm::ivec2 corner, double level) {
    return {fusedFace(slice, corner - glm::ivec2(0, 1), {1, 0}, {0, 1}, level),
            fusedFace(slice, corner - glm::ivec2(1, 0), {0, 1}, {1, 0}, level)};
}

bool isOpenCorner(const SectionSlice& slice, glm::ivec2 corner) {
    return !slice.held(corner - 1);
}

std::optional<glm::dvec2> fusedTop(const SectionSlice& slice, double level) {
    const SectionSlice tops = topsOf(slice);
    const auto peak = [&](glm::ivec2 cell) {
        return tops.peak(cell) + (tops.isFace(cell, kUp) ? 0.5 * slopeUnderFace(tops, cell, kUp) : 0);
    };
    const SurfaceStretch hot = hotSurface(tops, peak, kUp, level);
    if (hot.width <= 0) return std::nullopt;
    const double middle = hot.moment / hot.width;
    return glm::dvec2(middle - 0.5 * hot.width, middle + 0.5 * hot.width);
}

std::optional<double> unfusedEdge(const SectionSlice& slice, int seam, int side, double level) {
    const auto peak = [&](glm::ivec2 at) { return slice.peak(at); };
    std::optional<int> lowest;
    int held = 0;
    for (int y = 0; y < slice.cells().y; ++y) {
        glm::ivec2 cell(side < 0 ? seam - 1 : seam, y);
        while (slice.inside(cell) && !slice.held(cell))
            cell.x += side;
        if (!slice.held(cell)) continue;
        if (!lowest) lowest = y;
        ++held;
        if (slice.peak(cell) >= level) return std::max(y + 0.5 - edgeFrom(peak, cell, {0, -1}, level) - *lowest, 0.0);
    }
    return lowest ? std::optional<double>(held) : std::nullopt;
}

} // namespace meltpool
