// Mill scale of a workpiece: on its rolled faces, except the band that was ground along the seam.
#ifndef MELTPOOL_RENDER_MILL_SCALE_GLSL
#define MELTPOOL_RENDER_MILL_SCALE_GLSL

#include "render/frame.glsl"

// Greatest distance (m) of a face from the box of its part: the particles' surface is rounded. None: chosen.
const float kOffPart = 1.5e-3;
// Half the width of the band's fading end, and the wandering of its edge, m. None: chosen.
const float kBandFades = 1.1e-3;
const float kBandWanders = 0.7e-3;

// Wandering of the grinder at this place along the seam, m.
float bandWander(vec3 place) {
    vec2 along = (place.x + place.z * (1.0 - frame.seamAcross.z)) * vec2(140.0, 390.0);
    return kBandWanders * (0.6 * sin(along.x + 1.3 * sign(place.z)) + 0.4 * sin(along.y));
}

// Share of the surface under mill scale; `place`: model, `n`: unit, model.
float millScaleAt(vec3 place, vec3 n) {
    float rolled = 0.0;
    for (int i = 0; i < frame.rolledPartCount; ++i) {
        RolledPlate part = frame.rolledParts[i];
        vec3 off = max(part.low - place, place - part.high);
        float inside = step(max(off.x, max(off.y, off.z)), kOffPart);
        rolled = max(rolled, inside * smoothstep(0.6, 0.9, length(n * part.faces)));
    }
    float away = length(place * frame.seamAcross) + bandWander(place) - frame.groundHalf;
    return material.millScale * rolled * smoothstep(-kBandFades, kBandFades, away);
}

#endif
