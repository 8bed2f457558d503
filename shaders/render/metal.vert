// A vertex of opaque metal. Everything that is smooth over a triangle is worked out here: the triangles are small, and
// software drivers pay dearly for each pixel.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/metal_look.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature;

// Few and narrow varyings: each number costs as much per pixel as the shading of it.
layout(location = 0) out vec3 mirrored; // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 body;     // light of the material itself
layout(location = 2) out vec2 surface;  // x: brightness of the mirror image, y: dullness

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    mirrored = reflect(world - frame.views[viewIndex()].eye, n);

    vec2 share = meltShares(vertexTemperature);
    float light = frame.ambient + frame.diffuse * max(dot(n, normalize(frame.lamp - world)), 0.0);
    float mirror = mix(material.solidMirror, material.liquidMirror, share.y);
    body = light * (1.0 - mirror) * materialColour(share.x);
    surface = vec2(light * mirror, frame.dullness * (1.0 - share.y));
    showCut(world);
}
