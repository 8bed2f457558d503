// A painted solid: mirrors a little and may emit light. ON_TABLE: the vertex shader computes its light. TORCH_SHADOW:
// see core/render/look/measures.hpp.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/arc.glsl"
#include "render/environment.glsl"
#include "render/lamp_shadow.glsl"
#include "render/tone.glsl"

layout(location = 0) out vec4 colour;

#ifdef ON_TABLE
layout(location = 6) in vec3 seen;

void main() {
    colour = finish(seen, 1.0);
}
#else
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 2) in vec3 toLamp;
layout(location = 3) in vec3 toArc;
layout(location = 4) flat in vec4 paint; // linear colour, gloss 0..1
layout(location = 5) flat in vec3 glow;  // emitted light

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

void main() {
    float gloss = paint.a, sharpness = mix(8.0, 80.0, gloss);
    vec3 n = normalize(normal);
    vec3 lamp = normalize(toLamp);
    vec3 mirrored = reflect(normalize(way), n);
    vec3 image = decodeEnvironment(textureLod(roughEnvironment, mirrored, mix(5.0, 0.0, gloss)).rgb);
    float glance = pow(clamp(1.0 - dot(mirrored, n), 0.0, 1.0), 5.0), mirrors = gloss * mix(0.12, 0.9, glance);
    float direct = frame.diffuse * max(dot(n, lamp), 0.0);
#ifdef TORCH_SHADOW
    direct *= lampPastTorch(frame.lamp - toLamp, toLamp);
#endif
    float light = frame.ambient + direct;
    float highlight = frame.specular * gloss * pow(max(dot(mirrored, lamp), 0.0), sharpness);
    vec3 seen = light * paint.rgb + image * mirrors + highlight + glow;
    if (frame.arcLight.g > 0.0) {
        vec3 arc = arcDiffuse(toArc, n) * paint.rgb + arcMirrored(toArc, mirrored, sharpness) * mirrors;
        seen += arc * arcBesideWorkpiece(toArc);
    }
    colour = finish(seen, 1.0);
}
#endif
