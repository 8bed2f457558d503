// A corner of a triangle of the metal's surface, read from the buffers by index, so that its barycentric coordinates are
// known.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "shared/surface.h"

layout(std430, binding = PULL_VERTICES_BINDING) readonly buffer Vertices {
    SurfaceVertex vertices[];
};
layout(std430, binding = PULL_INDICES_BINDING) readonly buffer Indices {
    uint indices[];
};

layout(location = 0) out vec3 corner; // barycentric
layout(location = 1) out float temperature;
layout(location = 2) out float facing; // cosine between the normal and the direction to the eye

void main() {
    SurfaceVertex v = vertices[indices[gl_VertexID]];
    vec3 world = toWorld(v.position);
    corner = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));
    temperature = v.temperature;
    facing = dot(normalize(mat3(frame.modelToWorld) * v.normal),
                 normalize(frame.views[viewIndex()].eye - world));
    showCut(world);
}
