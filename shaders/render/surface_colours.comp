#version 450 core
#extension GL_GOOGLE_include_directive : require
// The colours of vertices for files: the results of the pictures' functions, without lamp, arc and mirror image.
#include "shared/dispatch.h"
#include "render/hot.glsl"
#include "render/metal_look.glsl"
#include "render/scale.glsl"
layout(local_size_x = COLOURS_GROUP) in;

layout(std430, binding = COLOURED_HEATS_BINDING) readonly buffer Heats { vec2 heats[]; }; // now, and the highest so far
layout(std430, binding = COLOURS_BINDING) writeonly buffer Colours { vec4 colours[]; };   // linear

vec3 lightOf(float temperature, float peak) {
    if (frame.colourMode > 0.0) return scaleColour(temperature);
    MeltShares share = meltShares(temperature);
    if (frame.perMushyRange == 0.0) return materialColour(share.colour); // the classic model has no kelvin
    float liquid = liquidShare(temperature);
    vec3 body = mix(solidReflectance(temperature, peak), materialColour(1.0), liquid);
    return body + metalGlow(temperature, mix(solidEmissivity(temperature, peak), material.liquidEmissivity, liquid));
}

void main() {
    uint index = linearInvocation();
    if (index >= uint(heats.length())) return;
    vec2 heat = heats[index];
    colours[index] = vec4(toneCurve(max(lightOf(heat.x, heat.y), 0.0) * frame.exposure), 1.0);
}
