// Liquid that conducts more along some axes than along others, as what stirs it has a way. Included after neighbours.glsl.
//
// Heat that leads along an axis follows theta up to the liquidus wholly and beyond it by the axis's share. A function of theta
// for each axis keeps what conduction keeps: the two sides of a face find the same flow, and nothing flows between metal of one
// temperature. Below the liquidus, and where nothing has a way, theta stays as it is, to the bit.

#ifdef LED_STIRRING
vec3 ledTheta(vec3 theta, vec3 less) { return theta - less * max(theta - heatBlock.liquidTheta, 0.0); }
vec3 ledAlongAxes(vec3 theta) { return ledTheta(theta, heatBlock.stirringLess); }
/// By the smaller share of both axes of the planes xy, yz and xz: the square may not lead more than its sides do.
vec3 ledInPlanes(vec3 theta) {
    return ledTheta(theta, max(heatBlock.stirringLess.xyx, heatBlock.stirringLess.yzz));
}

vec3 ledWhetherHeld(vec3 theta) {
    return mix(ledAlongAxes(theta), -2.0 - ledAlongAxes(-2.0 - theta), lessThan(theta, vec3(-1.5)));
}

/// The neighbours as a cell conducts with them.
Neighbours ledNeighbours(Neighbours n) {
    n.low = ledWhetherHeld(n.low);
    n.high = ledWhetherHeld(n.high);
    return n;
}
#else
vec3 ledAlongAxes(vec3 theta) { return theta; }
vec3 ledInPlanes(vec3 theta) { return theta; }
Neighbours ledNeighbours(Neighbours n) { return n; }
#endif
