// Light of hot metal and temper colours.
#ifndef MELTPOOL_RENDER_HOT_GLSL
#define MELTPOOL_RENDER_HOT_GLSL

#include "render/frame.glsl"

layout(binding = HEAT_UNIT) uniform sampler2D heatColours;

// A texel of the heat texture; `row`: texture coordinate of the row.
vec3 heatColour(float kelvin, float row) {
    float t = clamp((kelvin - HEAT_COLDEST) / (HEAT_HOTTEST - HEAT_COLDEST), 0.0, 1.0);
    return textureLod(heatColours, vec2((t * float(HEAT_COLUMNS - 1) + 0.5) / float(HEAT_COLUMNS), row), 0.0).rgb;
}

// Light of a black body; 1: white paper in the workshop.
vec3 glowOf(float kelvin) {
    vec3 root = heatColour(kelvin, 0.25);
    root *= root;
    return root * root;
}

// Factor on the reflectance of metal whose highest temperature was this.
vec3 tintOf(float peakKelvin) {
    return heatColour(peakKelvin, 0.75);
}

// Factor of the oxide on the reflectance of metal that is liquid to this share. Only solid metal has oxide: a pool is
// clean.
vec3 oxideOn(float kelvin, float peakKelvin, float liquid) {
    return mix(vec3(1.0), tintOf(max(peakKelvin, kelvin)), material.oxideTint * (1.0 - liquid));
}

// Light of the metal itself.
vec3 metalGlow(float kelvin) {
    return material.emissivity * glowOf(kelvin);
}

#endif
