// A square about the arc's image, as wide as its visible glare.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/arc.glsl"
#include "render/lamp_shadow.glsl"

layout(location = 0) out vec3 way;            // world, from the eye
layout(location = 1) flat out vec3 toArc;     // world, from the eye
layout(location = 2) flat out vec3 atEye;     // light that the arc throws into the eye: illuminance, see FrameData.arcLight

// Share of paper white below which glare is not drawn. Behind a filter all is dark and two steps of 255 are seen, else
// not. None: chosen.
const float kFaintest = 2e-3;
const float kFaintestFiltered = 5e-4;
const float kWidest = 0.5236; // rad, 30 degrees: the limit of the law
// Model units, which are metres where there is an arc: a camera nearer than a welder's eye is a magnifying glass, whose
// picture must not drown in the arc's light. None: chosen as the distance of a face from the arc.
const float kNearestEye = 0.35;

void main() {
    ViewData eye = frame.views[viewIndex()];
    toArc = frame.arc - eye.eye;
    float distance_ = length(toArc), ball = frame.modelUnit * sqrt(frame.arcMinDistanceSquared);
    float seen = eye.arcSeen * arcBesideWorkpiece(toArc);
    for (int i = 0; i < frame.torchPartCount; ++i)
        seen *= lampPast(frame.torchParts[i], eye.eye, toArc, ball);
    float far = max(distance_ / frame.modelUnit, kNearestEye);
    atEye = seen * frame.arcLight / (far * far);
    vec3 drawn = atEye * frame.exposure;
    float faintest = frame.exposure.g < 0.1 ? kFaintestFiltered : kFaintest;
    float widest = sqrt(GLARE_PER_SQUARE_DEGREE * max(drawn.r, max(drawn.g, drawn.b)) / faintest) / 57.29578;
    // A square across the view, wide enough for an arc beside its middle too.
    float half_ = 1.3 * distance_ * tan(min(widest, kWidest));
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    vec2 at = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
    mat3 toWorld_ = transpose(mat3(eye.worldToEye));
    way = toArc + half_ * (toWorld_[0] * at.x + toWorld_[1] * at.y);
    showAt(toClip(eye.eye + way));
}
