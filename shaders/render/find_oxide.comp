#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the particles that carry an island of oxide while they are liquid, in the order of their numbers: one group, so
// that a full list always holds the same ones. One of each OXIDE_STRIDE particles is a carrier, chosen by its number.
#include "render/frame.glsl"
layout(local_size_x = OXIDE_GROUP) in;

layout(std430, binding = OXIDE_PARTICLES_BINDING) readonly buffer Particles { vec4 particles[]; };
layout(std430, binding = OXIDE_BINDING) writeonly buffer Oxide { OxideIslands oxide; };
layout(location = 0) uniform uint particleCount;

// K from which on islands are smaller, and at which there is none: the arc drives the oxide off. None: chosen.
const float kSmallerFrom = 2000.0;
const float kNoneFrom = 2300.0;

shared uint before[OXIDE_GROUP]; // carriers found up to each invocation

uint scrambled(uint number) {
    number = (number ^ (number >> 16)) * 0x45d9f3bu;
    number = (number ^ (number >> 16)) * 0x45d9f3bu;
    return number ^ (number >> 16);
}

/// Sums up `before` over the invocations.
void sumUp() {
    uint self = gl_LocalInvocationIndex;
    for (uint reach = 1u; reach < OXIDE_GROUP; reach *= 2u) {
        barrier();
        uint sum = before[self] + (self >= reach ? before[self - reach] : 0u);
        barrier();
        before[self] = sum;
    }
    barrier();
}

void main() {
    uint self = gl_LocalInvocationIndex, found = 0u;
    uint carriers = particleCount / OXIDE_STRIDE;
    for (uint first = 0u; first < carriers; first += OXIDE_GROUP) {
        uint number = first + self, chance = scrambled(number);
        uint at = number * OXIDE_STRIDE + chance % OXIDE_STRIDE;
        vec4 particle = number < carriers ? particles[at] : vec4(0.0); // model, K
        bool carries = particle.w > frame.solidus && particle.w < kNoneFrom;
        barrier(); // after all have read the last round's sums
        before[self] = carries ? 1u : 0u;
        sumUp();
        uint slot = found + before[self] - 1u;
        if (carries && slot < OXIDE_MOST) {
            vec3 world = (frame.modelToWorld * vec4(particle.xyz, 1.0)).xyz;
            // Radii from 0.75 to 1.25 of the mean.
            float radius = frame.oxideRadius * frame.modelUnit * (0.75 + 0.5 * float((chance >> 8) & 255u) / 255.0);
            radius *= 1.0 - smoothstep(kSmallerFrom, kNoneFrom, particle.w);
            oxide.islands[slot] = OxideIsland(world, 1.0 / radius, number, 0u, 0u, 0u);
        }
        found += before[OXIDE_GROUP - 1u];
    }
    if (self == 0u) oxide.count = min(found, OXIDE_MOST);
}
