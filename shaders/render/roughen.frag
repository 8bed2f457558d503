// One face of a level of the environment: the mirror image in a surface of this roughness, by the split-sum approximation
// with the GGX lobe (Karis 2013, "Real shading in Unreal Engine 4"), view along the normal. Roughness 0 only encodes the
// painted light.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 colour;

layout(binding = SHARP_UNIT) uniform samplerCube source; // linear light, with box-filtered mipmaps
layout(location = 0) uniform int face;
layout(location = 1) uniform float roughness;
layout(location = 2) uniform float sourceSize; // texels of an edge of level 0

const int kMostSamples = 64;

float radicalInverse(uint bits) {
    return float(bitfieldReverse(bits)) * 2.3283064365386963e-10;
}

void main() {
    vec3 normal = normalize(faceDirection(face, place));
    if (roughness <= 0.0) {
        colour = vec4(encodeEnvironment(textureLod(source, normal, 0.0).rgb, gl_FragCoord.xy), 1.0);
        return;
    }
    vec3 up = abs(normal.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    vec3 across = normalize(cross(up, normal));
    vec3 along = cross(normal, across);
    float a = roughness * roughness;
    int samples = int(mix(12.0, float(kMostSamples), min(2.0 * roughness, 1.0))); // a narrow lobe needs fewer
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 u = vec2((float(i) + 0.5) / float(samples), radicalInverse(uint(i)));
        float cosine = sqrt((1.0 - u.y) / (1.0 + (a * a - 1.0) * u.y));
        float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
        vec3 middle = across * (sine * cos(6.2831853 * u.x)) + along * (sine * sin(6.2831853 * u.x)) + normal * cosine;
        vec3 way = 2.0 * cosine * middle - normal;
        float weight = dot(normal, way);
        if (weight <= 0.0) continue;
        // a sample covers the solid angle 1 / (samples * pdf); read the level whose texels are that wide
        float d = (cosine * cosine) * (a * a - 1.0) + 1.0;
        float pdf = a * a / (3.14159265 * d * d) * 0.25;
        float level = 0.5 * log2(6.0 * sourceSize * sourceSize / (4.0 * 3.14159265 * float(samples) * pdf)) + 1.0;
        sum += textureLod(source, way, max(level, 0.0)).rgb * weight;
        weights += weight;
    }
    colour = vec4(encodeEnvironment(sum / weights, gl_FragCoord.xy), 1.0);
}
