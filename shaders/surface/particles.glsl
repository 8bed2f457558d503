// The particles for the surface's passes: in their present state, and as they were last splatted into the volumes.
#ifndef MELTPOOL_SURFACE_PARTICLES_GLSL
#define MELTPOOL_SURFACE_PARTICLES_GLSL

#include "shared/metal.h"

layout(binding = SURFACE_TEXELS_PARTICLES) uniform samplerBuffer particles;
layout(std430, binding = SURFACE_BIND_PHASES) readonly buffer Phases { uint phases[]; };

struct Particle {
    vec3 position;
    float temperature;
};

Particle fetchParticle(samplerBuffer from, uint index) {
    vec4 texel = texelFetch(from, int(index));
    return Particle(texel.xyz, texel.w);
}

/// A particle in its present state; at SURFACE_NOWHERE if it is no metal or its position is not a number.
Particle particleNow(uint index) {
    Particle particle = fetchParticle(particles, index);
    bool alive = (setup.particleData & SURFACE_WITH_PHASES) == 0 || (phases[index] & PHASE_ALIVE) != 0u;
    bool somewhere = all(lessThan(abs(particle.position), vec3(1e30)));
    return alive && somewhere ? particle : Particle(vec3(SURFACE_NOWHERE), SURFACE_NOWHERE);
}

#ifdef SURFACE_NUMBERED
layout(binding = SURFACE_TEXELS_NUMBERS) uniform usamplerBuffer numbers;

/// Index of a particle's record: its state when it was last splatted.
uint recordOf(uint index) { return texelFetch(numbers, int(index)).x; }
#else
uint recordOf(uint index) { return index; }
#endif

#ifdef SURFACE_FREEZING
layout(binding = SURFACE_TEXELS_FROZEN_AT) uniform samplerBuffer frozenAt;

/// Time when a particle froze, s; negative if it is molten, 0 if it never was.
float frozenNow(uint index) {
    return texelFetch(frozenAt, int(index)).x;
}
#endif

#endif
