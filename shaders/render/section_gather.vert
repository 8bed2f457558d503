// A particle near the section's plane, as a disc of its reach in the plane's own picture.
#version 450 core

layout(location = 0) in vec4 position; // model units; w: temperature
layout(location = 1) in vec4 heat;     // z: peak temperature

layout(location = 0) uniform vec3 point;
layout(location = 1) uniform vec3 normal;
layout(location = 2) uniform vec3 across;
layout(location = 3) uniform vec3 up;
layout(location = 4) uniform vec4 corner; // low corner and size of the picture, model units
layout(location = 5) uniform float reach; // model units
layout(location = 6) uniform float texelsPerUnit;
layout(location = 7) uniform int peakIsTemperature;

layout(location = 0) flat out vec2 temperatures; // peak, present
layout(location = 1) flat out vec2 disc;         // squared distance from the plane and squared radius, in reaches

void main() {
    float off = dot(position.xyz - point, normal) / reach;
    vec2 place = (vec2(dot(position.xyz, across), dot(position.xyz, up)) - corner.xy) / corner.zw * 2.0 - 1.0;
    disc = vec2(off * off, max(1.0 - off * off, 0.0));
    temperatures = vec2(peakIsTemperature != 0 ? position.w : max(heat.z, position.w), position.w);
    gl_PointSize = 2.0 * sqrt(disc.y) * reach * texelsPerUnit;
    gl_Position = abs(off) < 1.0 ? vec4(place, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
