// Marching cubes: the triangles of each of the 256 cases of a cell, derived by a rule instead of a table.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace meltpool {

/// An edge of a cell: bits 0-2 its lower corner (dx + 2 dy + 4 dz), bits 3-4 its axis.
using CellEdge = std::uint32_t;

/// Three edges, counter-clockwise seen from outside in a right-handed grid.
using CellTriangle = std::array<CellEdge, 3>;

/// Returns the triangles of a cell whose corner dx + 2 dy + 4 dz is inside if that bit of `inside` is set: at most
/// five.
///
/// The surface cuts every face of the cell in segments, one around each run of inside corners; two inside corners that
/// share only the face's diagonal get a segment each. The segments depend on the four corners of the face alone, so
/// that two cells that share a face agree on them and the surface is closed. The segments of the six faces join to
/// loops. A loop is split into triangles; no inner edge of the split is in a face, which the neighbour's edges could
/// use too.
std::vector<CellTriangle> cellTriangles(unsigned inside);

/// Largest number of triangles in a cell.
inline constexpr unsigned kMostCellTriangles = 5;

/// Returns all cases as the shaders read them. Words 0-255, one a case: bits 0-2 hold the number of triangles, the rest
/// the word of the first triangle. Then one word a triangle: its three edges of 5 bits, the first in the lowest bits.
std::vector<std::uint32_t> cellCaseTable();

} // namespace meltpool
