// Time of freezing of the metal around a vertex, and the gradient of that time: a plane through the mean times of the
// corners around (weighted least squares). A mean over the particles in reach alone follows the particles' places in
// steps; the plane is exact for an evenly changing time, and needs nothing from metal that did not freeze.
#ifndef MELTPOOL_SURFACE_FREEZING_GLSL
#define MELTPOOL_SURFACE_FREEZING_GLSL

layout(binding = SURFACE_TEXELS_FREEZING) uniform usamplerBuffer freezing;

// Reach of the fit, cells: also that of normals, so that an incremental update makes equal vertices.
const float kFitReach = 2.3;
// Added to the spread of the corners' places, square cells: makes the plane flat if the corners are in a line or a
// plane.
const float kFitSteadiness = 0.004;

struct FreezingSums {
    float loose;  ///< weight of all metal that ever melted
    float weight; ///< weight of its frozen part
    float time; ///< s
};

FreezingSums freezingAt(ivec3 corner) {
    uvec2 sums = texelFetch(freezing, cornerAddress(corner)).xy;
    uint loose = sums.x / SURFACE_LOOSE, frozen = sums.x % SURFACE_LOOSE;
    float time = frozen > 0u ? float(sums.y) / float(frozen) / SURFACE_FREEZING_TICKS : 0.0;
    return FreezingSums(float(loose) / setup.freezingUnit, float(frozen) / setup.freezingUnit, time);
}

/// Sums over the corners around: places in cells from the vertex, times in s from a time nearby.
struct FreezingMoments {
    float weight, time;
    vec3 place, placeTime;
    vec3 square, product; ///< x x, y y, z z; y z, z x, x y
};

void addCorner(inout FreezingMoments sum, ivec3 corner, vec3 vertex, float nearTime) {
    FreezingSums here = freezingAt(corner);
    vec3 d = vec3(corner) - vertex;
    float w = here.weight * max(1.0 - dot(d, d) / (kFitReach * kFitReach), 0.0), t = here.time - nearTime;
    sum.weight += w;
    sum.time += w * t;
    sum.place += w * d;
    sum.placeTime += w * t * d;
    sum.square += w * d * d;
    sum.product += w * d.yzx * d.zxy;
}

/// `first`, `last`: corners that may count; `vertex`: in corners. The slope is that per cell.
SurfaceFreezing fitFreezing(ivec3 first, ivec3 last, vec3 vertex, float nearTime) {
    FreezingMoments sum = FreezingMoments(0.0, 0.0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                addCorner(sum, ivec3(x, y, z), vertex, nearTime);
    if (sum.weight <= 0.0) return SurfaceFreezing(vec3(0.0), 0.0);
    float time = sum.time / sum.weight;
    vec3 place = sum.place / sum.weight;
    vec3 spread = sum.square / sum.weight - place * place + kFitSteadiness;
    vec3 mixed = sum.product / sum.weight - place.yzx * place.zxy;
    mat3 matrix = mat3(spread.x, mixed.z, mixed.y, mixed.z, spread.y, mixed.x, mixed.y, mixed.x, spread.z);
    vec3 slope = inverse(matrix) * (sum.placeTime / sum.weight - place * time);
    return SurfaceFreezing(slope, nearTime + time - dot(slope, place));
}

#endif
