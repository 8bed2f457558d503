// The particles as the surface's passes see them: now, and as they were last entered into the volumes.
#ifndef MELTPOOL_SURFACE_PARTICLES_GLSL
#define MELTPOOL_SURFACE_PARTICLES_GLSL

#include "shared/metal.h"

layout(binding = SURFACE_TEXELS_PARTICLES) uniform samplerBuffer particles;
layout(std430, binding = SURFACE_BIND_PHASES) readonly buffer Phases { uint phases[]; };

/// A particle's place and temperature; SURFACE_NOWHERE when it is no metal or its place is no number.
vec4 particleNow(uint index) {
    vec4 particle = texelFetch(particles, int(index));
    bool alive = (setup.options.z & SURFACE_WITH_PHASES) == 0 || (phases[index] & PHASE_ALIVE) != 0u;
    bool somewhere = all(lessThan(abs(particle.xyz), vec3(1e30)));
    return alive && somewhere ? particle : vec4(SURFACE_NOWHERE);
}

#endif
