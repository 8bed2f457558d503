// Empties the lists of the coarse cells and sets the number of contacts of each fragment to zero.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in; // one group has an invocation for each fragment number
layout(std430, binding = FRAGMENT_MOTIONS) buffer Motions { FragmentMotion motion[]; };

void main() {
    uint cell = linearInvocation();
    if (cell < coarseCellCount()) {
        head[fixedList(cell)] = 0;
        head[freeList(cell)] = 0;
    }
    if (cell <= FRAGMENT_MAX_COUNT) motion[cell].fixedContacts = 0;
}
