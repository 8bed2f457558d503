// Heats, accelerates and moves each particle, cools it, and counts it for the next step's cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/neighbours.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = CLASSIC_VELOCITY_TEXELS) uniform samplerBuffer velocityTexels; // and 1 / density
// The neighbour bits of each particle's rows, until this pass writes its moved state here: see density.comp.
layout(std430, binding = CLASSIC_MOVED_POSITIONS) buffer Positions { uvec4 positions[]; };
layout(std430, binding = CLASSIC_MOVED_VELOCITIES) buffer Velocities { uvec4 velocities[]; };
layout(std430, binding = CLASSIC_REFUSED) buffer Refused { uint refused; };
#ifndef ALL_PAIRS
layout(std430, binding = CLASSIC_CELL_SLOTS) buffer Slots { uvec2 slots[]; };
layout(std430, binding = CLASSIC_CELL_COUNTS) buffer Counts { uint counts[]; };
#endif

float heated(vec3 place, float temperature) {
    const vec3 displacement = place - now.source;
    const float squared = dot(displacement, displacement);
    if (squared >= now.heatRadiusSquared) return temperature;
    return clamp(temperature + now.heat * (1.0 - squared / now.heatRadiusSquared), 0.0, 1.0);
}

/// Sums over the neighbours of a particle, without the common factors.
struct Pull {
    vec3 pressure;
    vec3 viscosity;
};

/// Adds the forces of neighbour j on a particle at `place`: Müller, Charypar, Gross 2003, with the viscosity force
/// along v_j - v_i. With a = 1/rho_j the pressure's factor (p_i + p_j)/(2 rho_j), p = k (rho - rho0), is ((p_i - k
/// rho0) a + k)/2: no division for a neighbour. The particle itself, and one in the same place, has no direction.
void addNeighbour(uint j, vec3 place, vec3 velocity, float own, inout Pull pull) {
    const vec3 displacement = place - texelFetch(positionTexels, int(j)).xyz;
    const vec4 neighbour = texelFetch(velocityTexels, int(j));
    const float neighbourInverseDensity = neighbour.w;
    const float squared = dot(displacement, displacement);
    const float inverse = squared > 0.0 ? inversesqrt(squared) : 0.0;
    const float inside = max(now.supportRadius - squared * inverse, 0.0);
    pull.pressure +=
        ((own * neighbourInverseDensity + now.gasStiffness) * inside * inside * inverse) * displacement;
    pull.viscosity += (neighbour.xyz - velocity) * (inside * neighbourInverseDensity);
}

/// Pressure and viscosity force on particle i over its density. Visits the neighbours that the density's pass recorded,
/// and of a row with more than 32 particles all that have no bit.
vec3 accelerationByNeighbours(uint i, vec3 place, vec3 velocity, float inverseDensity) {
    const ivec3 cell = cellOf(place);
    const float own = now.gasStiffness * (1.0 / inverseDensity - 2.0 * now.restDensity);
#ifndef ALL_PAIRS
    const uvec4 firstRows = positions[i], nextRows = velocities[i];
    const uint lastRow = slots[i].x;
#endif
    Pull pull = Pull(vec3(0), vec3(0));
    for (int row = 0; row < kRows; ++row) {
        uvec2 range = rangeOfRow(cell, row);
#ifndef ALL_PAIRS
        uint near = row < 4 ? firstRows[row] : row < 8 ? nextRows[row - 4] : lastRow;
        for (; near != 0u; near &= near - 1u)
            addNeighbour(range.x + uint(findLSB(near)), place, velocity, own, pull);
        range.x += 32u;
#endif
        for (uint j = range.x; j < range.y; ++j)
            addNeighbour(j, place, velocity, own, pull);
    }
    return (0.5 * now.spiky * pull.pressure + now.viscosity * pull.viscosity) * inverseDensity;
}

vec3 limited(vec3 acceleration) {
    const float size = length(acceleration);
    return size > now.accelerationLimit ? acceleration * (now.accelerationLimit / size) : acceleration;
}

/// Moves a particle that left the box back to the wall and reverses its velocity.
void bounce(inout vec3 place, inout vec3 velocity) {
    const bvec3 beyond = greaterThan(abs(place), vec3(1));
    if (!any(beyond)) return;
    place = clamp(place, vec3(-1), vec3(1));
    const vec3 back = -now.wallRestitution * velocity;
    velocity = now.wallSlip != 0u ? mix(velocity, back, beyond) : back;
}

bool isFinite(vec4 v) {
    return all(notEqual(floatBitsToUint(v) & 0x7F800000u, uvec4(0x7F800000u)));
}

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const vec4 positionBefore = texelFetch(positionTexels, int(i));
    const vec4 velocityBefore = texelFetch(velocityTexels, int(i));
    const float inverseDensity = velocityBefore.w;
    vec3 position = positionBefore.xyz, velocity = velocityBefore.xyz;
    float temperature = heated(position, positionBefore.w);
    if (temperature > 0.0) {
        const vec3 acceleration = limited(accelerationByNeighbours(i, position, velocity, inverseDensity) + now.gravity);
        velocity = (velocity + acceleration * now.timeStep) * temperature;
        position += velocity * now.timeStep;
        bounce(position, velocity);
        temperature = max(temperature - now.solidifyRate, 0.0);
    }
    if (temperature == 0.0) velocity = vec3(0); // solid: at rest, without viscous drag on its neighbours
    vec4 newPosition = vec4(position, temperature);
    if (!isFinite(newPosition) || !isFinite(vec4(velocity, 0))) {
        atomicAdd(refused, 1u);
        newPosition = positionBefore;
        velocity = vec3(0);
    }
    positions[i] = floatBitsToUint(newPosition);
    velocities[i] = floatBitsToUint(vec4(velocity, 1.0 / inverseDensity));
#ifndef ALL_PAIRS
    const uint cell = cellIndex(cellOf(newPosition.xyz));
    slots[i] = uvec2(cell, atomicAdd(counts[cell], 1u));
#endif
}
