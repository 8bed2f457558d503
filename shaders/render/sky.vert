// Direction of every ray of a view, at the far plane.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 0) out vec3 direction; // world, not unit

void main() {
    vec4 place = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1, 1.0, 1.0);
    direction = (frame.views[viewIndex()].clipToDirection * place).xyz;
    showAt(place);
}
