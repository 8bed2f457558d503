// Which view a vertex is drawn for and where that view lies: the one place that knows how several views reach the
// pipeline. VIEWS_BY_VIEWPORT: an instance a view, each sent to a viewport of its own. VIEWS_BY_CLIPPING: an instance a
// view, squeezed into its column of one viewport and cut off at the column's sides. Neither: one view at a time.
#ifndef MELTPOOL_RENDER_VIEW_GLSL
#define MELTPOOL_RENDER_VIEW_GLSL

#ifdef VIEWS_BY_VIEWPORT
#extension GL_ARB_shader_viewport_layer_array : require
#endif

#include "render/frame.glsl"

#ifdef VIEWS_BY_CLIPPING
const int kCutPlane = 2; // 0 and 1 are the column's sides
#else
const int kCutPlane = 0;
#endif

layout(location = 0) uniform int firstView;

int viewIndex() {
    return firstView + gl_InstanceID;
}

vec3 toWorld(vec3 model) {
    return (frame.modelToWorld * vec4(model, 1.0)).xyz;
}

vec4 toClip(vec3 world) {
    return frame.views[viewIndex()].worldToClip * vec4(world, 1.0);
}

// Puts the vertex to this place of its own view's clip space. The last thing that a vertex shader does.
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

// As showAt() for the metal's surface, of which the section takes a part away.
void showCut(vec3 world) {
    gl_ClipDistance[kCutPlane] = frame.cutOffset - dot(frame.cutNormal, world);
    showAt(toClip(world));
}

#endif
