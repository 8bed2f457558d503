// Lists what is near a place from the residents of the cells around it. Included after flow_common.glsl.

/// Which of up to 32 residents of a cell from `first` on, in their order (moving ones, then still metal), lie within the
/// reach of neighbour lists: a bit each.
uint nearResidents(uint cell, uint moving, uint first, uint count, vec3 origin, vec3 scale) {
    const float reach = fluid.search.x * fluid.search.x;
    uint near = 0;
    for (uint entry = 0; entry < count; ++entry) {
        const vec3 d = apartPacked(origin, residentTexel(residentOf(cell, moving, first + entry)).x, scale);
        near |= dot(d, d) < reach ? 1u << entry : 0u;
    }
    return near;
}

/// Which of the 27 cells around `centre`, in the order of nextStep(), hold something that may be near: a bit each.
uint nearCells(ivec3 centre, vec3 steps, uint parity, bool withStill) {
    const vec3 inside = steps / 1024;
    const float reach = fluid.search.x * fluid.search.x;
    const vec3 edge = 1 / fluid.inverseCell.xyz;
    uint near = 0;
    uint bit = 1;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        const vec3 sides = mix(1 - inside, inside, lessThan(step, ivec3(0))); // to the cell's nearest face, in cells
        const vec3 off = mix(sides * edge, vec3(0), equal(step, ivec3(0)));
        uint cell;
        const bool within = neighbourCell(centre, step, cell) && dot(off, off) < reach;
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
    const vec3 scale = packedScale();
    for (uint cells = nearCells(centre, steps, parity, moves); cells != 0; cells &= cells - 1) {
        const ivec3 step = stepOf(findLSB(cells));
        uint cell;
        neighbourCell(centre, step, cell);
        const uvec2 counts = countTexel(cell, parity);
        const uint total = counts.y + (moves ? counts.x : 0u);
        const vec3 origin = steps - vec3(step) * 1024;
        for (uint first = 0; first < total; first += 32) {
            uint near = nearResidents(cell, counts.y, first, min(total - first, 32u), origin, scale);
            for (; near != 0 && found < FLOW_NEIGHBOUR_ROOM; near &= near - 1) {
                const uint entry = first + uint(findLSB(near));
                const uint other = residentTexel(residentOf(cell, counts.y, entry)).y;
                const bool still = entry >= counts.y;
                if ((other & FLOW_SLOT) != slot && (!moves || still || (other & FLOW_RENEWS) != 0))
                    neighbours[base + GROUP_SIZE * found++] =
                        still ? other | FLOW_SOLID | FLOW_RESTS : other & ~FLOW_RENEWS;
            }
        }
    }
    return found;
}
