// Lists the particles near a position from the lists of the cells around it. Included after common.glsl.
//
// Distances are those of packed positions: their differences are whole numbers, so that two particles see one distance,
// and four fit a texel. SYNCHRONOUS_DRIVER: each texel costs time.

/// The factors (m²) by which the squares of a way's components, in steps of a 1024th of the cell, sum to its square.
vec3 squareOfStep() {
    const vec3 step = 1 / (1024 * fluid.inverseCellSize);
    return step * step;
}

/// The particles of a cell in quads of four: first moving metal, then wall metal.
struct Quads {
    uint moving, all; // number of quads
    uint wallParticles, movingParticles; // number of particles
    uint wallBase, movingBase; // starts of its lists
};

Quads quadsOf(uint cell, bool withWalls) {
    const uvec4 listed = readCell(cell);
    const uvec2 counts = uvec2(withWalls ? listed.x : 0u, listed.y);
    const uvec2 quads = (counts + 3) >> 2;
    return Quads(quads.y, quads.x + quads.y, counts.x, counts.y, wallBase(listed.z), movingBase(listed.w));
}

/// Index of the first particle of a quad, and how many there are from it on.
uint indexOfQuad(Quads quads, uint quad, out uint rest) {
    const bool moves = quad < quads.moving;
    const uint first = 4 * (moves ? quad : quad - quads.moving);
    rest = (moves ? quads.movingParticles : quads.wallParticles) - first;
    return (moves ? quads.movingBase : quads.wallBase) + first;
}

/// The particles of up to 8 quads from `first` on that are within the reach of neighbour lists around `origin`, given
/// in steps of their cell: a bit each.
uint nearInQuads(Quads quads, uint first, vec3 origin, vec3 square) {
    const float reach = fluid.reach * fluid.reach;
    uint near = 0;
    const uint count = min(quads.all - first, 8u);
    for (uint k = 0; k < count; ++k) {
        uint rest;
        const uint index = indexOfQuad(quads, first + k, rest);
        const uvec4 words = texelFetch(pagePositionTexels, int(index >> 2));
        const vec4 x = origin.x - vec4(words & 1023u);
        const vec4 y = origin.y - vec4((words >> 10) & 1023u);
        const vec4 z = origin.z - vec4(words >> 20);
        const uvec4 within = uvec4(lessThan(x * x * square.x + y * y * square.y + z * z * square.z, vec4(reach)));
        const uint quad = within.x | within.y << 1 | within.z << 2 | within.w << 3;
        near |= (quad & ((1u << min(rest, 4u)) - 1)) << (4 * k);
    }
    return near;
}

/// The cells among the 27 around `centre`, in the order of nextStep(), that hold something that may be near: a bit
/// each.
uint nearCells(ivec3 centre, vec3 steps, vec3 square, bool withWalls) {
    const float reach = fluid.reach * fluid.reach;
    uint near = 0;
    uint bit = 1;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        const vec3 sides = mix(1024 - steps, steps, lessThan(step, ivec3(0))); // distances to the cell's nearest face
        const vec3 off = mix(sides, vec3(0), equal(step, ivec3(0)));
        uint cell;
        const bool within = neighbourCell(centre, step, cell) &&
                            off.x * off.x * square.x + off.y * off.y * square.y + off.z * off.z * square.z < reach;
        const uvec4 counts = readCell(within ? cell : 0);
        near |= within && counts.y + (withWalls ? counts.x : 0u) > 0 ? bit : 0u;
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

/// Up to 32 near particles of one cell: a bit each, and their indices.
const uint kNearSpans = 32;
struct NearSpan {
    uint near;
    uint movingEnd;  // bit after those of moving particles
    uint movingBase; // index in `pages` of bit 0's particle, if that moves
    uint wallBase;   // index in `pages` of bit 0's particle, if that is wall metal
};

NearSpan spanOf(Quads quads, uint firstQuad, uint near) {
    const uint first = 4 * firstQuad, moving = 4 * quads.moving;
    return NearSpan(near, max(moving, first) - first, quads.movingBase + first, quads.wallBase + first - moving);
}

/// Index in `pages` of a bit's particle; `isWall`: it is wall metal.
uint indexOfBit(NearSpan span, uint bit, out bool isWall) {
    isWall = bit >= span.movingEnd;
    return (isWall ? span.wallBase : span.movingBase) + bit;
}

/// Adds the particles near `place`, except `slot` itself, to the list at `base`, which holds `found`; returns the new
/// number. Wall metal lists no wall metal: `withWalls` is false for it. `renewing`: lists only moving metal that renews
/// its list too. `unlisted`: some of them are solid metal that is no boundary particle yet.
///
/// Looks at cells and particles first and then at the near ones, in loops that advance together for all invocations.
/// SYNCHRONOUS_DRIVER: it runs every loop as often as the parallel invocation that needs it most.
uint listNeighbours(uint slot, vec3 place, uint base, uint found, bool withWalls, bool renewing, out bool unlisted) {
    const uint since = counters.fullSearch;
    unlisted = false;
    const ivec3 centre = cellAt(place);
    const vec3 steps = stepsInside(place);
    const vec3 square = squareOfStep();
    NearSpan spans[kNearSpans];
    uint cells = nearCells(centre, steps, square, withWalls);
    while (cells != 0) {
        uint count = 0;
        for (; cells != 0 && count + FLOW_CELL_CAPACITY / 16 <= kNearSpans; cells &= cells - 1) {
            const ivec3 step = stepOf(findLSB(cells));
            uint cell;
            neighbourCell(centre, step, cell);
            const Quads quads = quadsOf(cell, withWalls);
            const vec3 origin = steps - vec3(step) * 1024;
            for (uint first = 0; first < quads.all; first += 8) {
                const uint near = nearInQuads(quads, first, origin, square);
                spans[count] = spanOf(quads, first, near);
                count += near != 0 ? 1u : 0u;
            }
        }
        NearSpan span = NearSpan(0u, 0u, 0u, 0u);
        for (uint k = 0; found < FLOW_NEIGHBOUR_CAPACITY && (span.near != 0 || k < count); span.near &= span.near - 1) {
            if (span.near == 0) span = spans[k++];
            bool isWall;
            const uint other = pageSlotTexel(indexOfBit(span, uint(findLSB(span.near)), isWall));
            const bool isSolid = isWall || (other & FLOW_SOLID) != 0;
            unlisted = unlisted || (isSolid && particles[other & FLOW_SLOT].listedSince != since);
            if ((other & FLOW_SLOT) != slot && (!renewing || isWall || (other & FLOW_RENEWS) != 0))
                neighbours[base + GROUP_SIZE * found++] =
                    isWall ? other | FLOW_SOLID | FLOW_WALL : other & ~FLOW_RENEWS;
        }
    }
    return found;
}
