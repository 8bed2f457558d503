// Common code of ice and wax: refraction of light through the body.
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
    vec3 exitDirection; // world, behind the body
    float distance;     // distance inside the body, in widths of the classic cube
    vec3 inside;        // world direction inside the body, unit
};

// Share of light reflected by a surface of refractive index `index` (Schlick 1994).
float mirrorShare(float cosine, float index) {
    float straight = (index - 1.0) / (index + 1.0);
    straight *= straight;
    return straight + (1.0 - straight) * pow(clamp(1.0 - cosine, 0.0, 1.0), 5.0);
}

struct FarSide {
    vec3 normal;    // world, unit
    float distance; // distance from the eye; 0: no far side here
};

// The far side of the body at a position 0..1 of this view. The views are side by side in one texture; clamping
// confines the lookup to the own column.
FarSide farSide(vec2 inView) {
    vec2 border = 0.5 / frame.views[view].size;
    inView = clamp(inView, border, 1.0 - border);
    vec4 texel = texture(backSide, vec2((float(view) + inView.x) / frame.viewCount, inView.y));
    return FarSide(texel.xyz, texel.w);
}

// Two refractions, at this pixel and where the refracted ray leaves through the far side (Wyman 2005, "An approximate
// image-space approach for interactive refraction"): the distance inside is that of the straight ray, the far normal
// comes from the projected end of the refracted ray.
Passage passThrough(vec3 along, vec3 n, float index) {
    ViewData eye = frame.views[view];
    vec2 here = (gl_FragCoord.xy - eye.corner) / eye.size;
    float straight = max(farSide(here).distance - length(way), 0.0);
    Passage p;
    p.inside = refract(along, n, 1.0 / index);
    vec4 end = eye.worldToClip * vec4(eye.eye + way + p.inside * straight, 1.0);
    FarSide exit = farSide(end.xy / end.w * 0.5 + 0.5);
    vec3 farNormal = exit.distance > 0.0 ? normalize(exit.normal) : -n;
    p.distance = straight / frame.modelUnit * frame.perCubeWidth;
    p.exitDirection = refract(p.inside, -farNormal, index);
    if (dot(p.exitDirection, p.exitDirection) < 0.5) p.exitDirection = reflect(p.inside, -farNormal); // total reflection
    return p;
}

vec3 environmentAt(vec3 direction, float level) {
    return decodeEnvironment(textureLod(roughEnvironment, direction, level).rgb);
}

// Mean light from all directions on a surface with normal `n`.
vec3 skyLight(vec3 n) {
    return environmentAt(n, float(ENVIRONMENT_LEVELS - 1));
}

#endif
