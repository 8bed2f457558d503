// Lines in the plane of a section, each a rectangle that holds it with its round ends.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(std430, binding = STROKES_BINDING) readonly buffer Strokes {
    SectionStroke strokes[];
};

layout(location = 1) uniform float at; // place of the strokes' plane along x, model units

layout(location = 0) out vec2 inStroke;   // distances along it from its start and across it, in half widths
layout(location = 1) flat out vec4 tint;
layout(location = 2) flat out float reach; // length of the stroke in half widths

const float kMargin = 1.5; // half widths, for the smooth edge

void main() {
    SectionStroke stroke = strokes[gl_VertexID / 6];
    int corner = gl_VertexID % 6;
    int corner4 = corner < 3 ? corner : 6 - corner; // 0 1 2, 3 2 1
    float halfWidth = 0.5 * stroke.width;
    vec2 way = stroke.to - stroke.from;
    float length0 = length(way);
    vec2 along = length0 > 1e-9 ? way / length0 : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    reach = length0 / halfWidth;
    inStroke = vec2((corner4 & 1) == 0 ? -kMargin : reach + kMargin, (corner4 >> 1) == 0 ? -kMargin : kMargin);
    tint = stroke.colour;
    vec2 place = stroke.from + halfWidth * (inStroke.x * along + inStroke.y * across);
    showAt(toClip(toWorld(vec3(at, place.y, place.x))));
}
