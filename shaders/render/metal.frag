// Solder, copper, gold and any other opaque metal: (diffuse + ambient) * mix(material, mirror image, share) + specular.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"
#include "render/metal_look.glsl"

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 3) in float temperature;
layout(location = 4) in vec3 toLamp;
layout(location = 0) out vec4 colour;

layout(binding = SHARP_UNIT) uniform samplerCube sharpEnvironment;
layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

const float kSolidLevel = 1.0; // of the rough environment

void main() {
    vec3 n = normalize(normal);
    vec3 lamp = normalize(toLamp);
    vec3 mirrored = reflect(normalize(way), n);
    vec2 share = meltShares(temperature);
    float dull = frame.detail.x * (1.0 - share.y);

    vec3 image = mix(decodeEnvironment(texture(sharpEnvironment, mirrored).rgb),
                     decodeEnvironment(textureLod(roughEnvironment, mirrored, kSolidLevel).rgb), dull);
    vec3 metal = mix(materialColour(share.x), image * material.mirror.rgb,
                     mix(material.solid.w, material.liquid.w, share.y));
    float shininess = frame.phong.w * (1.0 - 0.8 * dull);
    float highlight = frame.phong.z * (1.0 - 0.65 * dull) * pow(max(dot(mirrored, lamp), 0.0), shininess);
    float light = frame.phong.x + frame.phong.y * max(dot(n, lamp), 0.0);
    colour = finish(light * metal + highlight * mix(vec3(1.0), material.mirror.rgb, 0.7), 1.0);
}
