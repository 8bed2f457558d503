// A drop in flight or a bead at rest: a quad that holds a ball drawn out along its way, turned to the eye. At least a
// pixel wide; the light is then spread over it, so that small drops are faint and do not flicker.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "shared/effects.h"

layout(std430, binding = SPARKS_BINDING) readonly buffer Sparks {
    Spark sparks[];
};

layout(location = 0) out vec2 place;      // distances along the way from its end and across it, pixels
layout(location = 1) flat out float reach; // length of the way, pixels
layout(location = 2) flat out float thick; // radius as drawn, pixels
layout(location = 3) flat out float share; // share of the drop's light if it is drawn wider than it is
layout(location = 4) flat out float kelvin;
layout(location = 5) flat out vec3 along;  // world, unit, likewise the next two: the quad's own axes
layout(location = 6) flat out vec3 across;
layout(location = 7) flat out vec3 toEye;
layout(location = 8) flat out vec3 toArc;  // world

const float kThinnest = 0.7; // pixels, radius

void main() {
    Spark spark = sparks[gl_VertexID / 6];
    int corner = gl_VertexID % 6;
    int corner4 = corner < 3 ? corner : 6 - corner; // 0 1 2, 3 2 1
    ViewData view = frame.views[viewIndex()];
    vec3 world = toWorld(spark.place);
    float depth = -(view.worldToEye * vec4(world, 1.0)).z;
    if (depth <= 1e-4) {
        showAt(vec4(2.0, 2.0, 2.0, 1.0));
        return;
    }
    float pixels = view.pixelsPerUnit / depth; // pixels of a world unit
    toEye = normalize(view.eye - world);
    toArc = frame.arc - world;
    vec3 way = mat3(frame.modelToWorld) * spark.way;
    way -= toEye * dot(way, toEye); // the way as seen
    float far = length(way);
    vec3 side = transpose(mat3(view.worldToEye))[0];
    along = far * pixels > 0.5 ? way / far : normalize(side - toEye * dot(side, toEye));
    across = cross(toEye, along);
    float radius = spark.radius * frame.modelUnit * pixels;
    reach = far * pixels;
    thick = max(radius, kThinnest);
    share = radius * radius / (thick * thick);
    kelvin = spark.kelvin;
    float margin = thick + 1.0;
    place = vec2((corner4 & 1) == 0 ? -margin : reach + margin, (corner4 >> 1) == 0 ? -margin : margin);
    vec3 at = world - along * far + (along * place.x + across * place.y) / pixels;
    showAt(toClip(at));
}
