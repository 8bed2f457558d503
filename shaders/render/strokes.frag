// A line with round ends and smooth edges.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/tone.glsl"

layout(location = 0) in vec2 inStroke;
layout(location = 1) flat in vec4 tint;
layout(location = 2) flat in float reach;
layout(location = 0) out vec4 colour;

void main() {
    vec2 beyond = vec2(inStroke.x - clamp(inStroke.x, 0.0, reach), inStroke.y);
    float far = length(beyond); // distance from the line, in half widths
    float pixel = max(fwidth(inStroke.y), 1e-4);
    float cover = clamp((1.0 - far) / pixel + 0.5, 0.0, 1.0);
    colour = finishExact(tint.rgb * min(frame.exposure, vec3(1.0)), tint.a * cover);
}
