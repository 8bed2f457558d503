// Lists what is near a place from the residents of the cells around it. Included after flow_common.glsl.
//
// Distances are those of packed places: their differences are whole numbers, so that two particles see the same distance, and
// four fit a texel. Drivers that run on the CPU pay for each texel.

/// The square of a way in steps of a 1024th of the cell is the sum of the axes' squares times these, m².
vec3 squareOfStep() {
    const vec3 step = 1 / (1024 * fluid.inverseCell.xyz);
    return step * step;
}

/// Residents of a cell in fours: first those that move, then still metal.
struct Fours {
    uint moving, all; // how many fours
    uvec2 counts;     // residents: x still, y moving
    uint cell;
};

Fours foursOf(uint cell, uint parity, bool withStill) {
    uvec2 counts = countTexel(cell, parity);
    counts.x = withStill ? min(counts.x, FLOW_CELL_ROOM) : 0u;
    const uvec2 fours = (counts + 3) >> 2;
    return Fours(fours.y, fours.x + fours.y, counts, cell);
}

/// First of the residents of a four, and how many there are from it on.
uint entryOf(Fours fours, uint four, out uint rest) {
    const bool moves = four < fours.moving;
    const uint first = 4 * (moves ? four : four - fours.moving);
    rest = (moves ? fours.counts.y : fours.counts.x) - first;
    return (moves ? movingBase(fours.cell) : stillBase(fours.cell)) + first;
}

/// Which of up to 8 fours from `first` on lie within the reach of neighbour lists around the place at `origin`, in steps of
/// their cell: a bit each resident.
uint nearFours(Fours fours, uint first, vec3 origin, vec3 square) {
    const float reach = fluid.search.x * fluid.search.x;
    uint near = 0;
    const uint count = min(fours.all - first, 8u);
    for (uint k = 0; k < count; ++k) {
        uint rest;
        const uint entry = entryOf(fours, first + k, rest);
        const uvec4 words = texelFetch(residentPlaceTexels, int(entry >> 2));
        const vec4 x = origin.x - vec4(words & 1023u);
        const vec4 y = origin.y - vec4((words >> 10) & 1023u);
        const vec4 z = origin.z - vec4(words >> 20);
        const uvec4 within = uvec4(lessThan(x * x * square.x + y * y * square.y + z * z * square.z, vec4(reach)));
        const uint four = within.x | within.y << 1 | within.z << 2 | within.w << 3;
        near |= (four & ((1u << min(rest, 4u)) - 1)) << (4 * k);
    }
    return near;
}

/// Which of the 27 cells around `centre`, in the order of nextStep(), hold something that may be near: a bit each.
uint nearCells(ivec3 centre, vec3 steps, vec3 square, uint parity, bool withStill) {
    const float reach = fluid.search.x * fluid.search.x;
    uint near = 0;
    uint bit = 1;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        const vec3 sides = mix(1024 - steps, steps, lessThan(step, ivec3(0))); // to the cell's nearest face
        const vec3 off = mix(sides, vec3(0), equal(step, ivec3(0)));
        uint cell;
        const bool within = neighbourCell(centre, step, cell) &&
                            off.x * off.x * square.x + off.y * off.y * square.y + off.z * off.z * square.z < reach;
        const uvec2 counts = countTexel(within ? cell : 0, parity);
        near |= within && counts.y + (withStill ? counts.x : 0u) > 0 ? bit : 0u;
        bit <<= 1;
    }
    return near;
}

/// Step number `bit` (0 .. 26) of nextStep(). Division by 3 as a product: integer division is slow, on a CPU above all.
ivec3 stepOf(int bit) {
    const int row = bit * 11 >> 5;
    const int layer = row * 11 >> 5;
    return ivec3(bit - 3 * row, row - 3 * layer, layer) - 1;
}

/// Adds what is near `place` but `slot` itself to the list at `base`, which holds `found`; gives the number found then. Moving
/// metal is listed by one that moves only where both list anew, still metal only by one that moves. Looks at cells, residents
/// and what is near in turn: drivers that run on the CPU go through the inside of every loop at least once, and pay for every
/// write that any particle might do.
uint listNear(uint slot, vec3 place, uint base, uint found, uint parity, bool moves) {
    const ivec3 centre = cellAt(place);
    const vec3 steps = stepsInside(place);
    const vec3 square = squareOfStep();
    for (uint cells = nearCells(centre, steps, square, parity, moves); cells != 0; cells &= cells - 1) {
        const ivec3 step = stepOf(findLSB(cells));
        uint cell;
        neighbourCell(centre, step, cell);
        const Fours fours = foursOf(cell, parity, moves);
        const vec3 origin = steps - vec3(step) * 1024;
        for (uint first = 0; first < fours.all; first += 8) {
            uint near = nearFours(fours, first, origin, square);
            for (; near != 0 && found < FLOW_NEIGHBOUR_ROOM; near &= near - 1) {
                const uint bit = uint(findLSB(near));
                const uint four = first + (bit >> 2);
                uint rest;
                const uint other = residentTexel(entryOf(fours, four, rest) + (bit & 3u));
                const bool still = four >= fours.moving;
                if ((other & FLOW_SLOT) != slot && (!moves || still || (other & FLOW_RENEWS) != 0))
                    neighbours[base + GROUP_SIZE * found++] =
                        still ? other | FLOW_SOLID | FLOW_RESTS : other & ~FLOW_RENEWS;
            }
        }
    }
    return found;
}
