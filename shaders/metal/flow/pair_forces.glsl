// Forces of one neighbour on a liquid particle, one effect a function. Included after common.glsl.

/// A liquid particle and one of its neighbours.
struct Pair {
    vec3 d;            // vector from the neighbour to the particle, m
    float distance2;   // m²
    float q;           // distance over the support, at most 1
    float q2;
    float slope;       // s V W'(r)/r: the kernel's gradient is slope * d, 1/m²
    vec3 relative;     // velocity of the particle relative to the neighbour, m/s
    float approach;    // relative velocity times d, m²/s; negative during approach
    bool solid;        // the neighbour is wall metal or part of a fragment
    float temperature; // temperature of the neighbour, K
    float weight;      // weight of the two surface forces: density correction and wetting
};

/// Pressure over density squared (m²/s², for a rest density of 1) by the equation of state p = c² (density - 1), which
/// only pushes: weakly compressible SPH (Monaghan 1994) with a linear law; the absence of pull is our own choice.
float pressureTerm(float density) {
    return fluid.soundSpeedSquared * max(density - 1, 0) / (density * density);
}

/// Symmetric pressure sum p/rho² of both, m²/s² (Monaghan 1992).
float pressureOf(float ownTerm, float otherDensity) { return ownTerm + pressureTerm(otherDensity); }

/// Friction against solid metal over that in the liquid. Own calibration on the flow between plates, see
/// flow_constants.cpp.
float frictionFactor(Pair pair) { return pair.solid ? fluid.wallFriction : 1.0; }

/// Viscosity along the line between both (Monaghan and Gingold 1983, with the factor 2 (d + 2) = 10 of Monaghan 2005), m²/s².
float viscosityOf(Pair pair) {
    const float soft = 1e-4 * fluid.support * fluid.support;
    return frictionFactor(pair) * fluid.pairFriction * pair.approach / (pair.distance2 + soft);
}

/// The cohesion spline of Akinci, Akinci and Teschner 2013 over q, without its prefactor; the constant term, h⁶/64 in the
/// paper, belongs inside the prefactor, as the spline jumps at half the support otherwise.
float cohesionSpline(float q) {
    const float a = (1 - q) * (1 - q) * (1 - q) * q * q * q;
    return q > 0.5 ? a : 2 * a - 1.0 / 64;
}

/// Cohesion over distance, 1/s² (Akinci et al. 2013).
float cohesionOf(Pair pair) {
    return pair.weight * fluid.cohesion * cohesionSpline(pair.q) / max(pair.q * fluid.support, 0.02 * fluid.support);
}

/// Surface area force over distance, 1/s² (Akinci et al. 2013): both surface normals become equal. Only its part along the
/// line between both acts, so that it turns no drop; the weight 4 q² (1 - q²) over the distance, whose q² cancels, is our
/// own: with a constant weight the force is noisy.
float areaForceOf(Pair pair, vec3 ownNormal, vec3 otherNormal) {
    const float inverse = fluid.inverseSupport * fluid.inverseSupport;
    return pair.weight * fluid.areaForce * 4 * inverse * (1 - pair.q2) * dot(ownNormal - otherNormal, pair.d);
}

/// Weight of the two surface forces: density correction 2/(rho_i + rho_j) of Akinci et al. 2013, times the attraction
/// of the liquid by solid metal of its temperature (own derivation, see wettingAt()).
float surfaceWeight(bool solid, float temperature, float ownDensity, float otherDensity) {
    return (solid ? wettingAt(temperature) : 1.0) * 2 / (ownDensity + otherDensity);
}

#ifdef MARANGONI
/// Sums for the gradient of temperature.
struct Warming {
    vec3 sum;    // sum of temperature differences
    float trace; // this sum for a gradient of 1 along each axis, times 3
};

void addWarming(inout Warming warming, Pair pair, float ownTemperature) {
    warming.sum += pair.slope * (pair.temperature - ownTemperature) * pair.d;
    warming.trace -= pair.slope * pair.distance2;
}

/// Least share of surface, times half a spacing, that counts as surface: inside the liquid the sum is never quite 0.
const float kSurfaceShare = 0.1;

/// Slope of surface tension over temperature, over density, m³/(s² K).
float tensionSlope(float temperature) {
    const float place = clamp((temperature - fluid.firstSlopeAt) * fluid.inverseSlopeStep, 0, FLOW_TENSION_SLOPES - 1.001);
    const int left = int(place);
    const int right = left + 1;
    return mix(fluid.tensionSlopes[left >> 2][left & 3], fluid.tensionSlopes[right >> 2][right & 3], place - float(left));
}

/// Pull of the surface towards higher tension, m/s²: (dgamma/dT) times the surface gradient of temperature, on each
/// area of surface (continuum surface force, Brackbill, Kothe and Zemach 1992). `inward`: normal with the surface per
/// volume as its length, 1/m. The normalised temperature gradient is our own.
vec3 marangoniForce(Warming warming, vec3 inward, float temperature) {
    const vec3 gradient = warming.sum * 3 / max(warming.trace, 1e-3);
    const float share = length(inward);
    const vec3 across = inward / max(share, 1e-6);
    if (share * fluid.halfSpacing <= kSurfaceShare) return vec3(0);
    return tensionSlope(temperature) * share * (gradient - across * dot(gradient, across));
}
#endif

/// Solid metal around a particle.
struct SolidAround {
    vec3 gradient; // gradient of the density of solid metal alone, 1/m
    float density; // density of solid metal over rest density
    float rising;  // rate of rise of that density by the particles' present motion, 1/s
};

void addSolid(inout SolidAround solids, Pair pair) {
    const float slope = pair.solid ? pair.slope : 0.0;
    solids.gradient += slope * pair.d;
    solids.density += slope * (1 - pair.q2);
    solids.rising += slope * pair.approach;
}
