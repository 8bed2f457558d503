// Empties the coarse cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;

void main() {
    uint cell = linearInvocation();
    if (cell < coarseCellCount()) head[cell] = 0;
}
