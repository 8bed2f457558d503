// A vertex of the metal's surface.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature;

layout(location = 0) out vec3 normal; // world, not unit
layout(location = 1) out vec3 way;    // world, from the eye to the vertex
layout(location = 2) out vec3 place;  // model units
layout(location = 3) out float temperature;
layout(location = 4) out vec3 toLamp;
layout(location = 5) flat out int view;

void main() {
    vec3 world = toWorld(position);
    normal = mat3(frame.modelToWorld) * outward;
    view = viewIndex();
    way = world - frame.views[view].eye;
    place = position;
    temperature = vertexTemperature;
    toLamp = frame.lamp - world;
    showCut(world);
}
