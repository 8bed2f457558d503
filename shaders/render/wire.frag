// Thin, smooth lines along the edges of triangles; those of back faces are fainter.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/metal_look.glsl"
#include "render/scale.glsl"

layout(location = 0) in vec3 corner;
layout(location = 1) in float temperature;
layout(location = 2) in float facing;
layout(location = 0) out vec4 colour;

const float kHalfWidth = 0.55; // pixels

void main() {
    vec3 rate = max(fwidth(corner), 1e-6);
    vec3 pixels = corner / rate; // distance from each edge
    float nearest = min(min(pixels.x, pixels.y), pixels.z);
    float cover = clamp(kHalfWidth + 0.5 - nearest, 0.0, 1.0);
    // Lines cover triangles of a few pixels completely: they fade, or the mesh would become a plain area.
    float height = 1.0 / max(max(rate.x, rate.y), rate.z);
    cover *= (gl_FrontFacing ? 0.9 : 0.22) * clamp(height / 7.0, 0.25, 1.0);
    if (cover < 0.01) discard;
    vec3 light = frame.colourMode > 0.5 ? scaleColour(temperature) : materialColour(meltShares(temperature).colour) * 1.6;
    colour = finish(light * (0.6 + 0.4 * abs(facing)), cover);
}
