// How a particle that melts leaves the lattice for the list of loose ones, and the changes of phase that others follow.
// Included after heat_common.glsl.
layout(std430, binding = HEAT_CHANGES) restrict buffer Changes { uint changes[]; };
layout(std430, binding = HEAT_LISTS) restrict buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };
layout(std430, binding = HEAT_HOMES) restrict buffer Homes { uint homes[]; };

/// Notes a slot whose phase bits changed.
void noteChange(uint slot) {
    uint place = atomicAdd(changes[0], 1u);
    if (place < uint(metal.capacity)) changes[place + 1u] = slot;
}

/// Puts a slot into the list of loose ones, once.
void joinLoose(uint slot) {
    homes[slot] = HEAT_LOOSE;
    uint place = atomicAdd(control.loose.w, 1u);
    if (place % GROUP_SIZE == 0u) atomicAdd(control.loose.x, 1u);
    lists[3 * heatBlock.step.w + int(place)] = slot;
}

/// Frees the cell of a particle that sits on the lattice no more; `place`: where others will look for its theta.
void freeCell(int cell, int place) {
    cellTheta[place] = kEmpty;
    cellWeight[cell] = 0.0;
    tiles[cell / TILE_CELLS].lastNeed = heatBlock.step.x;
}

/// Writes the phase that a particle of the lattice has at its enthalpy; it may leave its cell.
void writePhase(uint slot, int cell, int place, float enthalpy) {
    uint before = texelFetch(phaseTexels, int(slot)).x;
    uint after = nextPhase(before, enthalpy);
    if (after == before) return;
    bool leaves = (after & PHASE_LIQUID) != 0u && heatBlock.step.z != 0;
    phase[slot] = leaves ? after & ~PHASE_LATTICE : after;
    noteChange(slot);
    if (!leaves) return;
    latticeSlot[cell] = 0u;
    freeCell(cell, place);
    joinLoose(slot);
}
