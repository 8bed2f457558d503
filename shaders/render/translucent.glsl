// What ice and wax share: the way of light through the body, from the front surface to where it leaves again.
#ifndef MELTPOOL_RENDER_TRANSLUCENT_GLSL
#define MELTPOOL_RENDER_TRANSLUCENT_GLSL

#include "render/environment.glsl"
#include "render/metal_look.glsl"

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 2) in vec3 place;
layout(location = 3) in float temperature;
layout(location = 4) in vec3 toLamp;
layout(location = 5) flat in int view;
layout(location = 0) out vec4 colour;

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;
layout(binding = BACK_UNIT) uniform sampler2D backSide;
layout(binding = NOISE_UNIT) uniform sampler3D noise;

struct Passage {
    vec3 exitWay;   // world direction behind the body
    float distance; // inside, in widths of the classic cube
    vec3 inside;    // world direction inside, unit
};

// Share of light mirrored by a surface of refractive index `index` (Schlick 1994).
float mirrorShare(float cosine, float index) {
    float straight = (index - 1.0) / (index + 1.0);
    straight *= straight;
    return straight + (1.0 - straight) * pow(clamp(1.0 - cosine, 0.0, 1.0), 5.0);
}

// The far side that this eye sees at a place 0..1 of its view: the views lie side by side, and none looks into its
// neighbour's column.
vec4 farSide(vec2 inView) {
    vec2 border = 0.5 / frame.views[view].size;
    inView = clamp(inView, border, 1.0 - border);
    return texture(backSide, vec2((float(view) + inView.x) / frame.viewCount, inView.y));
}

// Two refractions, at this pixel and where the bent ray leaves through the far side that this eye sees (Wyman 2005, "An
// approximate image-space approach for interactive refraction"): the distance inside is that of the straight ray,
// the far normal is looked up where the bent ray's end is projected to.
Passage passThrough(vec3 along, vec3 n, float index) {
    ViewData eye = frame.views[view];
    vec2 here = (gl_FragCoord.xy - eye.corner) / eye.size;
    float straight = max(farSide(here).w - length(way), 0.0);
    Passage p;
    p.inside = refract(along, n, 1.0 / index);
    vec4 end = eye.worldToClip * vec4(eye.eye + way + p.inside * straight, 1.0);
    vec4 far4 = farSide(end.xy / end.w * 0.5 + 0.5);
    vec3 farNormal = far4.w > 0.0 ? normalize(far4.xyz) : -n;
    p.distance = straight / frame.modelUnit * frame.perCubeWidth;
    p.exitWay = refract(p.inside, -farNormal, index);
    if (dot(p.exitWay, p.exitWay) < 0.5) p.exitWay = reflect(p.inside, -farNormal); // total reflection
    return p;
}

vec3 environmentAt(vec3 direction, float level) {
    return decodeEnvironment(textureLod(roughEnvironment, direction, level).rgb);
}

// Light from all around on a surface that faces `n`.
vec3 skyLight(vec3 n) {
    return environmentAt(n, float(ENVIRONMENT_LEVELS - 1));
}

#endif
