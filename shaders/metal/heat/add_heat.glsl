// Heat taken up by one particle. Included after common.glsl.

const float kCoolingFrom = 1073.15; // 800 degrees C
const float kCoolingTo = 773.15;    // 500 degrees C

/// Part of `duration` spent between 800 and 500 degrees C while cooling, from the temperatures at both ends.
float coolingTime(float before, float after, float duration) {
    if (after >= before) return 0.0;
    float high = min(before, kCoolingFrom);
    float low = max(after, kCoolingTo);
    return high > low ? duration * (high - low) / (before - after) : 0.0;
}

/// A particle after it took up heat.
struct Heated {
    float temperature, theta;
    float enthalpy; // enthalpy without its residual
};

/// Adds the heat taken up in `duration` s to a particle's state `h` at temperature `before`; the residual holds the
/// part that float cannot. The peak is written only if it changed.
Heated addHeat(uint slot, vec4 h, float before, float joules, float duration) {
    precise float change = joules / metal.particleMass + h.y;
    precise float sum = h.x + change;
    precise float taken = sum - h.x;
    precise float rest = change - taken;
    vec2 state = thermalState(sum);
    float cooling = state.x > kCoolingFrom ? 0.0 : h.w + coolingTime(before, state.x, duration);
    heat[slot].x = sum;
    heat[slot].y = rest;
    if (state.x > h.z) heat[slot].z = state.x;
    if (cooling != h.w) heat[slot].w = cooling;
    position[slot].w = state.x;
    return Heated(state.x, state.y, sum);
}

/// Phase bits after a step: liquid above one fraction, solid below another, so that a particle near the limit does not change
/// back and forth.
uint nextPhase(uint bits, float enthalpy) {
    float f = liquidFraction(enthalpy);
    if (f > metal.meltsAbove) return bits | PHASE_LIQUID;
    const bool freezes = f < metal.freezesBelow && (bits & PHASE_LIQUID) != 0u;
    return freezes ? (bits & ~PHASE_LIQUID) | PHASE_FRESH : bits;
}
