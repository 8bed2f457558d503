#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the particles that are not as they were last entered into the volumes. Their order does not matter: sums of
// integers come out the same in any.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/particles.glsl"

layout(binding = SURFACE_TEXELS_SPLATTED) uniform samplerBuffer splatted;
layout(std430, binding = SURFACE_BIND_CHANGED_LIST) writeonly buffer ChangedList { uint changedList[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

void main() {
    uint index = linearInvocation();
    if (index >= setup.limits.x) return;
    vec4 now = particleNow(index), before = texelFetch(splatted, int(index));
    vec3 cells = abs((now.xyz - before.xyz) * (vec3(setup.cells.xyz) / setup.extent.xyz));
    // Written so that a temperature that is no number counts as a change.
    bool still = all(lessThanEqual(cells, vec3(setup.still.x))) && abs(now.w - before.w) <= setup.still.y * setup.extent.w;
    if (still) return;
    uint slot = atomicAdd(commands.changedCount, 1u);
    changedList[slot] = index;
    if (slot % SURFACE_GROUP == 0u) atomicAdd(commands.changed.x, 1u);
}
