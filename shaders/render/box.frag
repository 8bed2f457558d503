// White lines with smooth edges.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/tone.glsl"

layout(location = 0) in float across;
layout(location = 0) out vec4 colour;

void main() {
    colour = finishExact(0.9 * min(frame.exposure, 1.0), 0.85 * clamp(1.2 - abs(across), 0.0, 1.0));
}
