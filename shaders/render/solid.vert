// A vertex of a painted solid: heat source, torch, table.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 outward;

layout(location = 1) uniform mat4 solidToWorld;

layout(location = 0) out vec3 normal;
layout(location = 1) out vec3 way;
layout(location = 2) out vec3 toLamp;
layout(location = 3) out vec3 toArc;

void main() {
    vec3 world = (solidToWorld * vec4(position, 1.0)).xyz;
    normal = transpose(inverse(mat3(solidToWorld))) * outward;
    way = world - frame.views[viewIndex()].eye;
    toLamp = frame.lamp - world;
    toArc = frame.arc - world;
    showAt(toClip(world));
}
