// A vertex of metal with a temperature in kelvin: as metal.vert, with temper colours. Values that jump at the melting
// point are computed for each pixel, with ROUGH_LOBES the temper colours too. POOL: only triangles with a liquid corner
// are drawn, over the others. TORCH_SHADOW, ROUGH_LOBES, MILL_SCALE, RIPPLES (only with ROUGH_LOBES): see
// core/render/look/measures.hpp.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/arc.glsl"
#include "render/hot.glsl"
#include "render/lamp_shadow.glsl"
#ifdef MILL_SCALE
#include "render/mill_scale.glsl"
#endif
#include "render/reflectance.glsl"
#ifdef RIPPLES
#include "render/ripples.glsl"
#endif

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature; // K
layout(location = PEAK_ATTRIBUTE) in float peak; // highest temperature so far, K

#ifdef RIPPLES
layout(location = FREEZING_ATTRIBUTE) in vec4 freezing; // slope of the time, s per model unit; the time, s
layout(location = FROZEN_ATTRIBUTE) in float frozen;    // share of the metal around
layout(location = 9) out vec3 rippleSlope;              // world; of the first harmonic where it is steepest
layout(location = 10) out float cycles;                 // cycles of the ripples' wave since the start
#endif

#ifdef ROUGH_LOBES
layout(location = 0) out vec3 normal;        // world, not unit
layout(location = 1) out vec3 way;           // world, from the eye to the vertex
layout(location = 7) flat out int view;
layout(location = 8) out vec2 solidShares;   // shares of an even room, see mirroredShare(), while it is solid
layout(location = 2) out vec3 lit;           // light that falls on it
layout(location = 3) out float hottest;      // highest temperature so far, K: temper colours are those of each pixel
#ifdef MILL_SCALE
layout(location = 11) out float milled;      // share under the scale of rolling
#endif
#else
layout(location = 0) out vec3 mirrorWay;     // world direction that the eye sees in the metal, not unit
layout(location = 1) out vec3 toArc;         // world
layout(location = 2) out vec3 diffuse;       // light that the metal scatters evenly while it is solid
layout(location = 3) out vec3 solidMirrored; // share of the room's light that it mirrors while it is solid
layout(location = 5) out float emissivity;   // while it is solid
#endif
layout(location = 4) out float temperature;  // K
layout(location = 6) out float lampLight;

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    vec3 fromEye = world - frame.views[viewIndex()].eye;
    vec3 toLamp = frame.lamp - world;
    float lamp = frame.diffuse * max(dot(n, normalize(toLamp)), 0.0);
#ifdef TORCH_SHADOW
    lamp *= lampPastTorch(world, toLamp);
#endif
    lampLight = frame.ambient + lamp;

    vec3 falling = vec3(lampLight);
    if (frame.arcLight.g > 0.0) falling += arcDiffuse(frame.arc - world, n);
#ifdef MILL_SCALE
    float rolled = millScaleAt(position, outward);
#else
    const float rolled = 0.0;
#endif
#ifdef ROUGH_LOBES
#ifdef MILL_SCALE
    milled = rolled;
#endif
    lit = falling;
    normal = n;
    way = fromEye;
    view = viewIndex();
    float cosine = max(-dot(n, normalize(way)), 0.0);
    solidShares = roomShares(solidRoughness(), cosine);
    hottest = peak;
#else
    vec3 reflectance = solidReflectance(vertexTemperature, peak, rolled);
    diffuse = falling * (1.0 - material.solidMirror) * reflectance;
    emissivity = solidEmissivity(vertexTemperature, peak, rolled);
    solidMirrored = material.solidMirror * reflectance;
    mirrorWay = reflect(fromEye, n);
    toArc = frame.arc - world;
#endif
    temperature = vertexTemperature;
#ifdef RIPPLES
    cycles = material.rippleFrequency * freezing.w;
    // The time of barely frozen metal is that of the metal beside it: the bead's edge has none.
    rippleSlope = mat3(frame.modelToWorld) * rippleSlopeOf(freezing.xyz) * (smoothstep(0.3, 0.7, frozen) / frame.modelUnit);
#endif
#ifdef POOL
    gl_CullDistance[0] = vertexTemperature - frame.solidus;
#endif
    showCut(world);
}
