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

/// Residents that are near, up to 32 of a cell at a time: a bit each, and where they stand.
const uint kNearSpans = 32;
struct NearSpan {
    uint near;
    uint place; // cell, fours of moving residents (4 bits), first four over 8 (2 bits)
};

/// Entry among the residents that a bit of a span stands for; whether it is still metal.
uint entryOfBit(uint place, uint bit, out bool still) {
    const uint moving = (place >> 2) & 15u;
    const uint four = 8 * (place & 3u) + (bit >> 2);
    still = four >= moving;
    return movingBase(place >> 6) + 4 * four + (bit & 3u) + (still ? FLOW_CELL_ROOM - 4 * moving : 0);
}

/// Adds what is near `place` but `slot` itself to the list at `base`, which holds `found`; gives the number found then. Moving
/// metal is listed by one that moves only where both list anew, still metal only by one that moves. Looks at cells and
/// residents first and at what is near then, in loops that go on in step for all particles: drivers that run on the CPU go
/// through every loop as often as that of the particles side by side which needs it most. `fresh`: there is still metal
/// among them that no search since the last one of all has found.
uint listNear(uint slot, vec3 place, uint base, uint found, uint parity, bool moves, out bool fresh) {
    const uint since = counters.restless.z;
    fresh = false;
    const ivec3 centre = cellAt(place);
    const vec3 steps = stepsInside(place);
    const vec3 square = squareOfStep();
    NearSpan spans[kNearSpans];
    uint cells = nearCells(centre, steps, square, parity, moves);
    while (cells != 0) {
        uint count = 0;
        for (; cells != 0 && count + FLOW_CELL_ROOM / 16 <= kNearSpans; cells &= cells - 1) {
            const ivec3 step = stepOf(findLSB(cells));
            uint cell;
            neighbourCell(centre, step, cell);
            const Fours fours = foursOf(cell, parity, moves);
            const vec3 origin = steps - vec3(step) * 1024;
            for (uint first = 0; first < fours.all; first += 8) {
                const uint near = nearFours(fours, first, origin, square);
                spans[count] = NearSpan(near, cell << 6 | fours.moving << 2 | first >> 3);
                count += near != 0 ? 1u : 0u;
            }
        }
        NearSpan span = NearSpan(0u, 0u);
        for (uint k = 0; found < FLOW_NEIGHBOUR_ROOM && (span.near != 0 || k < count); span.near &= span.near - 1) {
            if (span.near == 0) span = spans[k++];
            bool still;
            const uint other = residentTexel(entryOfBit(span.place, uint(findLSB(span.near)), still));
            fresh = fresh || (still && bodies[other].where.x != since);
            if ((other & FLOW_SLOT) != slot && (!moves || still || (other & FLOW_RENEWS) != 0))
                neighbours[base + GROUP_SIZE * found++] =
                    still ? other | FLOW_SOLID | FLOW_RESTS : other & ~FLOW_RENEWS;
        }
    }
    return found;
}
