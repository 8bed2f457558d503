#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the particles that moved, changed temperature or (SURFACE_FREEZING) froze or melted since they were last
// splatted. The order of the list does not matter: the volumes are sums of integers.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/particles.glsl"

layout(binding = SURFACE_TEXELS_SPLATTED) uniform samplerBuffer splatted;
layout(std430, binding = SURFACE_BIND_CHANGED_LIST) writeonly buffer ChangedList { uint changedList[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

#ifdef SURFACE_FREEZING
layout(binding = SURFACE_TEXELS_FREEZING) uniform samplerBuffer splattedFreezing; // last splatted times, not the volume

bool sameFreezing(uint index, uint record) {
    return frozenNow(index) == texelFetch(splattedFreezing, int(record)).x;
}
#else
bool sameFreezing(uint index, uint record) {
    return true;
}
#endif

void main() {
    uint index = linearInvocation();
    if (index >= setup.particleCount) return;
    uint record = recordOf(index);
    Particle now = particleNow(index), before = fetchParticle(splatted, record);
    vec3 cells = abs((now.position - before.position) * (vec3(setup.cells) / setup.extent));
    // A temperature that is not a number counts as a change in this form of the test.
    bool unchanged = all(lessThanEqual(cells, vec3(setup.positionTolerance))) &&
                     abs(now.temperature - before.temperature) <= setup.temperatureTolerance * setup.temperatureRange;
    if (unchanged && sameFreezing(index, record)) return;
    uint slot = atomicAdd(commands.changedCount, 1u);
    changedList[slot] = index;
    if (slot % SURFACE_GROUP == 0u) atomicAdd(commands.changed.x, 1u);
}
