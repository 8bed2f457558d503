#include "core/surface/cell_cases.hpp"

#include <bit>
#include <cstddef>

namespace meltpool {

namespace {

using Face = std::array<unsigned, 4>;

/// Returns the corners of the six faces, counter-clockwise seen from outside the cell.
std::array<Face, 6> cellFaces() {
    std::array<Face, 6> faces{};
    for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, far = 1U << axis;
        faces[axis * 2] = {0, v, u | v, u};
        faces[axis * 2 + 1] = {far, far | u, far | u | v, far | v};
    }
    return faces;
}

CellEdge edgeBetween(unsigned a, unsigned b) {
    return (a & b) | static_cast<unsigned>(std::countr_zero(a ^ b)) << 3;
}

bool onFace(CellEdge edge, const Face& face) {
    const unsigned low = edge & 7, high = low | 1U << (edge >> 3);
    bool foundLow = false, foundHigh = false;
    for (const unsigned corner : face) {
        foundLow |= corner == low;
        foundHigh |= corner == high;
    }
    return foundLow && foundHigh;
}

bool shareFace(CellEdge a, CellEdge b) {
    for (const Face& face : cellFaces())
        if (onFace(a, face) && onFace(b, face)) return true;
    return false;
}

constexpr CellEdge kNoEdge = ~0U;

/// Returns for every edge that crosses the surface the next one of its loop. Going counter-clockwise around a face, one
/// edge leads into a run of inside corners and one out of it; the segment connects the former to the latter.
std::array<CellEdge, 32> nextEdges(unsigned inside) {
    std::array<CellEdge, 32> next{};
    next.fill(kNoEdge);
    const auto isInside = [inside](unsigned corner) { return (inside >> corner & 1U) != 0; };
    for (const Face& face : cellFaces())
        for (unsigned i = 0; i < 4; ++i) {
            if (isInside(face[i]) || !isInside(face[(i + 1) % 4])) continue;
            unsigned last = i + 1;
            while (isInside(face[(last + 1) % 4]))
                ++last;
            next[edgeBetween(face[i], face[(i + 1) % 4])] = edgeBetween(face[last % 4], face[(last + 1) % 4]);
        }
    return next;
}

/// Splits the part of a loop from index `first` to `last` into triangles none of whose inner edges is in a face.
/// Returns false when that is impossible.
bool fillLoop(const std::vector<CellEdge>& loop, std::size_t first, std::size_t last,
              std::vector<CellTriangle>& triangles) {
    if (last - first < 2) return true;
    const auto allowed = [&loop](std::size_t a, std::size_t b) {
        return b - a == 1 || b - a == loop.size() - 1 || !shareFace(loop[a], loop[b]);
    };
    const std::size_t kept = triangles.size();
    for (std::size_t middle = first + 1; middle < last; ++middle) {
        if (!allowed(first, middle) || !allowed(middle, last)) continue;
        triangles.push_back({loop[first], loop[middle], loop[last]});
        if (fillLoop(loop, first, middle, triangles) && fillLoop(loop, middle, last, triangles)) return true;
        triangles.resize(kept);
    }
    return false;
}

} // namespace

std::vector<CellTriangle> cellTriangles(unsigned inside) {
    std::array<CellEdge, 32> next = nextEdges(inside);
    std::vector<CellTriangle> triangles;
    for (CellEdge start = 0; start < next.size(); ++start) {
        std::vector<CellEdge> loop;
        for (CellEdge edge = start; next[edge] != kNoEdge;) {
            loop.push_back(edge);
            const CellEdge following = next[edge];
            next[edge] = kNoEdge;
            edge = following;
        }
        if (!loop.empty()) fillLoop(loop, 0, loop.size() - 1, triangles);
    }
    return triangles;
}

std::vector<std::uint32_t> cellCaseTable() {
    std::vector<std::uint32_t> table(256);
    for (unsigned inside = 0; inside < 256; ++inside) {
        const std::vector<CellTriangle> triangles = cellTriangles(inside);
        table[inside] = static_cast<std::uint32_t>(triangles.size() | table.size() << 3);
        for (const CellTriangle& triangle : triangles)
            table.push_back(triangle[0] | triangle[1] << 5 | triangle[2] << 10);
    }
    return table;
}

} // namespace meltpool
