// A glowing drop, or a bead that has cooled: the light of its metal, and the light of arc and lamp on it.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/arc.glsl"
#include "render/hot.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec2 place;
layout(location = 1) flat in float reach;
layout(location = 2) flat in float thick;
layout(location = 3) flat in float share;
layout(location = 4) flat in float kelvin;
layout(location = 5) flat in vec3 along;
layout(location = 6) flat in vec3 across;
layout(location = 7) flat in vec3 toEye;
layout(location = 8) flat in vec3 toArc;
layout(location = 0) out vec4 colour; // light times cover, cover

// Reflectance of spatter, which is scale all over. None: chosen, a little brighter than scale on a plate, as it is round.
const float kSpatterGrey = 0.16;

void main() {
    vec2 off = vec2(place.x - clamp(place.x, 0.0, reach), place.y);
    float cover = clamp(thick + 0.5 - length(off), 0.0, 1.0);
    if (cover <= 0.0) discard;
    // The share of the time that the ball covers the place while it flies past: its chord there over its way.
    float chord = sqrt(max(thick * thick - place.y * place.y, 0.0));
    float passes = min(place.x + chord, reach) - max(place.x - chord, 0.0);
    float gathered = share * (reach > 1.0 ? clamp(passes / reach, 0.0, 1.0) : 1.0);
    vec2 onBall = off / thick;
    vec3 n = along * onBall.x + across * onBall.y + toEye * sqrt(max(1.0 - dot(onBall, onBall), 0.0));
    vec3 lit = vec3(frame.ambient + frame.diffuse * max(dot(n, frame.lampDirection), 0.0));
    if (frame.arcLight.g > 0.0) lit += arcDiffuse(toArc, n);
    float emissivity = mix(material.scaledEmissivity, material.liquidEmissivity, liquidShare(kelvin));
    // The light is spread before it is compressed: the eye gathers it on its way.
    vec3 light = metalGlow(kelvin, emissivity * gathered) + kSpatterGrey * gathered * lit;
    colour = finish(light * cover, gathered * cover);
}
