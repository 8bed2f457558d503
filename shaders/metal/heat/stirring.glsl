// Directed mixing: liquid that conducts more along some axes than along others, because the stirring has a direction.
// Included after neighbours.glsl.
//
// The Kirchhoff variable of an axis follows theta in full up to the liquidus and by the axis's share beyond it. A
// function of theta for each axis preserves conservation: the two sides of a face find equal flow, and nothing flows
// between metal of one temperature. Below the liquidus, and without a direction, theta is unchanged, to the bit.

#ifdef DIRECTED_MIXING
vec3 anisotropicTheta(vec3 theta, vec3 less) { return theta - less * max(theta - heatBlock.liquidTheta, 0.0); }
vec3 anisotropicAlongAxes(vec3 theta) { return anisotropicTheta(theta, heatBlock.stirringLess); }
/// Theta reduced by the smaller share of both axes of the planes xy, yz and xz: the square may not conduct more than
/// its sides do.
vec3 ledInPlanes(vec3 theta) {
    return anisotropicTheta(theta, max(heatBlock.stirringLess.xyx, heatBlock.stirringLess.yzz));
}

vec3 ledWhetherHeld(vec3 theta) {
    return mix(anisotropicAlongAxes(theta), -2.0 - anisotropicAlongAxes(-2.0 - theta), lessThan(theta, vec3(-1.5)));
}

/// The neighbours with the reduced theta.
Neighbours ledNeighbours(Neighbours n) {
    n.low = ledWhetherHeld(n.low);
    n.high = ledWhetherHeld(n.high);
    return n;
}
#else
vec3 anisotropicAlongAxes(vec3 theta) { return theta; }
vec3 ledInPlanes(vec3 theta) { return theta; }
Neighbours ledNeighbours(Neighbours n) { return n; }
#endif
