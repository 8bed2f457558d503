// A vertex of metal with a temperature in kelvin: as metal.vert, with temper colours and glow.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/arc.glsl"
#include "render/hot.glsl"
#include "render/metal_look.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature; // K
layout(location = PEAK_ATTRIBUTE) in float peak; // highest temperature so far, K

layout(location = 0) out vec3 mirrored;    // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 body;        // light of the material itself
layout(location = 2) out float mirrorBrightness;
layout(location = 3) out vec3 mirrorTint;  // colour of the mirror image
layout(location = 4) out float temperature;
layout(location = 5) out vec3 toArc;
layout(location = 6) out float dullness;

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    mirrored = reflect(world - frame.views[viewIndex()].eye, n);

    float liquid = meltShares(vertexTemperature).mirror;
    float light = frame.ambient + frame.diffuse * max(dot(n, normalize(frame.lamp - world)), 0.0);
    float mirror = mix(material.solidMirror, material.liquidMirror, liquid);
    vec3 tint = oxideOn(vertexTemperature, peak, liquid);
    float scale = 1.0 - dot(tint, vec3(1.0 / 3.0));
    toArc = frame.arc - world;
    vec3 lit = vec3(light) + arcDiffuse(toArc, n);
    body = lit * (1.0 - mirror) * materialColour(liquid) * tint;
    mirrorTint = mix(vec3(1.0), material.mirrorColour, 0.8) * tint;
    mirrorBrightness = light * mirror * (1.0 - 0.5 * scale * (1.0 - liquid));
    dullness = frame.dullness * (1.0 - liquid);
    temperature = vertexTemperature;
    showCut(world);
}
