// The uniform blocks of the frame and of the material.
#ifndef MELTPOOL_RENDER_FRAME_GLSL
#define MELTPOOL_RENDER_FRAME_GLSL

#include "shared/render.h"

layout(std140, binding = FRAME_BINDING) uniform Frame {
    FrameData frame;
};

layout(std140, binding = MATERIAL_BINDING) uniform Material {
    MaterialData material;
};

#endif
