// The far side of translucent materials: normal and distance from the eye.
#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 0) out vec4 side;

void main() {
    side = vec4(normalize(normal), length(way));
}
