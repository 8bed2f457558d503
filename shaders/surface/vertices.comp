#version 450 core
#extension GL_GOOGLE_include_directive : require
// Makes the vertex of every listed edge: position, temperature, normal. SURFACE_FREEZING: its time of freezing, too.
// SURFACE_FLAT: on the faces of metal that is still on its lattice.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_DENSITY) uniform usamplerBuffer density;
layout(binding = SURFACE_TEXELS_TEMPERATURE) uniform usamplerBuffer temperature;
layout(std430, binding = SURFACE_BIND_EDGE_LIST) readonly buffer EdgeList { uint edgeList[]; };
layout(std430, binding = SURFACE_BIND_VERTICES) writeonly buffer Vertices { SurfaceVertex vertices[]; };
layout(binding = SURFACE_TEXELS_PEAK) uniform usamplerBuffer peak;
layout(std430, binding = SURFACE_BIND_VERTEX_PEAKS) writeonly buffer VertexPeaks { float vertexPeaks[]; };
#ifdef SURFACE_FREEZING
layout(std430, binding = SURFACE_BIND_VERTEX_FREEZING) writeonly buffer VertexFreezing { SurfaceFreezing vertexFreezing[]; };
#include "surface/freezing.glsl"
#endif
#ifdef SURFACE_FLAT
#include "surface/lattice.glsl"
#endif
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

#ifdef SURFACE_FLAT
/// Share, 0..1, by which a vertex moves onto the faces of metal that is still on its lattice. Beside metal that melted
/// the lattice has holes whose walls are no faces.
float untouchedShare(float loose, float hottest) {
    return (1.0 - smoothstep(kFlatFrom, 1.0, hottest / setup.flatBelow)) * (1.0 - smoothstep(0.02, 0.25, loose));
}

/// Puts a vertex beside metal of the lattice on its pipe: on the outer or inner face if its normal looks across the
/// axis, else on an end; near the edge of both, on that.
void putOnPipe(inout SurfaceVertex vertex, float share) {
    vec2 off = vertex.position.xy - setup.pipeAxis;
    float radius = length(off);
    vec2 away = off / max(radius, 1e-9);
    float across = dot(vertex.normal.xy, away), far = kFarthestPipe / setup.perLatticeSpacing;
    float face = across > 0.0 ? setup.pipeOuter : setup.pipeInner;
    float end = vertex.normal.z > 0.0 ? setup.pipeHigh : setup.pipeLow;
    bool round_ = abs(across) >= abs(vertex.normal.z);
    float offFace = abs(radius - face), offEnd = abs(vertex.position.z - end), edge = kPipeEdge / setup.perLatticeSpacing;
    vec3 place = vec3(round_ || offFace < edge ? setup.pipeAxis + away * face : vertex.position.xy,
                      !round_ || offEnd < edge ? end : vertex.position.z);
    vec3 normal = round_ ? vec3(away * sign(across), 0) : vec3(0, 0, sign(vertex.normal.z));
    bool near = (round_ ? offFace : offEnd) < far;
    share = near ? share : 0.0;
    vertex.position = mix(vertex.position, place, share);
    vertex.normal = normalised(mix(vertex.normal, normal, share), vertex.normal);
}

/// Puts a vertex beside metal of the lattice on the lattice's own surface; `loose`: share of other metal around,
/// `share`: untouchedShare(). `inside`: the corner of its edge that is inside, `edge`: from there to the outside, in
/// corners.
void flatten(inout SurfaceVertex vertex, ivec3 inside, ivec3 edge, float loose, float share) {
    vec3 n = vertex.normal, size = abs(n);
    ivec3 signs = ivec3(sign(setup.extent)); // signs of the corners' axes in the model
    ivec3 axis = edge * signs;
    if (dot(n, vec3(axis)) < kFacing)
        axis = size.x >= max(size.y, size.z) ? ivec3(sign(n.x), 0, 0) : size.y >= size.z ? ivec3(0, sign(n.y), 0) : ivec3(0, 0, sign(n.z));
    vec3 place = (vertex.position - setup.latticeOrigin) * setup.perLatticeSpacing;
    LatticeFace face = faceAt(place, place - 0.05 * n, axis, share > 0.0 ? 3 : 0);
    bool ends = face.found && loose < kNoneLoose;
    for (int i = 0; i < 3; ++i) {
        ivec3 way = ivec3(i == 0, i == 1, i == 2);
        if (abs(axis[i]) == 1) continue;
        // The surface does not go on beyond the inside corner: the face ends there.
        bool after = densityAt(min(inside + way, setup.cells + 1)) < float(setup.isoLevel);
        bool before = densityAt(max(inside - way, ivec3(1))) < float(setup.isoLevel);
        moveToEdge(face, axis, way * signs, ends && after ? 3 : 0);
        moveToEdge(face, axis, -way * signs, ends && before ? 3 : 0);
    }
    share = face.found ? share : 0.0;
    vertex.position = mix(vertex.position, setup.latticeOrigin + face.place / setup.perLatticeSpacing, share);
    vertex.normal = normalised(mix(n, vec3(axis), share), n);
}

/// Share of metal off the lattice if no time of freezing is known: it was hot, and heats the mean of the highest
/// temperatures around.
float looseByHeat(float hottest) {
    return clamp(hottest / setup.flatBelow - kLooseFrom, 0.0, 1.0);
}
#endif

#ifdef SURFACE_FREEZING
/// Writes the time of freezing of the metal at a vertex between `a` and `b`; returns the shares of the metal there, of
/// density `weight`, that froze (x) and that ever melted (y).
vec2 writeFreezing(uint index, ivec3 a, ivec3 b, float part, float weight) {
    FreezingSums atA = freezingAt(a), atB = freezingAt(b);
    float frozen = mix(atA.weight, atB.weight, part);
    float time = mix(atA.weight * atA.time, atB.weight * atB.time, part) / max(frozen, 1e-6);
    // An empty box if nothing froze. SYNCHRONOUS_DRIVER: it skips a loop that no invocation makes.
    ivec3 first = frozen > 0.0 ? max(a - 1, ivec3(1)) : ivec3(1), last = frozen > 0.0 ? min(b + 1, setup.cells + 1) : ivec3(0);
    SurfaceFreezing fit = fitFreezing(first, last, mix(vec3(a), vec3(b), part), time);
    fit.slope *= vec3(setup.cells) / setup.extent;
    vertexFreezing[index] = fit;
    return min(vec2(frozen, mix(atA.loose, atB.loose, part)) * float(SURFACE_UNIT) / weight, 1.0);
}
#endif

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
#ifdef SURFACE_FREEZING
    vec2 shares = writeFreezing(commands.firstVertex + index, a, b, part, mix(weightA, weightB, part));
    vertex.frozen = shares.x;
#else
    vertex.frozen = 0.0;
#endif
    bool withPeaks = (setup.particleData & SURFACE_WITH_PEAKS) != 0;
    float hottest = setup.coldest;
    if (withPeaks) {
        float sum = mix(float(texelFetch(peak, cornerAddress(a)).x), float(texelFetch(peak, cornerAddress(b)).x), part);
        hottest = temperatureOf(sum, mix(weightA, weightB, part));
        vertexPeaks[commands.firstVertex + index] = hottest;
    }
#ifdef SURFACE_FLAT
#ifdef SURFACE_FREEZING
    float loose = shares.y;
#else
    float loose = looseByHeat(hottest);
#endif
    float share = untouchedShare(loose, hottest);
    if (setup.flatPlaneCount > 0 && !cap)
        flatten(vertex, weightA > weightB ? a : b, weightA > weightB ? axis : -axis, loose, share);
    // SYNCHRONOUS_DRIVER: a loop, as it skips one that no invocation makes, and no branch.
    for (int i = 0; i < setup.pipeCount && !cap; ++i) putOnPipe(vertex, share);
#endif
    vertices[commands.firstVertex + index] = vertex;
}
