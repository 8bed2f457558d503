// Solder, copper, gold and any other opaque metal: (diffuse + ambient) * mix(material, mirror image, share) + specular.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 mirrored;
layout(location = 1) in vec3 body;
layout(location = 2) in float mirrorBrightness;
layout(location = 6) in float dullness;
layout(location = 0) out vec4 colour;

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

// Levels of the environment. Not 0 even for the liquid: a sharper mirror image would show the triangles.
const float kLiquidLevel = 1.0;
const float kSolidLevel = 3.0;

// Solid and liquid metal have a whole level each. The difference that interpolation adds to the solid's dullness is rounded
// away. SYNCHRONOUS_DRIVER: between two levels it reads both.
float levelAt(float dull) {
    float solid = floor(mix(kLiquidLevel, kSolidLevel, frame.dullness) + 0.5);
    float level = mix(kLiquidLevel, solid, dull / max(frame.dullness, 1e-3));
    return floor(64.0 * level + 0.5) / 64.0;
}

void main() {
    float level = levelAt(dullness);
    vec3 seen = decodeEnvironment(textureLod(roughEnvironment, mirrored, level).rgb);
    float towardsLamp = max(dot(normalize(mirrored), frame.lampDirection), 0.0);
    float glint = frame.specular * (1.0 - 0.65 * dullness) * pow(towardsLamp, frame.shininess * (1.0 - 0.8 * dullness));
    colour = finish(body + mirrorBrightness * material.mirrorColour * seen + glint * material.highlight, 1.0);
}
