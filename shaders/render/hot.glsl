// Light of hot metal, its oxide and its reflections.
#ifndef MELTPOOL_RENDER_HOT_GLSL
#define MELTPOOL_RENDER_HOT_GLSL

#include "render/frame.glsl"

layout(binding = HEAT_UNIT) uniform sampler2D heatColours;

// Highest temperatures (K) at which steel's scale begins to cover the metal and at which it is closed, see temperTint().
const float kScaleBegins = 673.0;
const float kScaleClosed = 1173.0;
// Reflectance of scaled metal that was molten, over that of scale on rolled metal. None: chosen so that a finished bead
// is a little brighter.
const float kFrozenScale = 1.5;
// Colour of scale: a little blue. None: chosen.
const vec3 kScaleColour = vec3(0.93, 0.97, 1.05);
// Reflectance of mill scale: blue-black. None: chosen, 0.1 to 0.15.
const vec3 kMillScale = vec3(0.105, 0.116, 0.138);

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

// Factor on the reflectance of metal with this highest temperature.
vec3 tintOf(float peakKelvin) {
    return heatColour(peakKelvin, 0.75);
}

// Molten share of metal, 0..1. Over the freezing range, or one kelvin, the look changes from that of the solid to that
// of the liquid.
float liquidShare(float kelvin) {
    return clamp((kelvin - frame.solidus) * frame.perMushyRange, 0.0, 1.0);
}

// Share of solid metal's surface under scale.
float scaledShare(float peakKelvin) {
    return material.oxideTint * smoothstep(kScaleBegins, kScaleClosed, peakKelvin);
}

float scaleReflectance(float peakKelvin) {
    return (1.0 - material.scaledEmissivity) * mix(1.0, kFrozenScale, liquidShare(peakKelvin));
}

// Emissivity of solid metal; with liquidEmissivity it jumps at the melting point.
float solidEmissivity(float kelvin, float peakKelvin) {
    float peak = max(kelvin, peakKelvin);
    return mix(material.cleanEmissivity, 1.0 - scaleReflectance(peak), scaledShare(peak));
}

// Reflectance of solid metal: temper colours on clean metal, scale on metal that was hotter.
vec3 solidReflectance(float kelvin, float peakKelvin) {
    float peak = max(kelvin, peakKelvin);
    vec3 tint = mix(vec3(1.0), tintOf(peak), material.oxideTint);
    return mix(material.cleanReflectance * tint, kScaleColour * scaleReflectance(peak), scaledShare(peak));
}

// Emissivity of solid metal with the share `milled` under mill scale. Without MILL_SCALE none is.
float solidEmissivity(float kelvin, float peakKelvin, float milled) {
    float bare = solidEmissivity(kelvin, peakKelvin);
#ifdef MILL_SCALE
    float unscaled = 1.0 - scaledShare(max(kelvin, peakKelvin));
    return bare + milled * unscaled * (1.0 - kMillScale.g - material.cleanEmissivity);
#else
    return bare;
#endif
}

vec3 solidReflectance(float kelvin, float peakKelvin, float milled) {
    vec3 bare = solidReflectance(kelvin, peakKelvin);
#ifdef MILL_SCALE
    float peak = max(kelvin, peakKelvin);
    vec3 tint = mix(vec3(1.0), tintOf(peak), material.oxideTint); // tint of the metal under the scale
    return bare + milled * (1.0 - scaledShare(peak)) * (kMillScale - material.cleanReflectance * tint);
#else
    return bare;
#endif
}

// frame.dullness 0: solid metal mirrors as sharply as liquid.
float solidRoughness() {
    return max(frame.dullness * material.solidRoughness, material.liquidRoughness);
}

// Light of metal of this emissivity. Without a visor it is compressed: it would dazzle the eye, and the pool's edge,
// where twice as much light falls off within a millimetre, would be white in white.
vec3 metalGlow(float kelvin, float emissivity) {
    vec3 glow = emissivity * glowOf(kelvin);
    if (frame.glowSoftening <= 0.0) return glow;
    float luminance = max(dot(glow, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
    return glow * (frame.glowSoftening * log(1.0 + luminance / frame.glowSoftening) / luminance);
}

#endif
