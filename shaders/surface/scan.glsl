// Running sums over a work group of SURFACE_SCAN_GROUP invocations.
#ifndef MELTPOOL_SURFACE_SCAN_GLSL
#define MELTPOOL_SURFACE_SCAN_GLSL

shared uvec2 scanned[SURFACE_SCAN_GROUP];

/// Sum of the values of the invocations before this one (Hillis and Steele 1986); every invocation of the group must
/// call it. `total`: the sum over the group.
uvec2 sumBefore(uvec2 value, out uvec2 total) {
    uint self = gl_LocalInvocationIndex;
    scanned[self] = value;
    barrier();
    for (uint step_ = 1u; step_ < SURFACE_SCAN_GROUP; step_ *= 2u) {
        uvec2 before = self >= step_ ? scanned[self - step_] : uvec2(0u);
        barrier();
        scanned[self] += before;
        barrier();
    }
    total = scanned[SURFACE_SCAN_GROUP - 1];
    return scanned[self] - value;
}

#endif
