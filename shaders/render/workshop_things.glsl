// The things of the workshop; both its picture from the metal's place (workshop.glsl) and its geometry (room.vert) are
// made from them. Distances in metres, the place of that picture at the origin. Everything is a box or an upright
// cylinder.
#ifndef MELTPOOL_RENDER_WORKSHOP_THINGS_GLSL
#define MELTPOOL_RENDER_WORKSHOP_THINGS_GLSL

#include "shared/render.h"

const vec3 kRoomMin = WORKSHOP_LOW;
const vec3 kRoomMax = WORKSHOP_HIGH;

struct Thing {
    vec3 lo;
    vec3 hi;
    vec3 colour;
    float shine;
};

const int kThingCount = WORKSHOP_BOXES;
const Thing kThings[kThingCount] = Thing[](
    // steel bench along the back wall with its top, a red drawer cabinet in it and the foot of a vice on it
    Thing(vec3(-2.2, -0.36, -3.6), vec3(1.5, -0.28, -2.75), vec3(0.34, 0.25, 0.17), 0.15),
    Thing(vec3(-2.1, -1.25, -3.55), vec3(-1.2, -0.36, -2.85), vec3(0.36, 0.035, 0.03), 0.25),
    Thing(vec3(0.5, -1.25, -3.55), vec3(1.4, -0.36, -2.85), vec3(0.05, 0.07, 0.10), 0.2),
    Thing(vec3(-0.19, -0.28, -3.12), vec3(-0.01, -0.20, -2.94), vec3(0.07, 0.11, 0.15), 0.3),
    // pegboard behind it, shelf over it, boxes on the shelf
    Thing(vec3(-2.0, 0.05, -3.6), vec3(1.3, 0.95, -3.56), vec3(0.42, 0.36, 0.27), 0.02),
    Thing(vec3(-2.0, 1.18, -3.6), vec3(1.3, 1.22, -3.25), vec3(0.16, 0.15, 0.14), 0.1),
    Thing(vec3(-1.8, 1.22, -3.5), vec3(-1.3, 1.48, -3.28), vec3(0.06, 0.16, 0.30), 0.1),
    Thing(vec3(-1.1, 1.22, -3.5), vec3(-0.8, 1.40, -3.28), vec3(0.42, 0.27, 0.05), 0.1),
    Thing(vec3(0.2, 1.22, -3.5), vec3(0.9, 1.52, -3.28), vec3(0.10, 0.10, 0.11), 0.1),
    // tall locker and welding machine on the right, table on the window side
    Thing(vec3(3.5, -1.25, -2.4), vec3(4.2, 0.75, -0.6), vec3(0.10, 0.14, 0.16), 0.2),
    Thing(vec3(3.2, -1.25, 0.5), vec3(3.8, -0.45, 1.1), vec3(0.45, 0.16, 0.02), 0.25),
    Thing(vec3(-4.2, -0.42, 0.2), vec3(-3.3, -0.34, 2.6), vec3(0.30, 0.24, 0.18), 0.15),
    Thing(vec3(-4.15, -1.25, 0.4), vec3(-3.5, -0.42, 0.9), vec3(0.08, 0.09, 0.10), 0.2),
    // the vice: its fixed jaw, its moving jaw, the slide between them and the handle
    Thing(vec3(-0.22, -0.20, -3.10), vec3(0.02, -0.03, -3.02), vec3(0.07, 0.11, 0.15), 0.3),
    Thing(vec3(-0.22, -0.20, -2.93), vec3(0.02, -0.03, -2.86), vec3(0.07, 0.11, 0.15), 0.3),
    Thing(vec3(-0.14, -0.19, -3.02), vec3(-0.06, -0.09, -2.80), vec3(0.20, 0.20, 0.20), 0.5),
    Thing(vec3(-0.23, -0.15, -2.78), vec3(0.03, -0.13, -2.76), vec3(0.30, 0.30, 0.30), 0.6));

// Gas bottles: axis (x and z), radius, height of the top, colour.
const int kBottleCount = WORKSHOP_BOTTLES;
const vec2 kBottleAxis[kBottleCount] = vec2[](vec2(2.5, -3.2), vec2(2.85, -3.15), vec2(3.2, -3.25));
const float kBottleRadius[kBottleCount] = float[](0.13, 0.13, 0.10);
const vec3 kBottleColours[kBottleCount] = vec3[](vec3(0.03, 0.12, 0.06), vec3(0.12, 0.13, 0.14), vec3(0.30, 0.05, 0.03));
const float kBottleTop[kBottleCount] = float[](0.25, 0.25, -0.2);

// A rectangular lamp; `across` and `along` are its half edges.
struct Lamp {
    vec3 centre;
    vec3 across;
    vec3 along;
    vec3 light;
};

const int kLampCount = 6;
const int kSoftBox = 5; // the one lamp that stands free in the room
const Lamp kLamps[kLampCount] = Lamp[](
    Lamp(vec3(-1.3, 2.29, 0.2), vec3(0.28, 0, 0), vec3(0, 0, 1.5), vec3(6.6, 6.2, 5.6)),
    Lamp(vec3(1.5, 2.29, 0.2), vec3(0.28, 0, 0), vec3(0, 0, 1.5), vec3(6.6, 6.2, 5.6)),
    Lamp(vec3(-4.19, 0.95, -1.75), vec3(0, 0, 0.75), vec3(0, 0.85, 0), vec3(3.9, 4.7, 5.8)),
    Lamp(vec3(-4.19, 0.95, 0.35), vec3(0, 0, 0.75), vec3(0, 0.85, 0), vec3(3.9, 4.7, 5.8)),
    Lamp(vec3(-4.19, 0.95, 2.45), vec3(0, 0, 0.75), vec3(0, 0.85, 0), vec3(3.9, 4.7, 5.8)),
    Lamp(vec3(2.6, 0.85, 3.6), vec3(0.62, 0, -0.45), vec3(0, 0.8, 0), vec3(5.2, 4.9, 4.5)));

#endif
