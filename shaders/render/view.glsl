// Which view a vertex is drawn for: the one place that knows how several views reach the pipeline.
#ifndef MELTPOOL_RENDER_VIEW_GLSL
#define MELTPOOL_RENDER_VIEW_GLSL

#include "render/frame.glsl"

layout(location = 0) uniform int firstView;

int viewIndex() {
    return firstView;
}

vec4 toClip(vec3 world) {
    return frame.views[viewIndex()].worldToClip * vec4(world, 1.0);
}

vec3 toWorld(vec3 model) {
    return (frame.modelToWorld * vec4(model, 1.0)).xyz;
}

// As toClip() for the metal's surface, of which the section takes a part away.
vec4 toClipCut(vec3 world) {
    gl_ClipDistance[0] = frame.cut.w - dot(frame.cut.xyz, world);
    return toClip(world);
}

#endif
