// Metal with a temperature in kelvin: mirrors its surroundings and glows.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/arc.glsl"
#include "render/environment.glsl"
#include "render/hot.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 mirrored;
layout(location = 1) in vec3 body;
layout(location = 2) in float mirrorBrightness;
layout(location = 6) in float dullness;
layout(location = 3) in vec3 mirrorTint;
layout(location = 4) in float temperature;
layout(location = 5) in vec3 toArc;
layout(location = 0) out vec4 colour;

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

const float kLiquidLevel = 1.0;
const float kSolidLevel = 3.0;
// Sharpness of the arc's image in a liquid and in a rolled or scaled surface.
const float kLiquidLobe = 600.0;
const float kSolidLobe = 8.0;

void main() {
    vec3 seen = decodeEnvironment(
        textureLod(roughEnvironment, mirrored, kLiquidLevel + (kSolidLevel - kLiquidLevel) * dullness).rgb);
    float towardsLamp = max(dot(normalize(mirrored), frame.lampDirection), 0.0);
    float glint = frame.specular * (1.0 - 0.65 * dullness) * pow(towardsLamp, frame.shininess * (1.0 - 0.8 * dullness));
    vec3 glow = metalGlow(temperature);
    vec3 light = body + mirrorBrightness * mirrorTint * seen + glint * material.highlight + glow;
    if (frame.arcLight.g > 0.0)
        light += mirrorBrightness * mirrorTint * arcMirrored(toArc, mirrored, kLiquidLobe * pow(kSolidLobe / kLiquidLobe, dullness));
    colour = finish(light, 1.0);
}
