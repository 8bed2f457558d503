// A puff of smoke: it scatters the light of arc and room and hides a little of its background. Its billows are a noise
// in space, equal for both eyes.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/haze.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 place;
layout(location = 1) in vec3 inside;
layout(location = 2) in vec2 at;
layout(location = 3) flat in vec3 eye;
layout(location = 4) flat in float radius;
layout(location = 5) flat in vec3 grain;
layout(location = 6) flat in float depth;
layout(location = 7) flat in float arcSeen;
layout(location = 0) out vec4 colour; // light times cover, cover

layout(location = 5) uniform vec3 pool;      // model units
layout(location = 6) uniform float tableTop; // world height

layout(binding = NOISE_UNIT) uniform sampler3D noise;

// Share of the light taken by smoke that it scatters. Fume is oxides finer than light's waves: it scatters blue most.
const vec3 kScatters = vec3(0.80, 0.85, 0.90);
// m beside the line from the eye to the pool: within the first no smoke is drawn, beyond the second all of it.
const float kPoolClear = 0.012, kPoolWhole = 0.035;
// Texels of the noise a radius, of large billows and of small ones.
const float kLarge = 1.1, kSmall = 2.6;
// Between its billows a puff has this share of its mean depth.
const float kThin = 0.15;

// The noise without the creases that linear sampling leaves at texels.
float smoothNoise(vec3 texels) {
    vec3 whole = floor(texels), part = texels - whole;
    return texture(noise, (whole + part * part * (3.0 - 2.0 * part) + 0.5) / 32.0).r;
}

// Optical depth as a share of the mean over the ellipse. Without billows it is 3 (1 - r²)², soft at the edge.
float billows(float square) {
    float large = smoothNoise(grain + inside * kLarge);
    float small = smoothNoise(grain.zxy + inside * kSmall + large);
    float body = 1.0 - square;
    return 3.0 * body * body * mix(kThin, 2.0 - kThin, smoothstep(0.2, 0.8, mix(large, small, 0.4)));
}

// Distance along the ray (unit) from the eye to the side of a torch part; far away: no hit.
float wayToPart(TorchPart part, vec3 ray) {
    vec3 axis = part.to - part.from, start = eye - part.from;
    float whole = dot(axis, axis), turned = dot(axis, ray), along = dot(axis, start);
    // Components across the axis, both times its squared length: of the ray, and of its start.
    float a = whole - turned * turned, b = whole * dot(start, ray) - along * turned;
    float c = whole * (dot(start, start) - part.radius * part.radius) - along * along;
    float root = b * b - a * c, way = (-b - sqrt(max(root, 0.0))) / max(a, 1e-12);
    float on = along + way * turned;
    return root > 0.0 && way > 0.0 && on > 0.0 && on < whole ? way : 1e9;
}

// Share of the puff's depth along the ray that is before workpiece, table and torch: it ends softly at their surfaces.
float beforeThings(vec3 ray, float far, float half_) {
    mat3 toModel = transpose(mat3(frame.modelToWorld)) / (frame.modelUnit * frame.modelUnit);
    float free = wayFree(toModel * (eye - frame.modelToWorld[3].xyz), toModel * ray);
    if (ray.y < -1e-6) free = min(free, (tableTop - eye.y) / ray.y);
    for (int i = 0; i < frame.torchPartCount; ++i)
        free = min(free, wayToPart(frame.torchParts[i], ray));
    return smoothstep(0.0, 1.0, (free - far) / half_);
}

void main() {
    float square = dot(at, at);
    if (square >= 1.0) discard;
    vec3 way = place - eye;
    float far = length(way);
    vec3 ray = way / far;
    vec3 toPool = (frame.modelToWorld * vec4(pool, 1.0)).xyz - eye;
    float beside = length(cross(toPool, ray)) / frame.modelUnit;
    float thick = depth * smoothstep(kPoolClear, kPoolWhole, beside);
    if (thick <= 0.0) discard;
    thick *= billows(square) * beforeThings(ray, far, radius * sqrt(1.0 - square));
    float cover = 1.0 - exp(-thick);
    // Its smoke is on average half a radius before or behind the ellipse.
    vec3 toArc = frame.arc - eye - way;
    float apart = (dot(toArc, toArc) + 0.25 * radius * radius) / (frame.modelUnit * frame.modelUnit);
    vec3 lit = arcSeen * frame.arcLight / (12.56637 * max(apart, frame.arcMinDistanceSquared));
    // The lamp's light penetrates it less deeply: the side that faces the lamp is brighter.
    float room = frame.ambient + frame.diffuse * (0.25 + 0.2 * dot(inside, frame.lampDirection));
    vec3 light = kScatters * (lit + room);
    // The tone curve's light is spread over the cover again: a target without linear light then mixes displayed values.
    vec3 toned = toneCurve(light * cover * frame.exposure);
    colour = vec4(encoded(toned / max(cover, 1e-6), cover).rgb * cover, cover);
}
