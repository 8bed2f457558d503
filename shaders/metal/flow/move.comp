#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 2: pressure, viscosity and surface tension on the liquid; then moves it on into the next substep's cells.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/pair_forces.glsl"
#include "metal/flow/body_forces.glsl"

layout(std430, binding = FLOW_PHASE_CHANGES) buffer PhaseChanges { uint phaseChanges[]; };

/// Number of neighbours below which a liquid particle flies alone or in a drop of a few particles.
const uint kFlyingBelow = 20;

/// Sums over the neighbours of a particle.
struct PairSums {
    vec3 acceleration;   // m/s²
    float fastest2;      // square of the fastest relative velocity of a neighbour that is not much faster than the particle, m²/s²
    SolidAround solids;
    float tether; // greatest tether of a neighbour, PHASE_TETHER_MOST + 1 for fixed metal
#ifdef MARANGONI
    Warming warming;
#endif
};

/// The pair of a particle with the neighbour of a list entry, and the other values in the neighbour's texels.
Pair readPair(FlowParticle own, uint neighbour, out float density, out vec3 normal, out vec4 velocity) {
    const float inverse = fluid.inverseSupport * fluid.inverseSupport;
    const int texel = int(neighbour & FLOW_SLOT) * FLOW_PARTICLE_TEXELS;
    const vec4 place = texelFetch(particleTexels, texel);
    const vec4 surface = texelFetch(particleTexels, texel + 1);
    density = place.w;
    normal = surface.xyz;
    velocity = texelFetch(particleTexels, texel + 2);
    Pair pair;
    pair.d = displacement(own.position, place.xyz);
    pair.distance2 = dot(pair.d, pair.d);
    pair.q2 = min(pair.distance2 * inverse, 1);
    pair.q = sqrt(pair.q2);
    const float u = 1 - pair.q2;
    pair.slope = -8 * fluid.kernelSelf * inverse * u * u * u;
    pair.solid = (neighbour & FLOW_SOLID) != 0;
    pair.relative = own.velocity - velocity.xyz;
    pair.approach = dot(pair.relative, pair.d);
    pair.temperature = surface.w;
    pair.weight = surfaceWeight(pair.solid, pair.temperature, own.density, density);
    return pair;
}

PairSums sumPairs(uint row, FlowParticle own, uint found) {
    PairSums sums;
    sums.acceleration = vec3(0);
    sums.fastest2 = 0;
    sums.solids = SolidAround(vec3(0), 0, 0);
    sums.tether = 0;
#ifdef MARANGONI
    sums.warming = Warming(vec3(0), 0);
#endif
    const uint base = neighbourBase(row);
    const float ownPressure = pressureTerm(own.density);
    const float slower = 2 * dot(own.velocity, own.velocity);
    for (uint k = 0; k < found; ++k) {
        float density;
        vec3 normal;
        vec4 velocity; // w: tether
        const uint neighbour = neighbourTexel(base, k);
        const Pair pair = readPair(own, neighbour, density, normal, velocity);
        // A single fast particle makes its own list stale, not those of all particles around it.
        if (dot(velocity.xyz, velocity.xyz) < slower) sums.fastest2 = max(sums.fastest2, dot(pair.relative, pair.relative));
        addSolid(sums.solids, pair);
        sums.tether = max(sums.tether, (neighbour & FLOW_WALL) != 0 ? float(PHASE_TETHER_MOST + 1)
                                       : pair.solid                   ? 0.0
                                                                      : velocity.w);
        sums.acceleration += (pair.slope * (viscosityOf(pair) - pressureOf(ownPressure, density)) - cohesionOf(pair) -
                              areaForceOf(pair, own.normal, normal)) *
                             pair.d;
#ifdef MARANGONI
        addWarming(sums.warming, pair, own.temperature);
#endif
    }
    sums.solids.density /= -8 * fluid.inverseSupport * fluid.inverseSupport;
    return sums;
}

/// Acceleration by all neighbours, the arc and the buoyancy, the fastest speed of a neighbour relative to the particle
/// (m/s), and the particle's tether to fixed metal.
vec3 acceleration(uint row, uint slot, out float fastest, out SolidAround solids, out uint tether) {
    const FlowParticle own = particles[slot];
    const uint found = neighbourCount(row);
    const PairSums sums = sumPairs(row, own, found);
    solids = sums.solids;
    tether = uint(max(sums.tether - 1, 0));
    vec3 sum = sums.acceleration;
    // The particle's surface per volume, 1/m; half of the gradient is outside, where no particle feels it.
    const vec3 inward = 2 * own.normal / fluid.densityScale;
#ifdef MARANGONI
    sum += marangoniForce(sums.warming, inward, own.temperature);
#endif
    sum += arcForce(own.position, inward);
    // Flying metal meets particles that are not neighbours yet; nothing carries it, so it has its whole weight.
    const bool flying = found < kFlyingBelow;
    fastest = flying ? max(sqrt(sums.fastest2), 0.4 * length(own.velocity)) : sqrt(sums.fastest2);
    if (!flying) sum -= weightCorrection(own.temperature);
    return sum;
}

/// Speed (m/s) from which a velocity counts as not finite.
const float kNotFinite = 1e6;

/// Limits a velocity to the speed limit; one that is not finite becomes 0 and is counted.
vec3 limitSpeed(vec3 fast) {
    const float speed = length(fast);
    if (!(speed < kNotFinite)) { // true also for a NaN
        atomicAdd(counters.notFinite, 1u);
        return vec3(0);
    }
    return speed > fluid.speedLimit ? fast * (fluid.speedLimit / speed) : fast;
}

/// Share of its free way from which a particle renews its neighbour list along with others.
const float kStaleShare = 0.8;

/// Records the particles whose neighbours may have moved so far (m) since the search that a list misses some.
void noteStale(uint slot, float way) {
    if (way <= kStaleShare * fluid.freeWay) return;
    if (way > fluid.freeWay) atomicOr(counters.searchDue, 1u);
    const uint k = atomicAdd(counters.stale, 1u);
    if (k < FLOW_STALE_CAPACITY) lists[staleIndex(k)] = slot;
}

/// Writes a particle's tether to fixed metal; metal that froze in flight and has come down is wall from the next step
/// on.
void writeTether(uint slot, uint tether) {
    const uint before = phase[slot];
    const uint after = (before & ~PHASE_TETHER_BITS) | tether << PHASE_TETHER_SHIFT;
    if (after == before) return;
    phase[slot] = after;
    if (flows(after)) return;
    const uint entry = atomicAdd(phaseChanges[0], 1u);
    if (entry < uint(fluid.capacity)) phaseChanges[entry + 1u] = slot;
}

void moveLiquid(uint row, uint slot) {
    const vec4 before = position[slot];
    const float dt = fluid.timeStep;
    float fastest;
    SolidAround solids;
    uint tether;
    const vec3 forces = acceleration(row, slot, fastest, solids, tether);
    writeTether(slot, tether);
    vec3 newVelocity = velocity[slot].xyz + dt * (forces + (metal.gravity + fluid.acceleration));
    newVelocity *= mushyShare(heat[slot].x, tether);
    newVelocity = stopAtSolid(solids, newVelocity - velocity[slot].xyz, newVelocity);
    newVelocity = limitSpeed(newVelocity);
    const vec3 free = stopAtLattice(before.xyz, before.xyz + dt * newVelocity, newVelocity);
    const vec3 after = confine(free, newVelocity);
    const float way = velocity[slot].w + dt * fastest;
    position[slot] = vec4(after, before.w);
    velocity[slot] = vec4(newVelocity, way);
    binParticle(slot, after);
    noteStale(slot, way);
}

void main() {
    const uint k = gl_GlobalInvocationID.x;
    if (k < counters.liquids)
        moveLiquid(k, movingSlot(k));
    else if (k < counters.liquids + counters.fragments)
        binParticle(movingSlot(k), position[movingSlot(k)].xyz); // other passes move fragments
    memoryBarrierBuffer();
    barrier();
    if (gl_LocalInvocationIndex != 0) return;
    // The last group to arrive knows whether a neighbour moved too far, and decides whether the next substep searches.
    if (atomicAdd(counters.moveGroupsDone, 1u) + 1 < counters.movingGroups.x) return;
    counters.searchGroups.x = atomicAdd(counters.searchDue, 0u) > 0 ? counters.densityGroups.x : 0;
    counters.moveGroupsDone = 0;
}
