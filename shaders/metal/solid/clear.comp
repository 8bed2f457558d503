// Empties the coarse cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;

void main() {
    uint cell = linearInvocation();
    if (cell < uint(pieces.coarse.x * pieces.coarse.y * pieces.coarse.z)) head[cell] = 0;
}
