#version 450 core
// Counts the metal along an axis in bins: the first groups take the lattice cells in a box around the ray, the others
// the slots off the lattice. A particle is a cube of metal: it covers one spacing along the axis, and its weight falls
// with its distance from the axis.
#extension GL_GOOGLE_include_directive : require
#include "shared/axis_probe.h"
layout(local_size_x = AXIS_PROBE_GROUP) in;
#include "metal/state.glsl"
layout(std140, binding = AXIS_PROBE_BLOCK) uniform Probe { AxisProbeBlock probe; };
layout(std430, binding = AXIS_PROBE_SUMS) restrict buffer Sums { AxisProbeBin bins[]; };
layout(std430, binding = AXIS_PROBE_SLOTS) restrict readonly buffer Slots { uint slots[]; };
layout(std430, binding = AXIS_PROBE_CONTROL) restrict readonly buffer Control { uint control[]; };

/// Share of liquid at an enthalpy (J/kg).
float fractionOfLiquid(float enthalpy) {
    float range = metal.liquidusEnthalpy - metal.solidusEnthalpy;
    return range > 0.0 ? clamp((enthalpy - metal.solidusEnthalpy) / range, 0.0, 1.0)
                       : float(enthalpy >= metal.liquidusEnthalpy);
}

void countAt(uint slot, vec3 place) {
    vec3 d = place - probe.origin;
    float along = dot(d, probe.axis);
    float off = max(dot(d, d) - along * along, 0.0);
    float radius = AXIS_PROBE_RADIUS * metal.spacing;
    float share = 1.0 - off / (radius * radius);
    float begin = (along - 0.5 * metal.spacing) / probe.binLength;
    float end = (along + 0.5 * metal.spacing) / probe.binLength;
    if (share <= 0.0 || end <= 0.0 || begin >= float(AXIS_PROBE_BINS)) return;
    float weight = share * share * AXIS_PROBE_UNIT;
    float liquid = fractionOfLiquid(heat[slot].x);
    int last = min(int(floor(end)), AXIS_PROBE_BINS - 1);
    for (int bin = max(int(floor(begin)), 0); bin <= last; ++bin) {
        float covered = min(end, float(bin + 1)) - max(begin, float(bin));
        int sum = int(weight * covered);
        atomicAdd(bins[bin].weight, sum);
        atomicAdd(bins[bin].liquid, int(float(sum) * liquid));
    }
}

void countLattice() {
    int count = probe.cells.x * probe.cells.y * probe.cells.z;
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += probe.latticeGroups * AXIS_PROBE_GROUP) {
        ivec3 cell = probe.low + ivec3(i % probe.cells.x, i / probe.cells.x % probe.cells.y,
                                       i / (probe.cells.x * probe.cells.y));
        vec3 place = cellCentre(cell);
        vec3 d = place - probe.origin;
        float along = dot(d, probe.axis);
        float radius = AXIS_PROBE_RADIUS * metal.spacing;
        if (dot(d, d) - along * along >= radius * radius) continue;
        uint entry = latticeSlot[latticeIndex(cell)];
        if (entry != 0u) countAt(entry - 1u, place);
    }
}

void main() {
    if (gl_WorkGroupID.x < uint(probe.latticeGroups)) {
        countLattice();
        return;
    }
    uint stride = (gl_NumWorkGroups.x - uint(probe.latticeGroups)) * AXIS_PROBE_GROUP;
    uint first = gl_GlobalInvocationID.x - uint(probe.latticeGroups) * AXIS_PROBE_GROUP;
    for (uint i = first; i < control[probe.countWord]; i += stride) {
        uint slot = slots[probe.firstSlot + i];
        uint bits = phase[slot];
        bool flies = (bits & PHASE_LIQUID) != 0u && dot(velocity[slot].xyz, probe.axis) > AXIS_PROBE_DROP_SPEED;
        if ((bits & PHASE_ALIVE) != 0u && !flies) countAt(slot, position[slot].xyz);
    }
}
