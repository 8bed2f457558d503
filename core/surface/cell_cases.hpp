// The 256 ways in which a surface can pass through a cell, as triangles; made by rule, not by a typed table.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace meltpool {

/// An edge of a cell: bits 0-2 its lower corner (dx + 2 dy + 4 dz), bits 3-4 its axis.
using CellEdge = std::uint32_t;

/// Three edges, counter-clockwise seen from outside in a right-handed grid.
using CellTriangle = std::array<CellEdge, 3>;

/// The triangles of a cell whose corner dx + 2 dy + 4 dz is inside where that bit of `inside` is set: at most five.
///
/// On every face of the cell the surface leaves segments around runs of inside corners, so that two inside corners
/// which meet only across a face's diagonal stay apart. The segments depend on that face's four corners alone: two
/// cells that share a face agree on them, and the surface is closed. The segments of the six faces join to loops; a
/// loop becomes triangles whose inner edges never lie in a face, where the neighbour could have the same edge.
std::vector<CellTriangle> cellTriangles(unsigned inside);

/// Largest number of triangles in a cell.
inline constexpr unsigned kMostCellTriangles = 5;

/// All cases as the shaders read them: words 0-255, one a case: bits 0-2 its number of triangles, the rest the word of
/// the first; then one word a triangle: its edges, 5 bits each, the first lowest.
std::vector<std::uint32_t> cellCaseTable();

} // namespace meltpool
