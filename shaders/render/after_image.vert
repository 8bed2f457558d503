// A square about the dazzled place of the eye's back: fixed to the eye, not to the world.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 0) out vec2 place; // -1..1

layout(location = 5) uniform vec3 towards; // unit, in the eye's directions

const float kHalf = 0.09; // tangent of half its angle: 5 degrees, a little more than the arc with its halo

void main() {
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    place = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
    ViewData view = frame.views[viewIndex()];
    vec3 side = normalize(cross(towards, vec3(0.0, 1.0, 1e-3))), high = cross(side, towards);
    vec3 inEye = towards + kHalf * (side * place.x + high * place.y);
    showAt(toClip(view.eye + transpose(mat3(view.worldToEye)) * inEye));
}
