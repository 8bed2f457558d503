// A vertex of opaque metal. Everything that is smooth over a triangle is worked out here: the triangles are small, and
// software drivers pay dearly for each pixel.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/metal_look.glsl"

layout(location = 0) in vec4 position; // model units; w: temperature
layout(location = 1) in vec4 outward;

// Few and narrow varyings: each number costs as much per pixel as the shading of it.
layout(location = 0) out vec3 mirrored; // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 body;     // light of the material itself
layout(location = 2) out vec2 surface;  // x: brightness of the mirror image, y: dullness

void main() {
    vec3 world = toWorld(position.xyz);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward.xyz);
    mirrored = reflect(world - frame.views[viewIndex()].eye.xyz, n);

    vec2 share = meltShares(position.w);
    float light = frame.phong.x + frame.phong.y * max(dot(n, normalize(frame.light.xyz - world)), 0.0);
    float mirror = mix(material.solid.w, material.liquid.w, share.y);
    body = light * (1.0 - mirror) * materialColour(share.x);
    surface = vec2(light * mirror, frame.detail.x * (1.0 - share.y));
    showCut(world);
}
