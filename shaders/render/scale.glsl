// Temperature as a colour.
#ifndef MELTPOOL_RENDER_SCALE_GLSL
#define MELTPOOL_RENDER_SCALE_GLSL

#include "render/tone.glsl"

layout(binding = SCALE_UNIT) uniform sampler2D scales;

// The linear colour of a temperature on the chosen scale.
vec3 scaleColour(float temperature) {
    float t = clamp((temperature - frame.coldest) * frame.perTemperatureRange, 0.0, 1.0);
    vec2 at = vec2((t * float(SCALE_COLUMNS - 1) + 0.5) / float(SCALE_COLUMNS), (frame.scaleRow + 0.5) / float(SCALE_ROWS));
    return toLinear(texture(scales, at).rgb);
}

#endif
