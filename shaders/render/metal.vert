// A vertex of opaque metal. Quantities that vary smoothly over a triangle are computed here: the triangles are small.
// SYNCHRONOUS_DRIVER: it is slow per pixel.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/metal_look.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature;

// Few and narrow varyings: interpolating one costs as much per pixel as shading with it.
layout(location = 0) out vec3 mirrored; // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 body;     // light of the material itself
layout(location = 2) out float mirrorBrightness;
layout(location = 6) out float dullness;

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    mirrored = reflect(world - frame.views[viewIndex()].eye, n);

    MeltShares share = meltShares(vertexTemperature);
    float light = frame.ambient + frame.diffuse * max(dot(n, normalize(frame.lamp - world)), 0.0);
    float mirror = mix(material.solidMirror, material.liquidMirror, share.mirror);
    body = light * (1.0 - mirror) * materialColour(share.colour);
    mirrorBrightness = light * mirror;
    dullness = frame.dullness * (1.0 - share.mirror);
    showCut(world);
}
