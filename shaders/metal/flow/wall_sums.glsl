// Contributions of wall metal to the sums of other wall metal. Included after common.glsl.

/// Share of a neighbour at `d` (m) in the gradient sum (xyz, over the support) and the density sum (w), before their
/// prefactors, in 1/FLOW_WALL_SUM_UNIT.
ivec4 wallShare(vec3 d) {
    const float inverse = fluid.inverseSupport;
    const float u = max(1 - dot(d, d) * inverse * inverse, 0);
    return ivec4(round(u * u * u * vec4(d * inverse, u) * FLOW_WALL_SUM_UNIT));
}
