// The veil of a bright arc over its surroundings in the eye itself: light scattered in lens and vitreous body.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/tone.glsl"

layout(location = 0) in vec3 way;
layout(location = 1) flat in vec3 toArc;
layout(location = 2) flat in vec3 atEye;
layout(location = 0) out vec4 colour;

const float kNearest = 0.1; // degrees: the law is not known nearer, and the arc itself is drawn there

// CIE 146 (Vos and others 2002), Stiles and Holladay's law for an eye of 25 years: luminance over illuminance is
// 10 (1 + (age / 70)^4) / square degrees from 1 degree to 30. Nearer it grows with the third power.
float veil(float degrees_) {
    float away = max(degrees_, kNearest);
    return GLARE_PER_SQUARE_DEGREE / (away * away * min(away, 1.0));
}

void main() {
    float angle = degrees(atan(length(cross(way, toArc)), dot(way, toArc)));
    colour = encoded(min(atEye * veil(angle) * frame.exposure, 1.0), 0.0);
}
