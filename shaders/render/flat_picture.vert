// A flat picture in space: a strip of two triangles, one unit wide and high about its middle.
#version 450 core

layout(location = 0) out vec2 place; // 0..1

uniform mat4 toClip;

void main() {
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = toClip * vec4(place - 0.5, 0.0, 1.0);
}
