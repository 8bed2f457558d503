// Adds a particle's weight (1 - r²)² and its weighted temperatures, r the distance in space over the reach.
#version 450 core

layout(location = 0) flat in vec2 temperatures;
layout(location = 1) flat in vec2 disc;
layout(location = 0) out vec4 sums;

void main() {
    vec2 off = gl_PointCoord * 2.0 - 1.0;
    float inside = max(1.0 - disc.x - dot(off, off) * disc.y, 0.0);
    float weight = inside * inside;
    sums = vec4(weight, weight * temperatures, 0.0);
}
