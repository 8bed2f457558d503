// The section's rectangle, across the seam: its own axes are the workpiece's z and y.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 1) uniform float at; // place of the plane along x, model units
layout(location = 2) uniform vec2 corner; // low corner of the map in these axes, model units
layout(location = 3) uniform vec2 size;   // size of the map, model units

layout(location = 0) out vec2 inPicture; // 0..1
layout(location = 1) out vec3 world;

void main() {
    int corner4 = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    inPicture = vec2(corner4 & 1, corner4 >> 1);
    vec2 place = corner + inPicture * size;
    world = toWorld(vec3(at, place.y, place.x));
    showAt(toClip(world));
}
