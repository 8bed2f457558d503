// The section's rectangle.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 1) uniform vec3 origin; // on the plane, straight over the model's origin
layout(location = 2) uniform vec3 across;
layout(location = 3) uniform vec3 up;
layout(location = 4) uniform vec4 corner; // low corner and size, model units

layout(location = 0) out vec2 inPicture; // 0..1
layout(location = 1) out vec3 world;

void main() {
    int corner4 = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    inPicture = vec2(corner4 & 1, corner4 >> 1);
    vec2 place = corner.xy + inPicture * corner.zw;
    world = toWorld(origin + across * place.x + up * place.y);
    showAt(toClip(world));
}
