// Metal with a temperature in kelvin: mirrors its surroundings and glows. At the melting point it turns from dull and
// bright to mirroring and darker: this shows a welder the pool's edge.
// POOL: liquid metal mirrors torch and workpiece too. Solid metal is too dull to show more than the room.
// SYNCHRONOUS_DRIVER: another program and no branch, of which it computes both sides.
// ROUGH_LOBES: lamp, arc and room are mirrored as by rough metal; else by Phong's lobes.
// SPECULAR_AA: highlights are as wide as the normals within a pixel make them.
// RIPPLES, only with ROUGH_LOBES: solid metal has the ripples of its freezing.
// MILL_SCALE: rolled faces are under scale. FLOATING_OXIDE, only with POOL: liquid metal carries islands that look like
// scale.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/arc.glsl"
#include "render/environment.glsl"
#include "render/hot.glsl"
#include "render/reflectance.glsl"
#include "render/specular_aa.glsl"
#ifdef FLOATING_OXIDE
#include "render/oxide.glsl"
#endif
#ifdef RIPPLES
#include "render/ripples.glsl"
#endif
#include "render/tone.glsl"
#include "render/torch_parts.glsl"

#ifdef ROUGH_LOBES
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 7) flat in int view;
layout(location = 8) in vec2 solidShares;
layout(location = 2) in vec3 lit;
layout(location = 3) in float hottest;
#ifdef MILL_SCALE
layout(location = 11) in float milled;
#else
const float milled = 0.0;
#endif
#else
layout(location = 0) in vec3 mirrorWay;
layout(location = 1) in vec3 toArc;
layout(location = 2) in vec3 diffuse;
layout(location = 3) in vec3 solidMirrored;
layout(location = 5) in float emissivity;
#endif
layout(location = 4) in float temperature;
layout(location = 6) in float lampLight;
#ifdef RIPPLES
layout(location = 9) in vec3 rippleSlope;
layout(location = 10) in float cycles;
#endif
layout(location = 0) out vec4 colour;

layout(binding = ROUGH_UNIT) uniform samplerCube roughEnvironment;

#ifdef ROUGH_LOBES
// The arc's mirror image: its ball widens the lobe. `share`: of an even room that the lobe holds.
vec3 arcImage(vec3 n, vec3 toEye, vec3 mirrored, float roughness, float share) {
    vec3 toArc = frame.arc - frame.views[view].eye - way;
    float perDistance = inversesqrt(max(dot(toArc, toArc), 1e-12));
    vec3 towards = toArc * perDistance;
    float alpha = roughness * roughness;
    float ball = 0.5 * frame.modelUnit * perDistance * sqrt(frame.arcMinDistanceSquared); // half its angle: of half vectors
    alpha = min(sqrt(alpha * alpha + ball * ball), 1.0);
    float lobe = mirrorLobe(max(dot(n, normalize(towards + toEye)), 0.0), max(dot(n, towards), 0.0),
                            max(dot(n, toEye), 1e-3), alpha);
    return arcOn(toArc) * (3.14159265 * lobe / share) * mirrored;
}

#ifdef RIPPLES
// Light that a surface scatters with normal `n` over that with normal `flat_`, which was computed for its vertices. For
// little light, no more than a share of that of a surface that faces lamp and arc: the quotient of two small numbers
// would show the coarseness of the vertices.
float litOverFlat(vec3 n, vec3 flat_) {
    vec3 toArc = frame.arc - frame.views[view].eye - way;
    float arc = frame.arcLight.g > 0.0 ? arcOn(toArc).g : 0.0;
    vec3 towards = toArc * inversesqrt(max(dot(toArc, toArc), 1e-12));
    vec2 fromLamp = max(vec2(dot(n, frame.lampDirection), dot(flat_, frame.lampDirection)), 0.0);
    vec2 fromArc = max(vec2(dot(n, towards), dot(flat_, towards)), 0.0);
    const float kLeast = 0.2;
    vec2 lit = frame.ambient + frame.diffuse * (fromLamp + kLeast) + arc * (fromArc + kLeast);
    return lit.x / max(lit.y, 1e-4);
}
#endif

// The metal's own normal, unit, world. `scattered`: light that it scatters, over that without ripples.
vec3 shownNormal(float liquid, out float scattered) {
    vec3 n = normalize(normal);
    scattered = 1.0;
#ifdef RIPPLES
    vec3 smooth_ = n;
    n = bentNormal(n, rippleSlope * (waveSlope(cycles) * rippleSeen(vec2(dFdx(cycles), dFdy(cycles))) * (1.0 - liquid)));
    scattered = litOverFlat(n, smooth_);
#endif
    return n;
}

// Light of lamp, arc and room that solid metal scatters and solid or liquid metal mirrors.
vec3 lightOff(float liquid, vec3 reflectance) {
    float scattered;
    vec3 n = shownNormal(liquid, scattered), toEye = -normalize(way);
    float cosine = max(dot(n, toEye), 0.0);
    float roughness = mix(solidRoughness(), material.liquidRoughness, liquid);
#ifdef SPECULAR_AA
    roughness = calmRoughness(roughness, n);
#endif
    vec3 solidMirrored = material.solidMirror * mirroredShare(reflectance, solidShares);
    vec3 mirrored = mix(solidMirrored, mirroredShare(material.liquidReflectance, smoothShares(cosine)), liquid);
    vec3 towards = reflect(-toEye, n);
    vec3 room = lampLight * decodeEnvironment(textureLod(roughEnvironment, towards, roomLevel(roughness)).rgb);
#ifdef POOL
    room = mix(room, mirroredThings(frame.views[view].eye + way, towards, room), liquid);
#endif
    vec3 light = lit * (1.0 - material.solidMirror) * reflectance * (scattered * (1.0 - liquid)) + mirrored * room;
    float share = mix(solidShares.x + solidShares.y, 1.0, liquid);
    if (frame.arcLight.g > 0.0) light += arcImage(n, toEye, mirrored, roughness, share);
    return light;
}
#else
// Levels of the environment in a liquid and in a rolled or scaled surface. None: chosen.
const vec2 kLevels = vec2(1.0, 3.0);
// Exponent of the arc's image. Rolled metal makes it about as wide, and over its pool the arc's ball is as wide from there.
const float kArcSharpness = 24.0;

vec3 lightOff(float liquid) {
    float dull = frame.dullness * (1.0 - liquid);
    // SYNCHRONOUS_DRIVER: a whole level, because between two it reads both.
    float level = floor(mix(kLevels.x, kLevels.y, dull) + 0.5);
    vec3 seen = lampLight * decodeEnvironment(textureLod(roughEnvironment, mirrorWay, level).rgb);
#ifdef POOL
    seen = mix(seen, mirroredThings(frame.arc - toArc, normalize(mirrorWay), seen), liquid);
#endif
    if (frame.arcLight.g > 0.0) seen += arcMirrored(toArc, mirrorWay, kArcSharpness);
    return diffuse * (1.0 - liquid) + mix(solidMirrored, material.liquidReflectance, liquid) * seen;
}
#endif

void main() {
    float liquid = liquidShare(temperature);
#ifdef FLOATING_OXIDE
#ifdef ROUGH_LOBES
    vec3 world = frame.views[view].eye + way;
#else
    vec3 world = frame.arc - toArc;
#endif
    liquid *= 1.0 - oxideAt(world);
#endif
#ifdef ROUGH_LOBES
    vec3 light = lightOff(liquid, solidReflectance(temperature, hottest, milled));
    float emissivity = solidEmissivity(temperature, hottest, milled);
#else
    vec3 light = lightOff(liquid);
#endif
    light += metalGlow(temperature, mix(emissivity, material.liquidEmissivity, liquid));
    colour = finish(light, 1.0);
}
