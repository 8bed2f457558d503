#version 450 core
#extension GL_GOOGLE_include_directive : require
// Orders the moving metal of each cell by slot, and lists the still metal that comes to lie beside moving metal.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

/// Lists the still metal of the cells around `cell`, each cell once a substep.
void wakeAround(uint cell) {
    const ivec3 centre = ivec3(cell % uint(fluid.cells.x), cell / uint(fluid.cells.x) % uint(fluid.cells.y),
                               cell / uint(fluid.cells.x * fluid.cells.y));
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                uint other;
                if (!neighbourCell(centre, ivec3(x, y, z), other)) continue;
                const uint count = cells[other].still;
                if (count == 0 || cells[other].wakened == substep) continue;
                if (atomicExchange(cells[other].wakened, substep) == substep) continue;
                const uint first = atomicAdd(counters.densityGroups.w, count);
                const uint room = fluid.room.x;
                for (uint entry = 0; entry < count && first + entry < room; ++entry)
                    lists[2 * room + first + entry] = still[other * FLOW_CELL_ROOM + entry];
                const uint all = counters.sortGroups.w + min(first + count, room);
                atomicMax(counters.densityGroups.x, (all + GROUP_SIZE - 1) / GROUP_SIZE);
            }
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= counters.sortGroups.w) return;
    const uint slot = lists[index];
    const uint parity = substep & 1u;
    const uint cell = bodies[slot].where[parity];
    const uint count = cellMoving(cell, parity);
    uint rank = 0;
    for (uint entry = 0; entry < count; ++entry)
        rank += entered[cell * FLOW_CELL_ROOM + entry] < slot ? 1u : 0u;
    const uint solid = (phases[slot] & PHASE_LIQUID) != 0 ? 0u : FLOW_SOLID;
    if (rank < FLOW_CELL_ROOM)
        sorted[cell * FLOW_CELL_ROOM + rank] = uvec4(floatBitsToUint(positions[slot].xyz), slot | solid);
    if (rank == 0) wakeAround(cell);
}
