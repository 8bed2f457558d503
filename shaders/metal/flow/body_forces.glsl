// Body forces and stops on a liquid particle, besides its neighbours. Included after common.glsl and pair_forces.glsl.

/// Drag of a jet along the surface that it strikes, `x` sigmas of its pressure from the axis, over the peak, which is
/// at 2.1 sigmas. Beltaos and Rajaratnam 1974, a round jet that strikes a plate from the height h: the pressure is
/// exp(-114 (r/h)²), the drag 0.18 (1 - exp(-114 (r/h)²)) / (r/h) - 9.43 (r/h) exp(-114 (r/h)²); h = 15.1 sigma.
float jetDrag(float x) {
    const float pressure = exp(-0.5 * x * x);
    return 2.718 * (1 - pressure) / x - 0.6245 * x * pressure;
}

/// Push and drag of the arc on the metal that faces it, m/s²: on each area of surface a Gaussian pressure along the axis (own
/// derivation; its peak: arcPressurePeak()) and the drag of its plasma jet along the surface, away from the axis. `inward`:
/// surface normal with the surface per volume as its length, 1/m.
vec3 arcForce(vec3 place, vec3 inward) {
    const vec3 off = place - fluid.arcCentre;
    const vec3 across = off - dot(off, fluid.arcAxis) * fluid.arcAxis;
    const float fromAxis2 = dot(across, across);
    const float facing = dot(inward, fluid.arcAxis);
    if (facing <= 0) return vec3(0);
    const vec3 push = fluid.arcPeak * exp(-fromAxis2 * fluid.arcInverseVariance) * facing * fluid.arcAxis;
    const float fromAxis = sqrt(fromAxis2);
    if (fluid.arcShear == 0 || fromAxis < 1e-6) return push;
    const vec3 along = across - dot(across, inward) / dot(inward, inward) * inward;
    return push + fluid.arcShear * jetDrag(fromAxis * fluid.inverseArcSigma) * facing / fromAxis * along;
}

/// Loss of weight of hot metal, m/s² (Boussinesq 1903).
vec3 weightCorrection(float temperature) {
    return fluid.expansion * (temperature - fluid.referenceTemperature) * metal.gravity;
}

/// Share of the velocity that mushy metal retains over a substep: Carman-Kozeny drag (Voller and Prakash 1987),
/// implicit. Flying metal has no fixed crystals around it, and retains all of it.
float mushyShare(float enthalpy, uint tether) {
    if (tether == 0) return 1;
    // Pure metal melts at one temperature: its two enthalpies differ by the latent heat alone.
    const float f = clamp((enthalpy - metal.solidusEnthalpy) / max(metal.liquidusEnthalpy - metal.solidusEnthalpy, 1), 0, 1);
    return 1 / (1 + fluid.timeStep * fluid.mushyDrag * (1 - f) * (1 - f) / (f * f * f + 1e-3));
}

/// Density of solid metal beyond which liquid goes no further into it: 0.63 spacings before its outermost particles. At
/// rest it stays farther off. The soft pressure alone does not stop a single drop: inside wall metal it is as low as
/// inside the pool.
const float kSolidDensity = 0.5;

/// Removes the part of a velocity that would carry the particle beyond kSolidDensity in this substep; `change`: the
/// velocity less that at the substep's start. A particle that is beyond already goes no deeper. Own derivation.
vec3 stopAtSolid(SolidAround solids, vec3 change, vec3 velocity) {
    const vec3 gradient = solids.gradient;
    const float steepness2 = max(dot(gradient, gradient), 1e-4 * fluid.inverseSupport * fluid.inverseSupport);
    const float most = max(kSolidDensity - solids.density, 0) / fluid.timeStep;
    return velocity - max(solids.rising + dot(change, gradient) - most, 0) / steepness2 * gradient;
}

/// True where solid metal sits on the lattice.
bool latticeFilled(vec3 place) {
    const ivec3 cell = latticeCell(place);
    return inLattice(cell) && latticeSlot[latticeIndex(cell)] != 0;
}

/// Smallest distance of a particle from the face of a solid lattice cell, in spacings; at rest it is about 0.4.
const float kWallGap = 0.35;

/// Stops a particle at the faces of solid lattice cells, for the reason given at stopAtSolid(). Own derivation.
vec3 stopAtLattice(vec3 before, vec3 after, inout vec3 velocity) {
    if (latticeFilled(before)) return after; // metal froze around it: let it out
    vec3 place = before;
    for (int axis = 1; axis < 4; ++axis) { // y first: most walls are floors
        vec3 step = place;
        step[axis % 3] = after[axis % 3];
        vec3 probe = step;
        probe[axis % 3] += kWallGap * metal.spacing * sign(after[axis % 3] - before[axis % 3]);
        if (latticeFilled(probe))
            velocity[axis % 3] = 0;
        else
            place = step;
    }
    return place;
}

/// Confines a place to space: around the seam where it repeats, else half a spacing off its end, where the particle
/// stops.
vec3 confine(vec3 place, inout vec3 velocity) {
    const bvec3 repeats = greaterThan(fluid.period, vec3(0));
    const vec3 around = place - fluid.period * floor((place - fluid.origin) * fluid.inversePeriod);
    const vec3 inside = clamp(place, fluid.origin + fluid.halfSpacing, fluid.high - fluid.halfSpacing);
    const vec3 confined = mix(inside, around, repeats);
    if (any(notEqual(mix(inside, place, repeats), place))) velocity = vec3(0);
    return confined;
}
