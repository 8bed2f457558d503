// A particle as a small ball of its material, or as a disc in exactly the colour of its temperature.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/metal_look.glsl"
#include "render/scale.glsl"

layout(location = 0) flat in float temperature;
layout(location = 1) flat in vec3 lampInEye;
layout(location = 2) flat in vec3 wayInEye;
#ifdef VIEWS_BY_CLIPPING
layout(location = 4) flat in vec2 column;
#endif
layout(location = 3) flat in vec2 centre;
layout(location = 5) flat in float perRadius;
layout(location = 0) out vec4 colour;

void main() {
#ifdef VIEWS_BY_CLIPPING
    if (gl_FragCoord.x < column.x || gl_FragCoord.x > column.y) discard;
#endif
    // Not gl_PointCoord: drivers differ in it by up to half a pixel.
    vec2 off = (gl_FragCoord.xy - centre) * perRadius;
    float inside = 1.0 - dot(off, off);
    if (inside < 0.0) discard;
    if (frame.colourMode > 0.5) {
        colour = finishExact(scaleColour(temperature), 1.0);
        return;
    }
    vec3 n = vec3(off, sqrt(inside));
    MeltShares share = meltShares(temperature);
    float light = frame.ambient + frame.diffuse * max(dot(n, lampInEye), 0.0);
    float towardsLamp = max(dot(reflect(wayInEye, n), lampInEye), 0.0);
    float highlight = pow(towardsLamp, 20.0) * frame.specular * (0.2 + 0.8 * share.mirror);
    colour = finish(light * materialColour(share.colour) * (0.55 + 0.45 * n.z) + highlight, 1.0);
}
