// Appends to the metal's list of phase changes, see shared/metal.h. Included after state.glsl, with PHASE_CHANGES_BINDING defined.
layout(std430, binding = PHASE_CHANGES_BINDING) restrict buffer Changes { uint changes[]; };

/// Lists a slot. A number beyond the capacity means that some were dropped.
void listPhaseChange(uint slot) {
    uint entry = atomicAdd(changes[0], 1u);
    if (entry < uint(metal.capacity)) changes[entry + 1u] = slot;
}
