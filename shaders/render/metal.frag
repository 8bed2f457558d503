// Solder, copper, gold and any other opaque metal: (diffuse + ambient) * mix(material, mirror image, share) + specular.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 mirrored;
layout(location = 1) in vec3 body;
layout(location = 2) in vec2 surface; // x: brightness of the mirror image, y: dullness
layout(location = 0) out vec4 colour;

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

// Levels of the environment. Even the liquid's is not 0: what sharpens the mirror image further shows the mesh.
const float kLiquidLevel = 1.0;
const float kSolidLevel = 3.0;

void main() {
    float dull = surface.y;
    vec3 seen = decodeEnvironment(textureLod(roughEnvironment, mirrored, kLiquidLevel + (kSolidLevel - kLiquidLevel) * dull).rgb);
    float towardsLamp = max(dot(normalize(mirrored), frame.lampDirection), 0.0);
    float glint = frame.specular * (1.0 - 0.65 * dull) * pow(towardsLamp, frame.shininess * (1.0 - 0.8 * dull));
    colour = finish(body + surface.x * material.mirrorColour * seen + glint * material.highlight, 1.0);
}
