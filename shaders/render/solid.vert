// A vertex of a painted solid: heat source, torch, table. MANY_AT_ONCE: all solids of a shape are one draw call.
// ON_TABLE: things around the workpiece, which blocks light from them. They cover most of a picture and are dull or
// small: their visible light is computed here.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#ifdef ON_TABLE
#include "render/arc.glsl"
#include "render/environment.glsl"
#include "render/lamp_shadow.glsl"
#include "render/table_shadow.glsl"
#endif

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 outward;
#ifdef MANY_AT_ONCE
layout(location = SOLID_PLACE_ATTRIBUTE) in mat4 solidToWorld;
layout(location = SOLID_PAINT_ATTRIBUTE) in vec4 paintAndGloss;
layout(location = SOLID_GLOW_ATTRIBUTE) in vec3 emitted;
#else
layout(location = 1) uniform mat4 solidToWorld;
#endif

layout(location = 0) out vec3 normal;
layout(location = 1) out vec3 way;
layout(location = 2) out vec3 toLamp;
layout(location = 3) out vec3 toArc;
#ifdef MANY_AT_ONCE
layout(location = 4) flat out vec4 paint;
layout(location = 5) flat out vec3 glow;
#endif
#ifdef ON_TABLE
layout(location = 6) out vec3 seen; // light towards the eye

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

// Radius of the lamp's disc as the table sees it, model units: three times its own, so that no shadow's edge is narrower than
// the table's corners are apart.
const float kTableLampRadius = 3.0 * kLampRadius;

float lampPastTorchWidely(vec3 world) {
    float share = 1.0;
    for (int i = 0; i < frame.torchPartCount; ++i)
        share *= lampPast(frame.torchParts[i], world, toLamp, kTableLampRadius * frame.modelUnit);
    return share;
}

// Light of the table, computed for each vertex as solid.frag does for each pixel.
vec3 seenOnTable(vec3 world, vec3 n) {
    vec3 colour = paintAndGloss.rgb;
    float gloss = paintAndGloss.a, sharpness = mix(8.0, 80.0, gloss);
    vec3 mirrored = reflect(normalize(way), n), lamp = normalize(toLamp);
    float glance = pow(clamp(1.0 - dot(mirrored, n), 0.0, 1.0), 5.0), mirrors = gloss * mix(0.12, 0.9, glance);
    vec3 image = decodeEnvironment(textureLod(roughEnvironment, mirrored, mix(5.0, 0.0, gloss)).rgb);
    float open = openBesideWorkpiece(world), facing = max(dot(n, lamp), 0.0), passed = 0.0;
    if (facing > 0.0) passed = lampPastTorchWidely(world) * lampBesideWorkpiece(world, toLamp);
    vec3 light = (frame.ambient * open + frame.diffuse * facing * passed) * colour + image * open * mirrors;
    light += frame.specular * gloss * passed * pow(max(dot(mirrored, lamp), 0.0), sharpness);
    if (frame.arcLight.g > 0.0) {
        vec3 arc = arcDiffuse(toArc, n) * colour + arcMirrored(toArc, mirrored, sharpness) * mirrors;
        light += arc * arcBesideWorkpiece(toArc);
    }
    return light + emitted;
}
#endif

void main() {
    vec3 world = (solidToWorld * vec4(position, 1.0)).xyz;
    normal = transpose(inverse(mat3(solidToWorld))) * outward;
    way = world - frame.views[viewIndex()].eye;
    toLamp = frame.lamp - world;
    toArc = frame.arc - world;
#ifdef MANY_AT_ONCE
    paint = paintAndGloss;
    glow = emitted;
#endif
#ifdef ON_TABLE
    seen = seenOnTable(world, normalize(normal));
#endif
    showAt(toClip(world));
}
