// The coldest and the hottest particle of a cell that metal off the lattice shares, and the rate at which its particles
// even out with it. Included after common.glsl.
//
// A cell's conduction follows from its mean, and each of its particles gets its share by weight. The coldest particle
// of a cell with a hot mean would so give heat to neighbours that are hotter than itself. The exchange with the cell
// prevents this: it is just strong enough that no particle leaves the range of its cell and the neighbouring cells.
layout(std430, binding = HEAT_CELL_RANGE) restrict buffer CellRanges { uvec2 cellRange[]; };

/// Smallest exchange of particles that share a cell with it, in conductances of two neighbouring cells, times the
/// cell's fullness: evens out differences that the cells themselves cannot see. It also spreads heat where the cells'
/// unevenness hinders it: with 1.22 the two balance, and liquid conducts within 2 % of the correct value, at rest or
/// flowing; with 1.3 it would conduct up to 3 % too much.
const float kCellExchange = 1.22;

/// Theta of the coldest and the hottest particle of a cell, W/m.
struct CellRange {
    float low, high;
};

/// The bits of floats from 0 on rise with the float; the lowest are stored inverted: an empty range is 0, and the
/// greater value wins in both.
void addToRange(int cell, float theta) {
    uint bits = floatBitsToUint(theta);
    atomicMax(cellRange[cell].x, ~bits);
    atomicMax(cellRange[cell].y, bits);
}

CellRange rangeOf(int cell) {
    uvec2 bits = cellRange[cell];
    return CellRange(uintBitsToFloat(~bits.x), uintBitsToFloat(bits.y));
}

bool isShared(int cell) { return cellRange[cell].x != 0u; }

/// Replaces the range once conduction is known: conductance of the exchange between a cell and all its particles
/// together, W/m per W/m of theta over a spacing.
void writeExchange(int cell, float exchange) { cellRange[cell].x = floatBitsToUint(exchange); }
float exchangeOf(int cell) { return uintBitsToFloat(cellRange[cell].x); }
void clearRange(int cell) { cellRange[cell] = uvec2(0); }
