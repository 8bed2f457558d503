// A corner of the workshop's geometry: walls, boxes, soft box and gas bottles. Its colour is that of the environment in
// its direction from the environment's origin, so that the picture from there is that of the sky.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/workshop_things.glsl"

layout(location = 1) uniform mat4 roomToWorld;

layout(location = 0) out vec3 direction; // direction in the environment, not unit

const int kPerBox = 36; // vertices
const int kBoxesEnd = (1 + WORKSHOP_BOXES) * kPerBox;
const int kSoftBoxEnd = kBoxesEnd + 12;

// Position on the two edges of a rectangle of triangles 0 1 2 and 0 2 3, -1 or 1.
vec2 rectangleCorner(int vertex) {
    int corner = vertex < 3 ? vertex : (vertex == 3 ? 0 : vertex - 2);
    return vec2(corner == 1 || corner == 2 ? 1.0 : -1.0, corner >= 2 ? 1.0 : -1.0);
}

// A corner -1..1 of a box whose faces look outwards (1) or inwards (-1).
vec3 boxCorner(int vertex, float looks) {
    int axis = vertex / 12;
    float side = (vertex / 6 & 1) == 0 ? -1.0 : 1.0;
    vec2 corner = rectangleCorner(vertex % 6);
    vec3 place = vec3(0.0);
    place[axis] = side;
    place[(axis + 1) % 3] = corner.x * side * looks;
    place[(axis + 2) % 3] = corner.y;
    return place;
}

vec3 inBox(vec3 lo, vec3 hi, int vertex, float looks) {
    return 0.5 * (lo + hi + (hi - lo) * boxCorner(vertex, looks));
}

// The soft box is visible from both sides.
vec3 onSoftBox(int vertex) {
    vec2 corner = rectangleCorner(vertex % 6);
    float side = vertex < 6 ? 1.0 : -1.0;
    return kLamps[kSoftBox].centre + kLamps[kSoftBox].across * corner.x * side + kLamps[kSoftBox].along * corner.y;
}

vec3 onBottle(int vertex) {
    int bottle = vertex / (6 * WORKSHOP_BOTTLE_SIDES);
    int side = vertex / 6 % WORKSHOP_BOTTLE_SIDES;
    vec2 corner = rectangleCorner(vertex % 6);
    float angle = 6.28318531 * (float(side) + 0.5 - 0.5 * corner.x) / float(WORKSHOP_BOTTLE_SIDES);
    // Half of the polygon is outside of the circle, half inside.
    float radius = kBottleRadius[bottle] / cos(1.57079633 / float(WORKSHOP_BOTTLE_SIDES));
    vec2 middle = kBottleAxis[bottle] + radius * vec2(cos(angle), sin(angle));
    return vec3(middle.x, corner.y < 0.0 ? kRoomMin.y : kBottleTop[bottle], middle.y);
}

void main() {
    int vertex = gl_VertexID;
    if (vertex < kPerBox) {
        direction = inBox(kRoomMin, kRoomMax, vertex, -1.0);
    } else if (vertex < kBoxesEnd) {
        int thing = vertex / kPerBox - 1;
        direction = inBox(kThings[thing].lo, kThings[thing].hi, vertex % kPerBox, 1.0);
    } else if (vertex < kSoftBoxEnd) {
        direction = onSoftBox(vertex - kBoxesEnd);
    } else {
        direction = onBottle(vertex - kSoftBoxEnd);
    }
    showAt(toClip((roomToWorld * vec4(direction, 1.0)).xyz));
}
