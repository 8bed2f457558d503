// Fullness and free surface of a cell. Included after neighbours.glsl.

/// Fullness of a cell with that weight, 0 .. 1. Steep, so that the unevenness inside liquid metal makes no surface.
float fullness(float weight) { return clamp((weight - 0.15) / 0.5, 0.0, 1.0); }

/// Weights of the six neighbouring cells.
struct Weights {
    vec3 low, high;
};

Weights readWeights(int cell, NeighbourOffsets offsets) {
    Weights w;
    ivec3 low = ivec3(cell) + offsets.low;
    ivec3 high = ivec3(cell) + offsets.high;
    w.low = vec3(weightOf(low.x), weightOf(low.y), weightOf(low.z));
    w.high = vec3(weightOf(high.x), weightOf(high.y), weightOf(high.z));
    w.low = mix(w.low, vec3(0), offsets.endLow);
    w.high = mix(w.high, vec3(0), offsets.endHigh);
    return w;
}

struct FreeSurface {
    vec3 normal; // outward, unit length, or zero if both sides are equally open
    float area;  // m²
};

/// Free surface of a cell that metal off the lattice may share. Over each face the step down in fullness counts, so
/// that the steps through a surface anywhere between cells add up to its area.
FreeSurface freeSurface(float weight, Weights w) {
    float own = fullness(weight);
    vec3 low = max(vec3(0), own - vec3(fullness(w.low.x), fullness(w.low.y), fullness(w.low.z)));
    vec3 high = max(vec3(0), own - vec3(fullness(w.high.x), fullness(w.high.y), fullness(w.high.z)));
    vec3 normal = high - low;
    float size = length(normal);
    float area = length(high + low) * metal.spacing * metal.spacing;
    return FreeSurface(size > 0.0 ? normal / size : vec3(0), area);
}
