// A puff of smoke: a square that faces the eye itself and not its picture, so that both eyes see one ball.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/arc.glsl"
#include "shared/effects.h"

layout(std430, binding = FUME_BINDING) readonly buffer Fume {
    FumePuff puffs[];
};

layout(location = 0) out vec3 place;        // world
layout(location = 1) out vec3 inside;       // offset from the puff's middle along the world's axes, in its extents
layout(location = 2) out vec2 at;           // place on its ellipse, 0..1 from its middle to its edge
layout(location = 3) flat out vec3 eye;     // world, likewise the next
layout(location = 4) flat out float radius;
layout(location = 5) flat out vec3 grain;
layout(location = 6) flat out float depth;
layout(location = 7) flat out float arcSeen; // share of the arc's light that comes past the workpiece

// m from the eye within which smoke is not drawn, and from which it is whole: a veil before one eye only is no help.
const float kTooNear = 0.06, kNear = 0.16;

void main() {
    FumePuff puff = puffs[gl_VertexID / 6];
    int corner = gl_VertexID % 6;
    int corner4 = corner < 3 ? corner : 6 - corner; // 0 1 2, 3 2 1
    at = vec2(corner4 & 1, corner4 >> 1) * 2.0 - 1.0;
    eye = frame.views[viewIndex()].eye;
    vec3 middle = toWorld(puff.place);
    radius = puff.radius * frame.modelUnit;
    grain = puff.grain;
    vec3 way = middle - eye;
    float far = length(way);
    vec3 towards = way / max(far, 1e-6);
    vec3 along = mat3(frame.modelToWorld) * puff.way;
    float half_ = length(along), end = dot(along, towards);
    // As seen: shorter and deeper towards a view from its end.
    float seen = sqrt(half_ * half_ - end * end + radius * radius * (end * end) / (half_ * half_));
    depth = puff.depth * half_ / seen * smoothstep(kTooNear, kNear, far / frame.modelUnit);
    if (depth <= 0.0) {
        showAt(vec4(2.0, 2.0, 2.0, 1.0));
        return;
    }
    vec3 upright = along - towards * end;
    // From its very end it is round: any axis will do.
    vec3 high = length(upright) > 1e-3 * half_ ? normalize(upright) : normalize(cross(towards, vec3(0.6, 0.0, 0.8)));
    vec3 offset = high * (at.x * seen) + cross(towards, high) * (at.y * radius);
    vec3 axis = along / half_;
    float onAxis = dot(offset, axis);
    inside = (offset - axis * onAxis) / radius + axis * (onAxis / half_);
    place = middle + offset;
    arcSeen = frame.arcLight.g > 0.0 ? arcBesideWorkpiece(frame.arc - middle) : 0.0;
    showAt(toClip(place));
}
