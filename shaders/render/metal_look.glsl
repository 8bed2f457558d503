// Look of metal at a temperature, after the founding thesis: dull grey while solid, darker and mirroring when molten.
#ifndef MELTPOOL_RENDER_METAL_LOOK_GLSL
#define MELTPOOL_RENDER_METAL_LOOK_GLSL

#include "render/tone.glsl"

// Change of the colour and the mirror image from solid (0) to liquid (1).
struct MeltShares {
    float colour;
    float mirror;
};

// Classic: colour grey max(1 - T, 0.2) and mirror share min(T, 0.6) from T > 0.3 on, that is from 0.7 to 0.2 over
// 0.3 .. 0.8 and from 0.3 to 0.6 over 0.3 .. 0.6. Physical: by the liquid fraction.
MeltShares meltShares(float temperature) {
    vec2 shares = frame.perMushyRange == 0.0 ? clamp((temperature - 0.3) / vec2(0.5, 0.3), 0.0, 1.0)
                                             : vec2(clamp((temperature - frame.solidus) * frame.perMushyRange, 0.0, 1.0));
    return MeltShares(shares.x, shares.y);
}

vec3 materialColour(float share) {
    return toLinear(mix(material.solidColour, material.liquidColour, share));
}

#endif
