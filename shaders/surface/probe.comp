#version 450 core
#extension GL_GOOGLE_include_directive : require
// Finds the surface around a point: every invocation marches one ray through the density volume to the iso level.
#include "surface/grid.glsl"
#include "shared/surface_probe.h"
layout(local_size_x = SURFACE_PROBE_RAYS) in;

layout(std430, binding = SURFACE_BIND_DENSITY) readonly buffer Density { uint density[]; };
layout(std430, binding = SURFACE_BIND_TEMPERATURE) readonly buffer Temperature { uint temperature[]; };
layout(std430, binding = SURFACE_BIND_PROBE) writeonly buffer Answer { SurfaceProbeAnswer answer; };

uniform vec3 point; // model units
uniform float reach;
uniform vec3 axis; // unit vector

const int kMostSamples = 2048;

struct Field {
    float density;
    float heat; // sum of weight x temperature share
};

shared float distances[SURFACE_PROBE_RAYS];
shared vec3 directions[SURFACE_PROBE_RAYS];

vec3 cellsPerUnit() {
    return vec3(setup.cells) / setup.extent;
}

/// Grid coordinates, in corners, of a model position.
vec3 gridCoordinates(vec3 place) {
    return (place - setup.origin) * cellsPerUnit() + 1.0;
}

/// Both volumes interpolated between the corners; 0 beyond the box.
Field fieldAt(vec3 place) {
    vec3 last = vec3(setup.cells + 1);
    if (any(lessThan(place, vec3(1.0))) || any(greaterThan(place, last))) return Field(0.0, 0.0);
    ivec3 low = min(ivec3(place), setup.cells);
    vec3 part = place - vec3(low);
    vec2 sum = vec2(0.0); // sums of both volumes at once
    for (int i = 0; i < 8; ++i) {
        ivec3 side = ivec3(i & 1, i >> 1 & 1, i >> 2);
        vec3 share = mix(1.0 - part, part, vec3(side));
        int address = cornerAddress(low + side);
        sum += share.x * share.y * share.z * vec2(density[address], temperature[address]);
    }
    return Field(sum.x, sum.y);
}

float isoLevel() {
    return float(max(setup.isoLevel, 1u));
}

/// Distance from the point along `direction` at which metal begins or, with `inside`, ends; the reach if it does not.
float surfaceAlong(vec3 direction, bool inside) {
    vec3 start = gridCoordinates(point), way = direction * cellsPerUnit();
    vec3 safe = mix(way, vec3(1e-12), lessThan(abs(way), vec3(1e-12)));
    vec3 a = (1.0 - start) / safe, b = (vec3(setup.cells + 1) - start) / safe;
    vec3 enter = min(a, b), leave = max(a, b);
    float from = max(max(enter.x, enter.y), max(enter.z, 0.0)), to = min(min(leave.x, leave.y), min(leave.z, reach));
    if (from >= to) return reach;
    float stride = 0.5 / max(max(abs(way.x), abs(way.y)), abs(way.z));
    int count = min(int(ceil((to - from) / stride)), kMostSamples);
    float iso = isoLevel(), before = inside ? iso : 0.0, at = from;
    for (int i = 0; i <= count; ++i) {
        float t = min(from + stride * float(i), to);
        float now = fieldAt(start + way * t).density;
        if ((now >= iso) != inside) {
            // A ray that enters the box inside the metal meets the surface at the box.
            return i == 0 ? t : mix(at, t, clamp((iso - before) / (now - before), 0.0, 1.0));
        }
        before = now;
        at = t;
    }
    return inside ? at : reach;
}

/// The axis for ray 0; the other directions spread evenly over the sphere (golden spiral).
vec3 rayOf(int ray) {
    if (ray == 0) return axis;
    float z = 1.0 - (2.0 * float(ray) - 1.0) / float(SURFACE_PROBE_RAYS - 1);
    float around = 2.3999632 * float(ray), r = sqrt(max(1.0 - z * z, 0.0));
    return vec3(r * cos(around), z, r * sin(around));
}

vec3 normalAt(vec3 place) {
    vec3 middle = gridCoordinates(place), slope;
    for (int i = 0; i < 3; ++i) {
        vec3 half_ = vec3(0.0);
        half_[i] = 0.5;
        // At the box the difference is one-sided: there are no corners beyond it.
        vec3 after = min(middle + half_, vec3(setup.cells + 1)), before = max(middle - half_, vec3(1.0));
        slope[i] = (fieldAt(after).density - fieldAt(before).density) / max(after[i] - before[i], 1e-6);
    }
    vec3 falling = -slope * cellsPerUnit();
    float square = dot(falling, falling);
    return square > 0.0 ? falling * inversesqrt(square) : -axis;
}

float temperatureAt(vec3 place) {
    Field field = fieldAt(gridCoordinates(place));
    return setup.coldest + (field.density > 0.0 ? setup.temperatureRange * (field.heat / field.density) : 0.0);
}

void main() {
    int ray = int(gl_LocalInvocationIndex);
    bool inside = fieldAt(gridCoordinates(point)).density >= isoLevel();
    // From inside the metal, the surface on the axis is behind the point.
    vec3 direction = inside && ray == 0 ? -axis : rayOf(ray);
    directions[ray] = direction;
    distances[ray] = surfaceAlong(direction, inside);
    barrier();
    if (ray != 0) return;
    int nearest = 0;
    for (int i = 1; i < SURFACE_PROBE_RAYS; ++i)
        if (distances[i] < distances[nearest]) nearest = i;
    float sign_ = inside ? -1.0 : 1.0;
    vec3 seen = inside ? point : point + axis * distances[0];
    answer.normal = normalAt(point + directions[nearest] * distances[nearest]);
    answer.ahead = sign_ * distances[0];
    answer.nearest = sign_ * distances[nearest];
    answer.temperature = temperatureAt(seen);
}
