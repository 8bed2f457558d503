#include "core/weld/gauge/section_slice.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace meltpool {

namespace {

constexpr std::array<glm::ivec2, 4> kWays{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Where the zone ends on the way out of a hot cell whose neighbour on that way is colder or air, in cells from the hot
/// cell's centre.
double edgeFrom(const SectionSlice& slice, glm::ivec2 hot, glm::ivec2 way, double level) {
    if (!slice.held(hot + way)) return 0.5;
    const double inside = slice.peak(hot), first = slice.peak(hot + way);
    if (std::isfinite(inside)) return 1 - (level - first) / (inside - first);
    // The hotter cell is gone: go on towards its centre with a slope that grows as it did over the three before it.
    const double second = slice.peak(hot + 2 * way), third = slice.peak(hot + 3 * way);
    const double slope = std::isfinite(second) ? first - second : 0;
    const double before = std::isfinite(second) && std::isfinite(third) ? second - third : 0;
    const double steeper = before > 0 ? std::max(slope, slope * slope / before) : slope;
    return 1 - (slope > 0 ? std::min(1.0, (level - first) / steeper) : 0.5);
}

/// Length of the hot surface from the centre of a hot face cell along `way`, in cells.
double surfaceReach(const SectionSlice& slice, glm::ivec2 hot, glm::ivec2 way, glm::ivec2 side, double level) {
    double reach = 0;
    for (;;) {
        glm::ivec2 next = hot + way;
        const bool gap = !slice.held(next);
        const auto inside = [&] {
            return next.x >= 0 && next.y >= 0 && next.x < slice.cells().x && next.y < slice.cells().y;
        };
        while (inside() && !slice.held(next))
            next += way;
        const bool face = slice.isFace(next, side);
        if (!face || slice.peak(next) < level) {
            // A corner ends the surface in the middle between two cells, as air does.
            return reach + (face && !gap ? edgeFrom(slice, hot, way, level) : 0.5);
        }
        reach += std::abs(next.x - hot.x) + std::abs(next.y - hot.y);
        hot = next;
    }
}

/// Width of the hot surface on all faces that look to `side`, each plane of faces for itself.
double surfaceWidth(const SectionSlice& slice, glm::ivec2 side, double level) {
    const glm::ivec2 along(std::abs(side.y), std::abs(side.x));
    std::map<int, glm::ivec2> hottest; // by the plane's place
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x) {
            const glm::ivec2 cell(x, y);
            if (!slice.isFace(cell, side) || slice.peak(cell) < level) continue;
            const auto [place, isNew] = hottest.try_emplace(side.y != 0 ? y : x, cell);
            if (!isNew && slice.peak(cell) > slice.peak(place->second)) place->second = cell;
        }
    double width = 0;
    for (const auto& [plane, cell] : hottest)
        width += surfaceReach(slice, cell, along, side, level) + surfaceReach(slice, cell, -along, side, level);
    return width;
}

/// Area by strips of cells along `way`; their ends lie between cells.
double areaAlong(const SectionSlice& slice, glm::ivec2 way, double level) {
    double area = 0;
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x) {
            const glm::ivec2 cell(x, y);
            if (slice.peak(cell) < level) continue;
            for (const glm::ivec2 each : {way, -way})
                area += slice.peak(cell + each) < level ? edgeFrom(slice, cell, each, level) : 0.5;
        }
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

} // namespace

SectionSlice::SectionSlice(glm::ivec2 cells)
    : cells_(cells), peaks_(static_cast<size_t>(cells.x) * static_cast<size_t>(cells.y), kAir) {}

double SectionSlice::peak(glm::ivec2 cell) const {
    if (cell.x < 0 || cell.y < 0 || cell.x >= cells_.x || cell.y >= cells_.y) return kAir;
    return peaks_[static_cast<size_t>(cell.y) * static_cast<size_t>(cells_.x) + static_cast<size_t>(cell.x)];
}

void SectionSlice::setPeak(glm::ivec2 cell, double kelvin) {
    peaks_[static_cast<size_t>(cell.y) * static_cast<size_t>(cells_.x) + static_cast<size_t>(cell.x)] = kelvin;
}

SliceZone measureZone(const SectionSlice& slice, std::span<const glm::ivec2> sides, double level) {
    SliceZone zone;
    const std::vector<Face> faces = facesOf(slice, sides);
    for (int y = 0; y < slice.cells().y; ++y)
        for (int x = 0; x < slice.cells().x; ++x) {
            const glm::ivec2 cell(x, y);
            if (slice.peak(cell) < level) continue;
            for (const glm::ivec2 way : kWays) {
                if (slice.peak(cell + way) >= level) continue;
                const glm::dvec2 edge = glm::dvec2(cell) + 0.5 + glm::dvec2(way) * edgeFrom(slice, cell, way, level);
                zone.depth = std::max(zone.depth, distanceTo(faces, edge));
                zone.low = glm::min(zone.low, edge);
                zone.high = glm::max(zone.high, edge);
            }
        }
    for (const glm::ivec2 side : sides) {
        zone.width += surfaceWidth(slice, side, level);
        zone.area += areaAlong(slice, side, level) / static_cast<double>(sides.size());
    }
    return zone;
}

} // namespace meltpool
