// Conduction between a cell and the cells diagonally opposite in its twelve squares, for passes with an invocation a cell.
// Included after neighbours.glsl.

/// The diagonally opposite cells in the planes xy, yz and xz. The first word is the side along the plane's first axis, the
/// second that along its second.
struct Diagonals {
    vec3 lowLow, highLow, lowHigh, highHigh;
};

/// How much of each square conducts: as its least filled cell allows, where its tiles take part and no wall is in it.
struct SquareFills {
    vec3 lowLow, highLow, lowHigh, highHigh;
};

ivec3 diagonalCells(ivec3 first, ivec3 second) { return first.xyx + second.yzz; }
vec3 firstOf(vec3 alongAxes) { return alongAxes.xyx; }
vec3 secondOf(vec3 alongAxes) { return alongAxes.yzz; }
bvec3 firstOf(bvec3 alongAxes) { return alongAxes.xyx; }
bvec3 secondOf(bvec3 alongAxes) { return alongAxes.yzz; }
