// The stencil of 19 points: conduction of a cell with the 6 cells across its faces and the 12 across its edges.
// Included after common.glsl.
//
// With theta, the integral of k over temperature, conduction is rho dh/dt = lap theta. The cells across faces (theta_f)
// and the cell itself (theta_c) give sum (theta_f - theta_c) = dx² lap theta + dx⁴/12 (theta_xxxx + theta_yyyy +
// theta_zzzz) + O(dx⁶): heat spreads differently along the axes and between them. A cell makes a square with three
// others in each of the planes xy, yz and xz on either side. Its twist is theta_c and theta_e, across the edge, less
// the other two; those of a plane add up to dx⁴ theta_xxyy:
//   sum (theta_f - theta_c) + 1/6 sum of twists = 1/3 sum theta_f + 1/6 sum theta_e - 4 theta_c = dx² lap theta + dx⁴/12 lap² theta,
// to O(dx⁶): an error equal in all directions. An explicit step dt lacks (alpha dt)²/2 lap² theta, alpha the
// diffusivity; at dt = dx²/(6 alpha) that error supplies it, and the step is exact to the fourth order of dx. A square
// gives and takes 1/6 of its twist with alternating signs, so energy is conserved. A square with a missing cell does
// not count, and theta that changes along one axis has no twist: plane surfaces conduct heat correctly along
// themselves.

/// From the cells across faces, W/m. An empty cell gives nothing; a held one is a wall at the face, half as far away.
vec3 faceFlow(vec3 neighbour, vec3 theta, bvec3 wall) {
    return mix(neighbour - theta, 2.0 * (-2.0 - neighbour - theta), wall) * (1.0 - vec3(equal(neighbour, vec3(kEmpty))));
}
vec4 faceFlow(vec4 neighbour, vec4 theta, bvec4 wall) {
    return mix(neighbour - theta, 2.0 * (-2.0 - neighbour - theta), wall) * (1.0 - vec4(equal(neighbour, vec4(kEmpty))));
}

/// Twists of squares, W/m: `first` and `second` are across faces. The order of the differences counts, so that both
/// sides of a tile's edge find equal bits.
vec3 twistOf(vec3 theta, vec3 first, vec3 second, vec3 opposite) { return (theta - second) - (first - opposite); }
vec4 twistOf(vec4 theta, vec4 first, vec4 second, vec4 opposite) { return (theta - second) - (first - opposite); }
