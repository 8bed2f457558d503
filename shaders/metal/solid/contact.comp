// Finds what each particle of a loose piece touches: fixed metal, the floor, other loose pieces.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LOOSE) readonly buffer Loose { uint loose[]; };
layout(std430, binding = PIECES_CONTACT) writeonly buffer Contacts { PieceContact contact[]; };

// A spring that turns an overlap around in a few steps, and its damper: stable for a lone particle with five neighbours.
const float kSpring = 0.2;
const float kDamper = 0.2;

void touch(vec3 apart, vec3 relative, bool standsStill, inout PieceContact sum) {
    float reach = metal.spacing;
    float distance = length(apart);
    if (distance >= reach || distance < 1e-3 * reach) return;
    vec3 normal = apart / distance;
    float overlap = reach - distance;
    float approach = dot(relative, normal);
    if (standsStill) {
        sum.push += ivec4(round(overlap * normal * 1e9), 1);
        sum.damp.xyz += ivec3(round(approach * normal * 1e6));
        sum.slip.xyz += ivec3(round((relative - approach * normal) * 1e6));
    } else {
        float dt = pieces.step.x;
        vec3 acceleration = (kSpring * overlap / dt - kDamper * approach) / dt * normal;
        sum.knock.xyz += ivec3(round(clamp(acceleration, -1e5, 1e5) * 1e3));
    }
}

void touchLattice(vec3 place, vec3 speed, inout PieceContact sum) {
    ivec3 centre = latticeCell(place);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                ivec3 cell = centre + ivec3(x, y, z);
                if (!inLattice(cell)) continue;
                uint other = latticeSlot[latticeIndex(cell)];
                if (other != 0 && solid(phase[other - 1])) touch(place - position[other - 1].xyz, speed, true, sum);
            }
}

void touchOthers(vec3 place, vec3 speed, uint piece, inout PieceContact sum) {
    ivec3 centre = coarseCell(place);
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, pieces.coarse.xyz - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                for (uint other = head[coarseIndex(ivec3(x, y, z))]; other != 0; other = next[other - 1]) {
                    uint otherPiece = pieceOf(phase[other - 1]);
                    if (otherPiece == piece) continue;
                    vec3 relative = speed - (otherPiece == 0 ? vec3(0) : velocity[other - 1].xyz);
                    touch(place - position[other - 1].xyz, relative, otherPiece == 0, sum);
                }
}

void main() {
    uint entry = linearInvocation();
    if (entry >= control.loose) return;
    uint slot = loose[entry];
    PieceContact sum = PieceContact(ivec4(0), ivec4(0), ivec4(0), ivec4(0));
    uint bits = phase[slot];
    if (solid(bits)) {
        vec3 place = position[slot].xyz;
        vec3 speed = velocity[slot].xyz;
        touchLattice(place, speed, sum);
        touchOthers(place, speed, pieceOf(bits), sum);
        // The floor is met by the particle's rim: half a spacing from its centre.
        float height = place.y - pieces.step.y + 0.5 * metal.spacing;
        touch(vec3(0, max(height, 0.01 * metal.spacing), 0), speed, true, sum);
    }
    contact[entry] = sum;
}
