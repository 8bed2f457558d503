#version 450 core
// Finds the beginning of metal along the axis: the point where the count reaches half of that inside metal, linear
// between the bins' middles; if it reaches it nowhere, as over a gap between plates, the edges beside the axis, if they
// are deep. Empties the bins for the next search.
#extension GL_GOOGLE_include_directive : require
#include "shared/axis_probe.h"
layout(local_size_x = AXIS_PROBE_BINS) in;
layout(std140, binding = AXIS_PROBE_BLOCK) uniform Probe { AxisProbeBlock probe; };
layout(std430, binding = AXIS_PROBE_SUMS) restrict buffer Sums { AxisProbeBin bins[]; };
layout(std430, binding = AXIS_PROBE_ANSWER) restrict writeonly buffer Answer { AxisProbeAnswer answer; };

shared AxisProbeBin counted[AXIS_PROBE_BINS];
shared int first, firstEdge;

float shareOf(int bin) { return bin < 0 ? 0.0 : float(counted[bin].weight) / (AXIS_PROBE_UNIT * probe.full); }

/// Share of metal over AXIS_PROBE_EDGE_DEPTH spacings from a bin on.
float meanShareFrom(int bin) {
    float sum = 0.0;
    for (int i = bin; i < min(bin + probe.edgeBins, AXIS_PROBE_BINS); ++i)
        sum += shareOf(i);
    return sum / float(probe.edgeBins);
}

/// True if the side of something deep beside the axis begins in this bin: a drop or a lone particle is not deep.
bool isEdge(int bin) {
    float inside = meanShareFrom(bin);
    return inside >= AXIS_PROBE_EDGE_SHARE && shareOf(bin) >= 0.5 * inside;
}

/// Share of liquid over the spacing behind the surface.
float liquidFrom(int bin, int count) {
    int weight = 0, liquid = 0;
    for (int i = bin; i < min(bin + count, AXIS_PROBE_BINS); ++i) {
        weight += counted[i].weight >> 4; // so that the sums fit
        liquid += counted[i].liquid >> 4;
    }
    return weight > 0 ? float(liquid) / float(weight) : 0.0;
}

void main() {
    int bin = int(gl_LocalInvocationIndex);
    if (bin == 0) first = firstEdge = AXIS_PROBE_BINS;
    counted[bin] = bins[bin];
    bins[bin] = AxisProbeBin(0, 0);
    barrier();
    if (shareOf(bin) >= 0.5) atomicMin(first, bin);
    barrier();
    if (first == AXIS_PROBE_BINS && isEdge(bin)) atomicMin(firstEdge, bin);
    barrier();
    if (bin != 0) return;
    answer.reserved[0] = answer.reserved[1] = 0.0;
    if (firstEdge < AXIS_PROBE_BINS) {
        answer.distance = float(firstEdge) * probe.binLength;
        answer.liquid = liquidFrom(firstEdge, 8);
        return;
    }
    if (first == AXIS_PROBE_BINS) {
        answer.distance = -1.0;
        answer.liquid = 0.0;
        return;
    }
    float before = shareOf(first - 1);
    float part = (0.5 - before) / max(shareOf(first) - before, 1e-6);
    answer.distance = first == 0 ? 0.0 : (float(first) - 0.5 + part) * probe.binLength;
    answer.liquid = liquidFrom(first, 8);
}
