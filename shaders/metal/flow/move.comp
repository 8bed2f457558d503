#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 2: pressure, viscosity and surface tension on the liquid; then it moves on and enters the next substep's cells.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

/// Pressure over density squared, m²/s² in units of the rest density.
float stiffness(float density) {
    return fluid.kernel.y * max(density - 1, 0) / (density * density);
}

/// Akinci's cohesion spline over q, with h^6/64 inside the prefactor.
float cohesion(float q) {
    const float a = (1 - q) * (1 - q) * (1 - q) * q * q * q;
    return q > 0.5 ? a : 2 * a - 1.0 / 64;
}

/// Least share of surface, times half a spacing, of what counts as surface: inside the liquid the sum is never quite 0.
const float kSurfaceShare = 0.1;

/// What solid metal is around a particle.
struct SolidAround {
    vec4 density; // xyz gradient (1/m) and w value of the density of solid metal alone, over rest density
    float rising; // how fast that value rises by the particles' present motion, 1/s
};

/// Density of solid metal beyond which liquid goes no further into it: 0.63 spacings before its outermost particles. At rest
/// it keeps farther off. The soft pressure alone does not hold a single drop: for it the inside of still metal is as good a
/// place as the inside of the pool.
const float kSolidDensity = 0.5;

/// Takes from a velocity, `change` away from that of the substep's start, what would carry the particle beyond that in this substep; what is beyond already goes no deeper.
vec3 stopAtSolid(SolidAround solids, vec3 change, vec3 velocity) {
    const vec3 gradient = solids.density.xyz;
    const float steepness2 = max(dot(gradient, gradient), 1e-4 * fluid.inverseCell.w * fluid.inverseCell.w);
    const float most = max(kSolidDensity - solids.density.w, 0) / fluid.period.w;
    return velocity - max(solids.rising + dot(change, gradient) - most, 0) / steepness2 * gradient;
}

/// Acceleration by all neighbours and by the arc's pressure, and the fastest that one of them goes against this particle (m/s),
/// of those that are not much faster: a single fast particle is restless, not all those around it.
vec3 acceleration(uint index, uint slot, out float fastest, out SolidAround solids) {
    const FlowBody own = bodies[slot];
    const uint found = own.where.w;
    const uint base = neighbourBase(index);
    const float inverse = fluid.inverseCell.w * fluid.inverseCell.w;
    const float soft = 1e-4 * fluid.origin.w * fluid.origin.w;
    const float pressure = stiffness(own.place.w);
    vec3 sum = vec3(0);
    solids = SolidAround(vec4(0), 0);
    float fastest2 = 0;
    const float slower = 2 * dot(own.motion.xyz, own.motion.xyz);
#ifdef MARANGONI
    vec3 warming = vec3(0); // sum for the temperature's gradient
    float reached = 0;      // the same sum for a gradient of 1 along each axis
#endif
    for (uint k = 0; k < found; ++k) {
        const uint entry = neighbourTexel(base, k);
        const int other = int(entry & FLOW_SLOT) * FLOW_BODY_TEXELS;
        const vec4 place = texelFetch(bodyTexels, other);
        const vec3 d = apart(own.place.xyz, place.xyz);
        const float r2 = dot(d, d);
        const float q2 = min(r2 * inverse, 1);
        const float q = sqrt(q2);
        const float u = 1 - q2;
        const float slope = -8 * fluid.kernel.x * inverse * u * u * u;
        const bool solid = (entry & FLOW_SOLID) != 0;
        const vec3 theirs = texelFetch(bodyTexels, other + 2).xyz;
        const vec3 against = own.motion.xyz - theirs;
        if (dot(theirs, theirs) < slower) fastest2 = max(fastest2, dot(against, against));
        const float approach = dot(against, d);
        const float friction = (solid ? fluid.tension.w : 1.0) * fluid.kernel.z * approach / (r2 + soft);
        const vec4 normal = texelFetch(bodyTexels, other + 1);
        const float solidSlope = solid ? slope : 0.0;
        solids.density += solidSlope * vec4(d, u);
        solids.rising += solidSlope * approach;
        const float weight = (solid ? wettingAt(normal.w) : 1.0) * 2 / (own.place.w + place.w);
        const float pull = weight * fluid.tension.x * cohesion(q) / max(q * fluid.origin.w, 0.02 * fluid.origin.w);
        sum += (slope * (friction - (pressure + stiffness(place.w))) - pull) * d;
        sum -= weight * fluid.tension.y * 4 * q2 * u * (own.normal.xyz - normal.xyz);
#ifdef MARANGONI
        warming += slope * (normal.w - own.normal.w) * d;
        reached -= slope * r2;
#endif
    }
    solids.density.w /= -8 * inverse;
    // Its length is the particle's share of surface, 1/m; half of the gradient lies outside, where no particle feels it.
    const vec3 inward = 2 * own.normal.xyz / fluid.search.z;
#ifdef MARANGONI
    // Tangential force of (dgamma/dT) grad T on each area of surface.
    const vec3 gradient = warming * 3 / max(reached, 1e-3);
    const float share = length(inward);
    const vec3 across = inward / max(share, 1e-6);
    if (share * fluid.high.w > kSurfaceShare)
        sum += fluid.tension.z * share * (gradient - across * dot(gradient, across));
#endif
    const vec3 off = own.place.xyz - fluid.arc.xyz;
    const float beside = max(dot(off, off) - dot(off, fluid.arcAxis.xyz) * dot(off, fluid.arcAxis.xyz), 0);
    const float facing = dot(inward, fluid.arcAxis.xyz);
    if (facing > 0) sum += fluid.arcAxis.w * exp(-beside * fluid.arc.w) * facing * fluid.arcAxis.xyz;
    // A drop of a few particles in flight meets others that are no neighbours yet, and nothing carries it: it has its whole
    // weight. Elsewhere hot metal is lighter (Boussinesq).
    const bool flying = found < 20;
    fastest = flying ? max(sqrt(fastest2), 0.4 * length(own.motion.xyz)) : sqrt(fastest2);
    if (!flying) sum -= fluid.buoyancy.x * (own.normal.w - fluid.buoyancy.y) * metal.gravity;
    return sum;
}

/// Share of the velocity that mushy metal keeps over a substep: implicit Carman-Kozeny drag.
float mushyShare(float enthalpy) {
    // Pure metal melts at one enthalpy step, whose ends are apart by the latent heat alone.
    const float f = clamp((enthalpy - metal.solidusEnthalpy) / max(metal.liquidusEnthalpy - metal.solidusEnthalpy, 1), 0, 1);
    return 1 / (1 + fluid.period.w * fluid.kernel.w * (1 - f) * (1 - f) / (f * f * f + 1e-3));
}

/// Keeps a place inside the space: around the seam where it repeats, else half a spacing off its end, where it sticks.
vec3 confine(vec3 place, inout vec3 velocity) {
    const bvec3 repeats = greaterThan(fluid.period.xyz, vec3(0));
    const vec3 around = place - fluid.period.xyz * floor((place - fluid.origin.xyz) * fluid.inversePeriod.xyz);
    const vec3 inside = clamp(place, fluid.origin.xyz + fluid.high.w, fluid.high.xyz - fluid.high.w);
    const vec3 confined = mix(inside, around, repeats);
    if (any(notEqual(mix(inside, place, repeats), place))) velocity = vec3(0);
    return confined;
}

layout(std430, binding = METAL_LATTICE) readonly buffer LatticeSlots { uint latticeSlots[]; };

/// True where solid metal sits on the lattice.
bool latticeFilled(vec3 place) {
    const ivec3 cell = ivec3(floor((place - metal.origin) / metal.spacing));
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, metal.tiles * TILE_EDGE))) return false;
    const ivec3 tile = cell / TILE_EDGE;
    const ivec3 inside = cell - tile * TILE_EDGE;
    const int index = ((tile.z * metal.tiles.y + tile.y) * metal.tiles.x + tile.x) * TILE_CELLS;
    return latticeSlots[index + (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x] != 0;
}

/// Nearest that a particle may come to the face of a solid cell, in spacings; at rest it keeps about 0.4.
const float kWallGap = 0.35;

/// Stops a particle at the faces of solid cells. The soft pressure alone does not hold a single drop: for it the inside of
/// still metal is as good a place as the inside of the pool.
vec3 stopAtLattice(vec3 before, vec3 after, inout vec3 velocity) {
    if (latticeFilled(before)) return after; // metal froze around it: let it out
    vec3 place = before;
    for (int axis = 1; axis < 4; ++axis) {   // y first: most walls are floors
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

/// Share of its free way from which a particle searches along with others.
const float kRestlessShare = 0.8;

/// Moves one slot on.
void moveOn(uint index) {
    const uint slot = lists[index];
    const uint next = 1u - (substep & 1u);
    const vec4 before = position[slot];
    if ((phase[slot] & PHASE_LIQUID) == 0) {
        enterCell(slot, before.xyz, next);
        return;
    }
    const float dt = fluid.period.w;
    float fastest;
    SolidAround solids;
    const vec3 pairs = acceleration(index, slot, fastest, solids);
    vec3 newVelocity = velocity[slot].xyz + dt * (pairs + (metal.gravity + fluid.body.xyz));
    newVelocity *= mushyShare(heat[slot].x);
    newVelocity = stopAtSolid(solids, newVelocity - velocity[slot].xyz, newVelocity);
    float speed = length(newVelocity);
    if (!(speed < 1e6)) { // also catches what is not a number
        atomicAdd(counters.faults.z, 1u);
        newVelocity = vec3(0);
        speed = 0;
    } else if (speed > fluid.inversePeriod.w) {
        newVelocity *= fluid.inversePeriod.w / speed;
        speed = fluid.inversePeriod.w;
    }
    const vec3 free = stopAtLattice(before.xyz, before.xyz + dt * newVelocity, newVelocity);
    const vec3 after = confine(free, newVelocity);
    const float way = velocity[slot].w + dt * fastest; // that neighbours may have come or gone since they were listed
    position[slot] = vec4(after, before.w);
    velocity[slot] = vec4(newVelocity, way);
    enterCell(slot, after, next);
    if (way <= kRestlessShare * fluid.search.y) return;
    if (way > fluid.search.y) atomicOr(counters.restless.w, 1u);
    const uint entry = atomicAdd(counters.restless.x, 1u);
    if (entry < FLOW_RESTLESS_ROOM) lists[3 * fluid.room.x + entry] = slot;
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index < counters.moving.w) moveOn(index);
    memoryBarrierBuffer();
    barrier();
    if (gl_LocalInvocationIndex != 0) return;
    // The last group to come here knows whether any particle went too far and decides whether there is a search.
    if (atomicAdd(counters.search.w, 1u) + 1 < counters.moving.x) return;
    counters.search.x = atomicAdd(counters.restless.w, 0u) > 0 ? counters.density.x : 0;
    counters.search.w = 0;
}
