// The room around the metal, seen from the metal's origin: a workshop with windows, ceiling lamps, a soft box, benches
// and gas bottles, lit by the lamps without shadows but darkened near edges between objects.
#ifndef MELTPOOL_RENDER_WORKSHOP_GLSL
#define MELTPOOL_RENDER_WORKSHOP_GLSL

#include "render/workshop_things.glsl"

struct Hit {
    float distance;
    vec3 normal;
    int thing; // 0: the room itself, else a number of kThings + 1
};

float hash2(vec2 p) {
    vec3 q = fract(vec3(p.xyx) * 0.1031);
    q += dot(q, q.yzx + 33.33);
    return fract((q.x + q.y) * q.z);
}

float cellNoise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell;
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash2(cell), hash2(cell + vec2(1, 0)), f.x),
               mix(hash2(cell + vec2(0, 1)), hash2(cell + vec2(1, 1)), f.x), f.y);
}

float grain(vec2 p) {
    return 0.5 * cellNoise(p) + 0.3 * cellNoise(p * 2.3 + 7.1) + 0.2 * cellNoise(p * 5.1 + 3.7);
}

void hitThing(vec3 from, vec3 way, int i, inout Hit hit) {
    vec3 toLo = (kThings[i].lo - from) / way;
    vec3 toHi = (kThings[i].hi - from) / way;
    vec3 near3 = min(toLo, toHi);
    vec3 far3 = max(toLo, toHi);
    float nearest = max(max(near3.x, near3.y), near3.z);
    float farthest = min(min(far3.x, far3.y), far3.z);
    if (nearest > 0.001 && nearest < farthest && nearest < hit.distance) {
        hit.distance = nearest;
        hit.normal = -sign(way) * vec3(equal(near3, vec3(nearest)));
        hit.thing = i + 1;
    }
}

void hitBottle(vec3 from, vec3 way, int i, inout Hit hit) {
    vec2 centre = kBottleAxis[i];
    float radius = kBottleRadius[i];
    vec2 d = from.xz - centre;
    float a = dot(way.xz, way.xz);
    float b = dot(d, way.xz);
    float root = b * b - a * (dot(d, d) - radius * radius);
    if (root <= 0.0) return;
    float t = (-b - sqrt(root)) / a;
    vec3 at = from + t * way;
    // the shoulder: narrower towards the top
    if (t < 0.001 || t > hit.distance || at.y > kBottleTop[i]) return;
    hit.distance = t;
    hit.normal = vec3((at.xz - centre) / radius, 0.0).xzy;
    hit.thing = kThingCount + 1 + i;
}

Hit trace(vec3 from, vec3 way) {
    vec3 walls = (mix(kRoomMin, kRoomMax, step(0.0, way)) - from) / way;
    Hit hit;
    hit.distance = min(min(walls.x, walls.y), walls.z);
    hit.normal = -sign(way) * vec3(equal(walls, vec3(hit.distance)));
    hit.thing = 0;
    for (int i = 0; i < kThingCount; ++i)
        hitThing(from, way, i, hit);
    for (int i = 0; i < kBottleCount; ++i)
        hitBottle(from, way, i, hit);
    return hit;
}

// Light of the lamp that the ray meets within the distance `nearest`; false if it meets none.
bool seesLamp(vec3 from, vec3 way, float nearest, out vec3 light) {
    light = vec3(0.0);
    for (int i = 0; i < kLampCount; ++i) {
        vec3 normal = cross(kLamps[i].across, kLamps[i].along);
        float t = dot(kLamps[i].centre - from, normal) / dot(way, normal);
        if (t < 0.001 || t > nearest + 0.02) continue;
        vec3 off = from + t * way - kLamps[i].centre;
        vec2 uv = vec2(dot(off, kLamps[i].across) / dot(kLamps[i].across, kLamps[i].across),
                       dot(off, kLamps[i].along) / dot(kLamps[i].along, kLamps[i].along));
        if (max(abs(uv.x), abs(uv.y)) > 1.0) continue;
        light = kLamps[i].light;
        if (i >= 2 && i < 5) {
            // a window: panes between bars, brighter and bluer upwards, roofs across the street
            vec2 pane = abs(fract((uv * 0.5 + 0.5) * vec2(3.0, 4.0)) - 0.5);
            if (max(pane.x, pane.y) > 0.465) {
                light = vec3(0.05, 0.055, 0.06);
            } else {
                float high = uv.y * 0.5 + 0.5;
                float roof = 0.20 + 0.07 * step(0.5, fract(off.z * 0.9 + float(i) * 0.37)) + 0.04 * cellNoise(vec2(off.z * 6.0, i));
                light *= mix(vec3(1.0, 0.96, 0.9), vec3(0.78, 0.92, 1.06), high);
                if (high < roof) light = vec3(0.55, 0.5, 0.47) * (0.7 + 0.6 * cellNoise(vec2(off.z * 9.0, high * 30.0)));
            }
        } else if (i < 2) {
            // two tubes behind a prismatic cover
            light *= 0.72 + 0.38 * exp(-pow((abs(uv.x) - 0.45) * 4.0, 2.0));
            light *= 0.3 + 0.7 * smoothstep(1.0, 0.94, abs(uv.y));
        } else {
            // the soft box: brightest in the middle, black frame
            light *= 1.12 - 0.35 * dot(uv, uv);
            if (max(abs(uv.x), abs(uv.y)) > 0.95) light = vec3(0.02);
        }
        return true;
    }
    return false;
}

// Irradiance over pi at a place, from every lamp as four point lamps with their own facing.
vec3 lampLight(vec3 at, vec3 normal) {
    vec3 sum = vec3(0.045, 0.05, 0.058);
    for (int i = 0; i < kLampCount; ++i) {
        vec3 face = cross(kLamps[i].across, kLamps[i].along);
        float area = 4.0 * length(face);
        face = normalize(face);
        if (dot(face, kLamps[i].centre) > 0.0) face = -face; // lamps look into the room
        for (int part = 0; part < 4; ++part) {
            vec2 s = vec2((part & 1) - 0.5, (part >> 1) - 0.5);
            vec3 to = kLamps[i].centre + kLamps[i].across * s.x + kLamps[i].along * s.y - at;
            float far2 = dot(to, to) + 0.05;
            vec3 way = to * inversesqrt(far2);
            float wrap = max(0.0, dot(normal, way) * 0.9 + 0.1);
            sum += kLamps[i].light * (wrap * max(0.0, -dot(face, way)) * area / (4.0 * 3.14159 * far2));
        }
    }
    return sum;
}

// Ambient occlusion near corners of the room and near objects, 0..1.
float nearness(vec3 at, vec3 normal) {
    vec3 toLo = at - kRoomMin;
    vec3 toHi = kRoomMax - at;
    vec3 gap = min(toLo, toHi) + 10.0 * abs(normal);
    float open = (1.0 - 0.45 * exp(-gap.x * 2.5)) * (1.0 - 0.45 * exp(-gap.y * 2.5)) * (1.0 - 0.45 * exp(-gap.z * 2.5));
    for (int i = 0; i < kThingCount; ++i) {
        vec3 middle = 0.5 * (kThings[i].lo + kThings[i].hi);
        vec3 half3 = 0.5 * (kThings[i].hi - kThings[i].lo);
        vec3 outside = abs(at + normal * 0.12 - middle) - half3;
        float away = length(max(outside, 0.0)) + min(0.0, max(max(outside.x, outside.y), outside.z));
        open *= 1.0 - 0.7 * exp(-max(away, 0.0) * 5.0) * step(0.001, away);
    }
    for (int i = 0; i < kBottleCount; ++i) {
        float away = length(at.xz - kBottleAxis[i]) - kBottleRadius[i];
        if (at.y < kBottleTop[i]) open *= 1.0 - 0.5 * exp(-max(away, 0.0) * 8.0) * step(0.001, away);
    }
    return open;
}

vec3 wallColour(vec3 at, vec3 normal) {
    vec2 uv = abs(normal.x) > 0.5 ? at.zy : at.xy;
    float stain = 0.86 + 0.28 * grain(uv * 1.3);
    vec3 upper = vec3(0.40, 0.39, 0.37);
    vec3 lower = vec3(0.055, 0.085, 0.11);
    vec3 colour = mix(lower, upper, smoothstep(-0.012, 0.012, at.y - 0.0));
    colour = mix(colour, vec3(0.62, 0.42, 0.03), step(abs(at.y - 0.03), 0.03)); // the line between the two coats
    if (normal.z < -0.5 && at.x > -2.6 && at.x < -0.3 && at.y < 1.3) {
        // welding curtain: deep orange folds
        float fold = 0.5 + 0.5 * sin(at.x * 21.0 + 1.5 * sin(at.x * 3.1));
        return vec3(0.55, 0.11, 0.015) * (0.35 + 0.65 * fold);
    }
    if (normal.x < -0.5 && at.z > 1.7 && at.z < 3.0 && at.y < 0.85) {
        // roller door
        return vec3(0.30, 0.31, 0.32) * (0.75 + 0.25 * smoothstep(0.0, 0.3, abs(fract(at.y * 7.0) - 0.5)));
    }
    return colour * stain;
}

vec3 floorColour(vec3 at) {
    float stain = grain(at.xz * 0.9) * 0.7 + grain(at.xz * 6.0) * 0.3;
    vec3 colour = vec3(0.15, 0.148, 0.142) * (0.6 + 0.8 * stain);
    vec2 seam = abs(fract(at.xz / 2.1 + 0.37) - 0.5) * 2.1;
    colour *= 1.0 - 0.55 * smoothstep(0.02, 0.008, 1.05 - max(seam.x, seam.y));
    vec2 lane = abs(at.xz - vec2(0.0, 0.3)) - vec2(2.6, 2.2);
    float edge = max(lane.x, lane.y);
    if (abs(edge) < 0.05) colour = mix(colour, vec3(0.60, 0.40, 0.03), 0.55 + 0.3 * cellNoise(at.xz * 12.0));
    return colour;
}

vec3 ceilingColour(vec3 at) {
    float rib = step(abs(fract(at.z / 1.25) - 0.5) * 1.25, 0.09);
    float joist = step(abs(fract(at.x / 2.8 + 0.5) - 0.5) * 2.8, 0.05);
    return mix(vec3(0.16, 0.165, 0.17), vec3(0.05, 0.052, 0.055), max(rib, joist)) * (0.9 + 0.2 * grain(at.xz));
}

vec3 thingColour(vec3 at, vec3 normal, int thing) {
    if (thing > kThingCount) {
        int bottle = thing - kThingCount - 1;
        float below = kBottleTop[bottle] - at.y;
        return below < 0.22 ? kBottleColours[bottle] * 2.6 : kBottleColours[bottle]; // painted shoulder
    }
    vec3 colour = kThings[thing - 1].colour;
    if (thing == 2 || thing == 3 || thing == 13) {
        // drawers with bright handles
        float row = fract((at.y + 1.25) / 0.178);
        if (row < 0.06) colour *= 0.25;
        float middle = 0.5 * (kThings[thing - 1].lo.x + kThings[thing - 1].hi.x);
        if (normal.z > 0.5 && abs(at.x - middle) < 0.22 && abs(row - 0.75) < 0.07) colour = vec3(0.6);
    } else if (thing == 5 && normal.z > 0.5) {
        // tools hanging on the pegboard: dark bars of different lengths with coloured grips
        float slot = floor(at.x / 0.17);
        float across = abs(fract(at.x / 0.17) - 0.5);
        float foot = 0.72 - 0.5 * hash2(vec2(slot, 3.0));
        float wide = 0.10 + 0.15 * hash2(vec2(slot, 9.0));
        if (across < wide && at.y < 0.84 && at.y > foot) {
            vec3 grip = hash2(vec2(slot, 5.0)) > 0.5 ? vec3(0.45, 0.05, 0.03) : vec3(0.03, 0.09, 0.30);
            colour = at.y < foot + 0.16 ? grip : vec3(0.13, 0.135, 0.14);
        }
        vec2 hole = fract(at.xy / 0.05) - 0.5;
        if (dot(hole, hole) < 0.02) colour *= 0.4;
    } else if (thing == 10 && normal.x < -0.5) {
        float door = fract((at.z + 2.4) / 0.6);
        if (min(door, 1.0 - door) < 0.03) colour *= 0.3;
        if (abs(door - 0.5) < 0.2 && at.y > 0.4 && fract(at.y * 20.0) < 0.4) colour *= 0.3;
    } else if (thing == 11) {
        if (normal.x < -0.5 && at.y > -0.72) colour = vec3(0.03); // the machine's front with its dials
        vec2 dial = vec2(at.z - 0.8, at.y + 0.6);
        if (normal.x < -0.5 && length(abs(dial) - vec2(0.13, 0.0)) < 0.06) colour = vec3(0.55);
    }
    return colour;
}

vec3 shadeRoom(vec3 at, vec3 normal, int thing) {
    vec3 colour = thing > 0          ? thingColour(at, normal, thing)
                  : normal.y > 0.5   ? floorColour(at)
                  : normal.y < -0.5  ? ceilingColour(at)
                                     : wallColour(at, normal);
    return colour * lampLight(at, normal) * nearness(at, normal);
}

// Mirror image in paint and floor: exact lamps, but only a rough colour by height for everything else.
vec3 mirroredRoom(vec3 from, vec3 way) {
    Hit hit = trace(from, way);
    vec3 light;
    if (seesLamp(from, way, hit.distance, light)) return light;
    float high = from.y + way.y * hit.distance;
    return hit.thing > 0 ? vec3(0.05) : mix(vec3(0.02, 0.03, 0.04), vec3(0.15, 0.15, 0.145), step(0.0, high));
}

// Light that reaches the origin from direction `way`; white paper under the lamps is about 1.
vec3 workshop(vec3 way) {
    Hit hit = trace(vec3(0.0), way);
    vec3 light;
    if (seesLamp(vec3(0.0), way, hit.distance, light)) return light;
    light = shadeRoom(way * hit.distance, hit.normal, hit.thing);
    float shine = hit.thing > kThingCount ? 0.3
                  : hit.thing > 0         ? kThings[hit.thing - 1].shine
                  : hit.normal.y > 0.5    ? 0.22
                                          : 0.0;
    if (shine > 0.0) {
        // sealed floor and paint mirror a little, more at grazing angles
        vec3 at = way * hit.distance;
        vec3 bent = hit.normal;
        if (hit.normal.y > 0.5) bent = normalize(bent + 0.02 * vec3(grain(at.xz * 3.0) - 0.5, 0.0, grain(at.zx * 3.0) - 0.5));
        float glance = pow(1.0 - max(0.0, -dot(way, bent)), 4.0);
        vec3 mirrored = mirroredRoom(at + hit.normal * 0.01, reflect(way, bent));
        light += mirrored * shine * (0.25 + 1.6 * glance);
    }
    return light;
}

#endif
