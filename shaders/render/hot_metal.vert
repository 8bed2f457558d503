// A vertex of metal with a temperature in kelvin: as metal.vert, with the oxide's tint and the heat's glow.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/hot.glsl"
#include "render/metal_look.glsl"
#include "render/view.glsl"
#include "shared/metal.h"

layout(location = 0) in vec4 position; // model units; w: temperature, K
layout(location = 1) in vec4 outward;
layout(location = 2) in float peak; // highest temperature so far, K

layout(location = 0) out vec3 mirrored;    // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 body;        // light of the material itself
layout(location = 2) out vec2 surface;     // x: brightness of the mirror image, y: dullness
layout(location = 3) out vec3 mirrorTint;  // colour of the mirror image
layout(location = 4) out float temperature;

layout(location = 1) uniform vec4 lattice; // low corner in model units, cells a model unit; w = 0: the attribute holds
layout(location = 2) uniform ivec3 tiles;

layout(std430, binding = PEAK_SLOTS_BINDING) readonly buffer Slots {
    int slots[];
};
layout(std430, binding = PEAK_HEAT_BINDING) readonly buffer Heat {
    vec4 heat[];
};

// Mean over the lattice particles of the eight cells around, the nearer the more; a little over the liquidus where none
// is left.
float latticePeak(vec3 model) {
    vec3 at = (model - lattice.xyz) * lattice.w - 0.5;
    ivec3 base = ivec3(floor(at));
    vec3 part = at - vec3(base);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        ivec3 cell = base + corner;
        if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, tiles * TILE_EDGE))) continue;
        ivec3 tile = cell / TILE_EDGE;
        ivec3 inside = cell - tile * TILE_EDGE;
        int index = ((tile.z * tiles.y + tile.y) * tiles.x + tile.x) * TILE_CELLS +
                    (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x;
        int slot = slots[index];
        if (slot <= 0) continue;
        vec3 near3 = mix(1.0 - part, part, vec3(corner));
        float weight = near3.x * near3.y * near3.z + 0.01;
        sum += weight * vec2(1.0, heat[slot - 1].z);
    }
    return sum.x > 0.05 ? sum.y / sum.x : frame.temperature.z + 100.0;
}

void main() {
    vec3 world = toWorld(position.xyz);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward.xyz);
    mirrored = reflect(world - frame.views[viewIndex()].eye.xyz, n);

    float liquid = meltShares(position.w).y;
    float light = frame.phong.x + frame.phong.y * max(dot(n, normalize(frame.light.xyz - world)), 0.0);
    float mirror = mix(material.solid.w, material.liquid.w, liquid);
    // Oxide lies on solid metal only: a pool is clean.
    vec3 tint = mix(vec3(1.0), tintOf(max(lattice.w > 0.0 ? latticePeak(position.xyz) : peak, position.w)), material.heat.y * (1.0 - liquid));
    float scale = 1.0 - dot(tint, vec3(1.0 / 3.0));
    body = light * (1.0 - mirror) * materialColour(liquid) * tint;
    mirrorTint = mix(vec3(1.0), material.mirror.rgb, 0.8) * tint;
    surface = vec2(light * mirror * (1.0 - 0.5 * scale * (1.0 - liquid)), frame.detail.x * (1.0 - liquid));
    temperature = position.w;
    gl_Position = toClipCut(world);
}
