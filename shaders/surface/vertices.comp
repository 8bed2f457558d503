#version 450 core
#extension GL_GOOGLE_include_directive : require
// Makes the vertex of every listed edge: position, temperature, normal.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_DENSITY) uniform usamplerBuffer density;
layout(binding = SURFACE_TEXELS_TEMPERATURE) uniform usamplerBuffer temperature;
layout(std430, binding = SURFACE_BIND_EDGE_LIST) readonly buffer EdgeList { uint edgeList[]; };
layout(std430, binding = SURFACE_BIND_VERTICES) writeonly buffer Vertices { SurfaceVertex vertices[]; };
layout(binding = SURFACE_TEXELS_PEAK) uniform usamplerBuffer peak;
layout(std430, binding = SURFACE_BIND_VERTEX_PEAKS) writeonly buffer VertexPeaks { float vertexPeaks[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

bool inGrid(ivec3 corner) {
    return all(greaterThanEqual(corner, ivec3(1))) && all(lessThanEqual(corner, setup.cells + 1));
}

float densityAt(ivec3 corner) {
    return float(texelFetch(density, cornerAddress(corner)).x);
}

float heatAt(ivec3 corner) {
    return float(texelFetch(temperature, cornerAddress(corner)).x);
}

/// Derivative of the density along an axis, per cell: central difference, one-sided at the box.
float slope(ivec3 corner, ivec3 axis) {
    ivec3 after = min(corner + axis, setup.cells + 1), before = max(corner - axis, ivec3(1));
    ivec3 span = after - before;
    return (densityAt(after) - densityAt(before)) / float(span.x + span.y + span.z);
}

vec3 gradient(ivec3 corner) {
    return vec3(slope(corner, ivec3(1, 0, 0)), slope(corner, ivec3(0, 1, 0)), slope(corner, ivec3(0, 0, 1)));
}

/// `v` as a unit vector, or `other` where v is zero.
vec3 normalised(vec3 v, vec3 other) {
    float square = dot(v, v);
    return square > 0.0 ? v * inversesqrt(square) : other;
}

/// Model position of a corner.
vec3 modelPosition(vec3 corner) {
    return setup.origin + setup.extent * ((corner - 1.0) / vec3(setup.cells));
}

/// Temperature from a sum of weight x temperature share and the sum of weights.
float temperatureOf(float heat, float weight) {
    return setup.coldest + setup.temperatureRange * (heat / weight);
}

void main() {
    uint index = linearInvocation();
    if (commands.firstVertex + index >= min(commands.vertexCount, setup.maxVertices)) return;
    uint edge = edgeList[index];
    ivec3 a = unpackCorner(edge), axis = ivec3(equal(uvec3(edge >> 30), uvec3(0u, 1u, 2u))), b = a + axis;
    bool gridA = inGrid(a), gridB = inGrid(b), cap = !(gridA && gridB);
    if (!gridA) a = b;
    if (!gridB) b = a;
    float weightA = densityAt(a), weightB = densityAt(b);
    float part = cap ? 0.0 : clamp((float(setup.isoLevel) - weightA) / (weightB - weightA), 0.0, 1.0);
    float heat = mix(heatAt(a), heatAt(b), part);

    // `outward`: along the edge from the inside corner to the outside one; the extent's signs mirror z into the model.
    vec3 outward = vec3(axis) * sign(setup.extent) * ((cap ? gridA : weightA > weightB) ? 1.0 : -1.0);
    vec3 falling = -mix(gradient(a), gradient(b), part) * (vec3(setup.cells) / setup.extent);

    SurfaceVertex vertex;
    vertex.position = modelPosition(mix(vec3(a), vec3(b), part));
    vertex.temperature = temperatureOf(heat, mix(weightA, weightB, part));
    vertex.normal = cap ? outward : normalised(falling, outward);
    vertex.reserved = 0.0;
    vertices[commands.firstVertex + index] = vertex;
    if ((setup.particleData & SURFACE_WITH_PEAKS) == 0) return;
    float hottest = mix(float(texelFetch(peak, cornerAddress(a)).x), float(texelFetch(peak, cornerAddress(b)).x), part);
    vertexPeaks[commands.firstVertex + index] = temperatureOf(hottest, mix(weightA, weightB, part));
}
