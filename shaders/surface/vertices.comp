#version 450 core
#extension GL_GOOGLE_include_directive : require
// Makes the vertex of every listed edge: place, temperature, normal.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_DENSITY) uniform usamplerBuffer density;
layout(binding = SURFACE_TEXELS_TEMPERATURE) uniform usamplerBuffer temperature;
layout(std430, binding = SURFACE_BIND_EDGE_LIST) readonly buffer EdgeList { uint edgeList[]; };
layout(std430, binding = SURFACE_BIND_VERTICES) writeonly buffer Vertices { SurfaceVertex vertices[]; };
layout(binding = SURFACE_TEXELS_PEAK) uniform usamplerBuffer peak;
layout(std430, binding = SURFACE_BIND_VERTEX_PEAKS) writeonly buffer VertexPeaks { float vertexPeaks[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

bool ownCorner(ivec3 corner) {
    return all(greaterThanEqual(corner, ivec3(1))) && all(lessThanEqual(corner, setup.cells.xyz + 1));
}

float densityAt(ivec3 corner) {
    return float(texelFetch(density, cornerAddress(corner)).x);
}

float heatAt(ivec3 corner) {
    return float(texelFetch(temperature, cornerAddress(corner)).x);
}

/// Change of the density along an axis per cell: central, one-sided at the box.
float slope(ivec3 corner, ivec3 axis) {
    ivec3 after = min(corner + axis, setup.cells.xyz + 1), before = max(corner - axis, ivec3(1));
    ivec3 span = after - before;
    return (densityAt(after) - densityAt(before)) / float(span.x + span.y + span.z);
}

vec3 gradient(ivec3 corner) {
    return vec3(slope(corner, ivec3(1, 0, 0)), slope(corner, ivec3(0, 1, 0)), slope(corner, ivec3(0, 0, 1)));
}

/// A unit vector along `v`, or `other` where v has no direction.
vec3 direction(vec3 v, vec3 other) {
    float square = dot(v, v);
    return square > 0.0 ? v * inversesqrt(square) : other;
}

vec3 placeOf(vec3 corner) {
    return setup.origin.xyz + setup.extent.xyz * ((corner - 1.0) / vec3(setup.cells.xyz));
}

float temperatureOf(float heat, float weight) {
    return setup.origin.w + setup.extent.w * (heat / weight);
}

void main() {
    uint index = linearInvocation();
    if (commands.firstVertex + index >= min(commands.vertexCount, setup.limits.z)) return;
    uint edge = edgeList[index];
    ivec3 a = unpackCorner(edge), axis = ivec3(equal(uvec3(edge >> 30), uvec3(0u, 1u, 2u))), b = a + axis;
    bool ownA = ownCorner(a), ownB = ownCorner(b), cap = !(ownA && ownB);
    if (!ownA) a = b;
    if (!ownB) b = a;
    float weightA = densityAt(a), weightB = densityAt(b);
    float part = cap ? 0.0 : clamp((float(setup.limits.y) - weightA) / (weightB - weightA), 0.0, 1.0);
    float heat = mix(heatAt(a), heatAt(b), part);

    // Outward along the edge: from the inside corner to the outside one, in the model's mirrored axes.
    vec3 along = vec3(axis) * sign(setup.extent.xyz) * ((cap ? ownA : weightA > weightB) ? 1.0 : -1.0);
    vec3 falling = -mix(gradient(a), gradient(b), part) * (vec3(setup.cells.xyz) / setup.extent.xyz);

    SurfaceVertex vertex;
    vertex.position = vec4(placeOf(mix(vec3(a), vec3(b), part)), temperatureOf(heat, mix(weightA, weightB, part)));
    vertex.normal = vec4(cap ? along : direction(falling, along), 0.0);
    vertices[commands.firstVertex + index] = vertex;
    if ((setup.options.z & SURFACE_WITH_PEAKS) == 0) return;
    float hottest = mix(float(texelFetch(peak, cornerAddress(a)).x), float(texelFetch(peak, cornerAddress(b)).x), part);
    vertexPeaks[commands.firstVertex + index] = temperatureOf(hottest, mix(weightA, weightB, part));
}
