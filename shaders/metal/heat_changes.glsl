// Notes slots whose phase bits change, for those who follow. Included after heat_common.glsl.
layout(std430, binding = HEAT_CHANGES) restrict buffer Changes { uint changes[]; };

void noteChange(uint slot) {
    uint place = atomicAdd(changes[0], 1u);
    if (place < uint(metal.tiles.w)) changes[place + 1u] = slot;
}
