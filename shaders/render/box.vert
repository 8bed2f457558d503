// Twelve edges of the box, each a thin strip of two triangles on the screen.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 0) out float across; // pixels from the line's centre

const float kHalfWidth = 1.5; // pixels, including the smooth edge

void main() {
    int line = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    int axis = line / 4;
    vec3 share = vec3(0.0);
    share[(axis + 1) % 3] = float(line & 1);
    share[(axis + 2) % 3] = float((line >> 1) & 1);
    vec3 other = share;
    other[axis] = 1.0;
    vec4 from = toClip(toWorld(mix(frame.boxMin, frame.boxMax, share)));
    vec4 to = toClip(toWorld(mix(frame.boxMin, frame.boxMax, other)));
    // Points behind the eye cannot be projected: the line is clipped at the near plane first.
    float nearFrom = from.z + from.w;
    float nearTo = to.z + to.w;
    if (nearFrom < 0.0 && nearTo < 0.0) {
        showAt(vec4(2.0, 2.0, 2.0, 1.0));
        across = 0.0;
        return;
    }
    if (nearFrom < 0.0) from = mix(to, from, nearTo / (nearTo - nearFrom) * 0.9999);
    if (nearTo < 0.0) to = mix(from, to, nearFrom / (nearFrom - nearTo) * 0.9999);
    vec2 size = frame.views[viewIndex()].size;
    vec2 along = (to.xy / to.w - from.xy / from.w) * size;
    vec2 side = normalize(vec2(-along.y, along.x) + vec2(1e-6, 0.0)) * 2.0 / size;
    bool end = corner == 1 || corner == 2 || corner == 4;
    float sign1 = corner == 0 || corner == 1 || corner == 4 ? -1.0 : 1.0;
    vec4 place = end ? to : from;
    across = sign1 * kHalfWidth;
    showAt(place + vec4(side * across * place.w, 0.0, 0.0));
}
