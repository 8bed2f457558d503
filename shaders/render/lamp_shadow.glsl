// The torch's shadow in the lamp's light, in closed form: no pass over the scene, and equal in both eyes.
#ifndef MELTPOOL_RENDER_LAMP_SHADOW_GLSL
#define MELTPOOL_RENDER_LAMP_SHADOW_GLSL

#include "render/frame.glsl"

// Radius of the lamp's disc, model units. None: chosen, about that of the workshop's soft box seen from the table.
const float kLampRadius = 0.2;

// Free share of a disc behind a straight edge at this signed distance from its centre, in radii. The polynomial is
// within 0.008 of 1/2 + (x sqrt(1 - x²) + asin x) / pi.
float discBeyond(float x) {
    x = clamp(x, -1.0, 1.0);
    return 0.5 + x * (0.64 - 0.14 * x * x);
}

// Share of a lamp's light that passes a torch part. `toLamp`: from the surface, world; `radius`: of the lamp, likewise. The
// part counts as a capsule that fits into it; seen from the surface, the lamp's disc at the part's distance is covered by a
// strip of its width.
float lampPast(TorchPart part, vec3 at, vec3 toLamp, float radius) {
    float far = length(toLamp);
    vec3 towards = toLamp / far, axis = part.to - part.from;
    float whole = length(axis), shorter = min(part.radius, 0.5 * whole) / max(whole, 1e-9);
    vec3 start = at - part.from;
    float turned = dot(towards, axis), along = dot(towards, start), below = dot(axis, start);
    float square = dot(axis, axis);
    // The nearest points of axis and ray: 0..1 of the axis; then along the ray.
    float on = clamp((below - along * turned) / max(square - turned * turned, 1e-9 * square), shorter, 1.0 - shorter);
    float distance_ = turned * on - along;
    float gap = length(start + towards * distance_ - axis * on);
    float lamp = max(radius * distance_ / far, 1e-6 * far);
    float covered = discBeyond((gap + part.radius) / lamp) - discBeyond((gap - part.radius) / lamp);
    return distance_ > 0.0 && distance_ < far ? 1.0 - covered : 1.0;
}

// Share of the lamp's light that passes the torch.
float lampPastTorch(vec3 at, vec3 toLamp) {
    float share = 1.0;
    for (int i = 0; i < frame.torchPartCount; ++i)
        share *= lampPast(frame.torchParts[i], at, toLamp, kLampRadius * frame.modelUnit);
    return share;
}

#endif
