// The etched section: steel after nital. Metal that was molten shows columns of grains that grew from the fusion line
// inwards; metal that was above Ac1 is dark, darkest and coarsest next to the fusion line; the rest shows its rolling.
// Hot metal glows.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/hot.glsl"
#include "render/scale.glsl"

layout(location = 0) in vec2 inPicture;
layout(location = 1) in vec3 world;
layout(location = 0) out vec4 colour;

layout(location = 2) uniform vec2 corner;
layout(location = 3) uniform vec2 size;
layout(location = 4) uniform float spacing;

layout(binding = SECTION_UNIT) uniform sampler2D sums;
layout(binding = NOISE_UNIT) uniform sampler3D noise;

const float kAc1 = 996.0; // K, 723 degrees C: where steel begins to change

float peakAt(vec2 at) {
    vec4 sum = texture(sums, at);
    return sum.y / max(sum.x, 1e-6);
}

float grains(vec2 at) {
    return texture(noise, vec3(at, 0.37)).r;
}

void main() {
    vec4 sum = texture(sums, inPicture);
    if (sum.x < SECTION_INSIDE && sum.w < 0.5) discard;
    float peak = sum.y / sum.x;
    float temperature = sum.z / sum.x;
    if (frame.colourMode > 0.5) {
        colour = finishExact(scaleColour(temperature) * min(frame.exposure, 1.0), 1.0);
        return;
    }
    vec2 place = corner + inPicture * size;
    vec2 texel = 2.0 * spacing / size;
    vec2 slope = vec2(peakAt(inPicture + vec2(texel.x, 0.0)) - peakAt(inPicture - vec2(texel.x, 0.0)),
                      peakAt(inPicture + vec2(0.0, texel.y)) - peakAt(inPicture - vec2(0.0, texel.y))) / (4.0 * spacing);
    vec2 inwards = slope / max(length(slope), 1e-6);

    float fused = frame.solidus;
    vec2 cell = place / spacing; // grains are sized by the spacing so that every scale of plate shows them
    float speckle = grains(cell * 0.11) * 0.5 + grains(cell * 0.31) * 0.5;
    float rolled = grains(cell * vec2(0.012, 0.25));
    float reflectance = 0.50 + 0.10 * (speckle - 0.5) + 0.10 * (rolled - 0.5);
    float changed = smoothstep(kAc1 - 25.0, kAc1 + 60.0, peak);
    float coarse = smoothstep(1250.0, fused, peak);
    float zone = mix(0.27, 0.15, coarse) + mix(0.06, 0.16, coarse) * (grains(cell * mix(0.22, 0.09, coarse)) - 0.5);
    reflectance = mix(reflectance, zone, changed);
    float molten = smoothstep(fused - 15.0, fused + 15.0, peak);
    float columns = grains(vec2(dot(cell, vec2(-inwards.y, inwards.x)) * 0.16, dot(cell, inwards) * 0.022));
    reflectance = mix(reflectance, 0.40 + 0.22 * (columns - 0.5) + 0.05 * (speckle - 0.5), molten);
    float line = abs(peak - fused) / max(length(slope), 1e-6) / spacing; // distance from the fusion line, spacings
    reflectance *= 1.0 - 0.45 * smoothstep(0.22, 0.0, line);

    float light = frame.ambient + frame.diffuse * 0.8;
    vec3 body = light * reflectance * vec3(1.0, 0.98, 0.95);
    colour = finish(body + metalGlow(temperature, mix(solidEmissivity(temperature, peak), material.liquidEmissivity, liquidShare(temperature))), 1.0);
}
