// Moves particles that melt from the lattice to the list of slots off the lattice, lists phase changes for the flow,
// and records the time of freezing. Included after common.glsl.
#define PHASE_CHANGES_BINDING HEAT_CHANGES
#include "metal/phase_changes.glsl"
layout(std430, binding = HEAT_LISTS) restrict buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };
layout(std430, binding = HEAT_FROZEN_AT) restrict writeonly buffer FrozenAt { float frozenAt[]; };
layout(std430, binding = HEAT_KNOWN_CELLS) restrict buffer KnownCells { uint knownCell[]; };

/// Records a slot that melted or froze: its phase bits are `after` now.
void noteChange(uint slot, uint after) {
    frozenAt[slot] = (after & PHASE_LIQUID) != 0u ? METAL_MOLTEN : heatBlock.time;
    listPhaseChange(slot);
}

/// Appends a slot to the list of those off the lattice. Call it once a slot.
void listOffLattice(uint slot) {
    knownCell[slot] = HEAT_OFF_LATTICE;
    uint entry = atomicAdd(control.offLatticeCount, 1u);
    if (entry % GROUP_SIZE == 0u) atomicAdd(control.offLatticeGroups.x, 1u);
    lists[offLatticeSlotsBegin() + int(entry)] = slot;
}

/// Empties the cell of a particle that left the lattice; `index`: of the theta that its neighbours will read.
void emptyCell(int cell, int index) {
    cellTheta[index] = kEmpty;
    cellWeight[cell] = 0u;
    tiles[cell / TILE_CELLS].lastActive = heatBlock.stepNumber;
}

/// Writes the phase of a lattice particle at its enthalpy. If melt leaves the lattice, so does a particle that melts.
void writePhase(uint slot, int cell, int index, float enthalpy) {
    uint before = texelFetch(phaseTexels, int(slot)).x;
    uint after = nextPhase(before, enthalpy);
    if (after == before) return;
    bool leaves = (after & PHASE_LIQUID) != 0u && heatBlock.meltLeavesLattice != 0;
    phase[slot] = leaves ? after & ~PHASE_LATTICE : after;
    noteChange(slot, after);
    if (!leaves) return;
    latticeSlot[cell] = 0u;
    emptyCell(cell, index);
    listOffLattice(slot);
}
