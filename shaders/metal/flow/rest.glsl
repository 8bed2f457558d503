// What still metal adds to the sums of other still metal. Included after flow_common.glsl.

/// Share of a neighbour `d` (m) away in the gradient (xyz, over the support) and density sums, before their prefactors.
ivec4 restShare(vec3 d) {
    const float inverse = fluid.inverseCell.w;
    const float u = max(1 - dot(d, d) * inverse * inverse, 0);
    return ivec4(round(u * u * u * vec4(d * inverse, u) * FLOW_REST_UNIT));
}
