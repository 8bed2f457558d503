// A particle as a round point.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = TEMPERATURE_ATTRIBUTE) in float particleTemperature;

layout(location = 0) flat out float temperature;
layout(location = 1) flat out vec3 lampInEye; // unit
layout(location = 2) flat out vec3 wayInEye;  // unit, from the eye to the particle
layout(location = 3) flat out vec2 centre;    // centre of the disc, pixels
layout(location = 5) flat out float perRadius; // 1 / radius of the disc, 1 / pixels
#ifdef VIEWS_BY_CLIPPING
layout(location = 4) flat out vec2 column; // left and right side of the view, pixels
#endif

void main() {
    ViewData view = frame.views[viewIndex()];
    vec3 world = toWorld(position);
    showCut(world);
#ifdef VIEWS_BY_CLIPPING
    // Clip distances clip a point by its centre alone: the fragment shader tests each pixel.
    column = view.corner.x + vec2(0.0, view.size.x);
#endif
    // At least a pixel, so that far particles do not flicker.
    float radius = max(frame.pointRadius * view.pixelsPerUnit / max(gl_Position.w, 1e-6), 0.75);
    vec4 clip = view.worldToClip * vec4(world, 1.0);
    centre = (clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5) * view.size + view.corner;
    perRadius = 1.0 / radius;
    gl_PointSize = 2.0 * radius + 1.0; // the point's square covers the disc on every driver
    temperature = particleTemperature;
    lampInEye = normalize(mat3(view.worldToEye) * (frame.lamp - world));
    wayInEye = normalize(mat3(view.worldToEye) * (world - view.eye));
}
