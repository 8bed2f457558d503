// Conduction in the squares of four cells that a cell makes with its neighbours (stencil.glsl), for passes with an invocation a
// cell. Included after stirring.glsl.

/// The neighbours of a cell along x, y and z on the low or on the high side.
struct Side {
    ivec3 offset;
    bvec3 edge; // true in another tile
    vec3 theta;
    vec3 fill; // share of a full face that conducts from metal to metal
};

/// Stamps of the tiles that the squares in the planes xy, yz and xz are in: of the cell itself, of its neighbours along
/// the first and along the second axis of the plane, where these are in another tile, and across both.
struct SquareTiles {
    ivec3 own, first, second, both;
    bvec3 full; // none of the four holds metal off the lattice
};

SquareTiles squareTiles(int tile, int stamp, Neighbours n) {
    const ivec3 across = n.tiles.xyx + n.tiles.yzz - tile;
    SquareTiles t;
    t.own = ivec3(stamp);
    t.first = n.stamps.xyx;
    t.second = n.stamps.yzz;
    t.both = ivec3(stampOf(across.x), stampOf(across.y), stampOf(across.z));
    t.full = equal((t.own | t.first | t.second | t.both) & TILE_SHARED, ivec3(0));
    return t;
}

/// Contribution of a cell's squares to the conduction through its faces.
struct SquareSum {
    float twist; // W/m
    float fill;  // number of full squares that count
    float coldest, hottest; // theta of the cells diagonally opposite
};

/// Adds the squares in the planes xy, yz and xz on one side along the first axis and one along the second.
void addSquares(inout SquareSum sum, SquareTiles tiles, int cell, float theta, Side first, Side second) {
    const bvec3 edgeFirst = first.edge.xyx, edgeSecond = second.edge.yzz;
    const ivec3 stamps = mix(mix(tiles.own, tiles.second, edgeSecond), mix(tiles.first, tiles.both, edgeSecond), edgeFirst);
    const bvec3 open = equal(stamps >> TILE_STEP_SHIFT, ivec3(heatBlock.stepNumber));
    // A plain tile does not know the fullness of the cells diagonally across its edges.
    const bvec3 unknown = bvec3(ivec3(edgeFirst) & ivec3(edgeSecond) & ivec3(not(tiles.full)));
    const ivec3 cells = cell + first.offset.xyx + second.offset.yzz;
    const ivec3 at = cells + (stamps & TILE_HALF) * (heatBlock.tileCount * TILE_CELLS);
    const vec3 opposite = vec3(texelFetch(thetaTexels, at.x).x, texelFetch(thetaTexels, at.y).x, texelFetch(thetaTexels, at.z).x);
    const vec3 weights = vec3(weightOf(cells.x), weightOf(cells.y), weightOf(cells.z));
    vec3 fill = min(weights, min(first.fill.xyx, second.fill.yzz)) * vec3(open) * vec3(not(unknown));
    fill *= vec3(greaterThanEqual(opposite, vec3(0)));
    sum.twist += dot(fill, twistOf(ledInPlanes(vec3(theta)), ledInPlanes(first.theta.xyx), ledInPlanes(second.theta.yzz),
                                   ledInPlanes(opposite)));
    sum.fill += fill.x + fill.y + fill.z;
    const bvec3 none = equal(fill, vec3(0));
    const vec3 cold = mix(opposite, vec3(3.4e38), none), hot = mix(opposite, vec3(0), none);
    sum.coldest = min(sum.coldest, min(min(cold.x, cold.y), cold.z));
    sum.hottest = max(sum.hottest, max(max(hot.x, hot.y), hot.z));
}

SquareSum squaresOf(int tile, int cell, int stamp, float theta, Neighbours n, Side low, Side high) {
    const SquareTiles tiles = squareTiles(tile, stamp, n);
    SquareSum sum = SquareSum(0.0, 0.0, 3.4e38, 0.0);
    addSquares(sum, tiles, cell, theta, low, low);
    addSquares(sum, tiles, cell, theta, high, low);
    addSquares(sum, tiles, cell, theta, low, high);
    addSquares(sum, tiles, cell, theta, high, high);
    return sum;
}
