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

// Share of the source's heat that reaches a place, 0..1.
float heatAt(vec3 way) {
    return max(1.0 - dot(way, way) / (frame.sourceReach * frame.sourceReach), 0.0);
}

// Share of the lamp's light that the burner lets through: a soft round shadow straight below the flame, fainter with
// height.
float lightPastSource(vec3 way, vec3 n) {
    float aside = length(way.xz) / (0.5 * frame.sourceReach);
    float below = smoothstep(0.0, 0.1 * frame.sourceReach, way.y) * max(n.y, 0.0);
    return 1.0 - frame.sourceShadow * below * (1.0 - smoothstep(0.2, 1.0, aside)) /
                     (1.0 + 0.5 * way.y / frame.sourceReach);
}

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    mirrored = reflect(world - frame.views[viewIndex()].eye, n);

    MeltShares share = meltShares(vertexTemperature);
    vec3 toSource = frame.source - world;
    float light = frame.ambient + frame.diffuse * max(dot(n, normalize(frame.lamp - world)), 0.0);
    light *= lightPastSource(toSource, n);
    float mirror = mix(material.solidMirror, material.liquidMirror, share.mirror);
    body = light * (1.0 - mirror) * materialColour(share.colour);
    body += (1.0 - share.mirror) * heatAt(toSource) * frame.sourceLight; // on liquid metal it would look like a glow
    mirrorBrightness = light * mirror;
    dullness = frame.dullness * (1.0 - share.mirror);
    showCut(world);
}
