// The view of a vertex, and its position there; only this shader code depends on the method of drawing several views.
// VIEWS_BY_VIEWPORT: an instance a view, each in a viewport of its own. VIEWS_BY_CLIPPING: an instance a view, squeezed
// into its column of one viewport and clipped at the column's sides. Neither: one view at a time.
#ifndef MELTPOOL_RENDER_VIEW_GLSL
#define MELTPOOL_RENDER_VIEW_GLSL

#ifdef VIEWS_BY_VIEWPORT
#extension GL_ARB_shader_viewport_layer_array : require
#endif

#include "render/frame.glsl"

#ifdef DRAWN_TWICE // drawn by differing programs: both must find the same depth
invariant gl_Position;
#endif

#ifdef VIEWS_BY_CLIPPING
const int kCutPlane = 2; // clip distances 0 and 1 are the column's sides
#else
const int kCutPlane = 0;
#endif

layout(location = 0) uniform int firstView;

#ifdef MANY_AT_ONCE // things of one draw call: the instances of each, one for each view, follow each other
layout(location = 20) uniform int viewsTogether;

int viewIndex() {
    return firstView + gl_InstanceID % viewsTogether;
}
#else
int viewIndex() {
    return firstView + gl_InstanceID;
}
#endif

vec3 toWorld(vec3 model) {
    return (frame.modelToWorld * vec4(model, 1.0)).xyz;
}

vec4 toClip(vec3 world) {
    return frame.views[viewIndex()].worldToClip * vec4(world, 1.0);
}

// Sets the position of the vertex in the clip space of its view. Vertex shaders call it last.
void showAt(vec4 clip) {
    gl_Position = clip;
#ifdef VIEWS_BY_VIEWPORT
    gl_ViewportIndex = viewIndex();
#endif
#ifdef VIEWS_BY_CLIPPING
    float columns = frame.viewCount;
    float middle = float(2 * viewIndex() + 1) - columns;
    gl_Position.x = (clip.x + middle * clip.w) / columns;
    gl_ClipDistance[0] = clip.w + clip.x;
    gl_ClipDistance[1] = clip.w - clip.x;
#endif
}

// Calls showAt() for the metal's surface, which the section cuts.
void showCut(vec3 world) {
    gl_ClipDistance[kCutPlane] = frame.cutOffset - dot(frame.cutNormal, world);
    showAt(toClip(world));
}

#endif
