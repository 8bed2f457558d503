#version 450 core
#extension GL_GOOGLE_include_directive : require
// Subtracts every changed particle from the corners it was added to, adds it to the corners around its present position,
// and marks the blocks whose mesh this can change. Weights are integers, so that exactly what was added is subtracted.
//
// SURFACE_SMOOTH: the weight (1 - d²/r²)³ with r = influence - 1/2 cells falls smoothly to zero inside the reached
// corners. Without it: the linear weight of the founding thesis, which ends in a step.
// SURFACE_REBUILD: the volumes are empty and every particle is added.
// SURFACE_FREEZING: what froze is also added to the freezing volume.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/particles.glsl"

layout(std430, binding = SURFACE_BIND_DENSITY) buffer Density { uint density[]; };
layout(std430, binding = SURFACE_BIND_TEMPERATURE) buffer Temperature { uint temperature[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_FLAGS) writeonly buffer BlockFlags { uint flags[]; };
layout(std430, binding = SURFACE_BIND_SPLATTED) buffer Splatted { Particle splatted[]; };
layout(std430, binding = SURFACE_BIND_PEAK) buffer Peak { uint peak[]; };
layout(std430, binding = SURFACE_BIND_SPLATTED_PEAKS) buffer SplattedPeaks { float splattedPeaks[]; };
layout(binding = SURFACE_TEXELS_HEATS) uniform samplerBuffer heats;
#ifdef SURFACE_FREEZING
layout(std430, binding = SURFACE_BIND_FREEZING) buffer Freezing { uvec2 freezing[]; };
layout(std430, binding = SURFACE_BIND_SPLATTED_FREEZING) buffer SplattedFreezing { float splattedFreezing[]; };
#endif
layout(std430, binding = SURFACE_BIND_CHANGED_LIST) readonly buffer ChangedList { uint changedList[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

/// Marks the blocks with an edge whose vertex depends on these corners. A vertex depends on both ends of its edge and,
/// for the normal, on their neighbours. In empty volumes every vertex has an end among these corners.
void markBlocks(ivec3 first, ivec3 last) {
#ifdef SURFACE_REBUILD
    ivec3 low = (first - 1) >> 3, high = last >> 3;
#else
    ivec3 low = max(first - 2, ivec3(0)) >> 3, high = min((last + 1) >> 3, setup.blocks - 1);
#endif
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                flags[(z * setup.blocks.y + y) * setup.blocks.x + x] = 1u;
}

#ifdef SURFACE_SMOOTH
float weightAt(float square, float perSquare) {
    precise float inner = max(1.0 - square * perSquare, 0.0);
    precise float weight = inner * inner * inner;
    return weight;
}
float weightScale(float reach) {
    precise float r = reach + 0.5;
    precise float scale = 1.0 / (r * r);
    return scale;
}
#else
float weightAt(float square, float perCell) {
    precise float weight = 1.0 - sqrt(square) * perCell;
    return weight;
}
float weightScale(float reach) {
    precise float farthest = 0.8660254 + 1.7320508 * reach;
    precise float scale = 1.0 / farthest;
    return scale;
}
#endif

bool withPeaks() {
    return (setup.particleData & SURFACE_WITH_PEAKS) != 0;
}

/// The highest temperature of a particle so far; the coldest of the range where the particles do not store it.
float peakNow(uint index) {
    return withPeaks() ? texelFetch(heats, int(index)).z : setup.coldest; // the layout of `heats`: shared/metal.h
}

/// A temperature as a share of the temperature range, 0 to 1.
float shareOf(float temperature_) {
    precise float share = (temperature_ - setup.coldest) / setup.temperatureRange;
    return share > 0.0 ? min(share, 1.0) : 0.0;
}

/// What a particle brings beside its place and temperature.
struct History {
    float hottest;  ///< in the volumes' temperatures
    float frozenAt; ///< s; negative: molten; 0: never molten, or not asked for
};

History historyNow(uint index) {
#ifdef SURFACE_FREEZING
    return History(peakNow(index), frozenNow(index));
#else
    return History(peakNow(index), 0.0);
#endif
}

/// As it was last splatted.
History historySplatted(uint index, History now) {
    History history = now;
    if (withPeaks()) history.hottest = splattedPeaks[index];
#ifdef SURFACE_FREEZING
    history.frozenAt = splattedFreezing[index];
#endif
    return history;
}

void storeHistory(uint index, History history) {
    if (withPeaks()) splattedPeaks[index] = history.hottest;
#ifdef SURFACE_FREEZING
    splattedFreezing[index] = history.frozenAt;
#endif
}

/// Adds the particle to the volumes (`sign_` 1) or subtracts it (-1).
void addParticle(Particle particle, History history, int sign_) {
    precise vec3 place = (particle.position - setup.origin) * (vec3(setup.cells) / setup.extent) + 1.0;
    if (!all(lessThan(abs(place), vec3(1e6)))) return;
    float share = shareOf(particle.temperature), peakShare = shareOf(history.hottest);
#ifdef SURFACE_FREEZING
    bool frozen = history.frozenAt > 0.0 && history.frozenAt < SURFACE_FREEZING_LONGEST, loose = history.frozenAt != 0.0;
    uint ticks = frozen ? uint(history.frozenAt * SURFACE_FREEZING_TICKS + 0.5) : 0u;
#endif

    int reach = setup.influence - 1;
    ivec3 nearest = ivec3(floor(place + 0.5));
    ivec3 first = max(nearest - reach, ivec3(1)), last = min(nearest + reach, setup.cells + 1);
    if (any(greaterThan(first, last))) return;
    markBlocks(first, last);

    float scale = weightScale(float(reach));
    for (int z = first.z; z <= last.z; ++z) {
        precise float dz = place.z - float(z);
        precise float zz = dz * dz;
        for (int y = first.y; y <= last.y; ++y) {
            precise float dy = place.y - float(y);
            precise float yz = dy * dy + zz;
            int row = cornerAddress(ivec3(0, y, z));
            for (int x = first.x; x <= last.x; ++x) {
                precise float dx = place.x - float(x);
                precise float square = dx * dx + yz;
                float near = weightAt(square, scale);
                if (near <= 0.0) continue;
                precise float scaled = near * float(SURFACE_UNIT) + 0.5;
                int weight = int(scaled);
                int address = row + (x >> 3) * SURFACE_BLOCK_CORNERS + (x & 7);
                atomicAdd(density[address], uint(weight * sign_));
                if (share > 0.0) {
                    precise float heat = float(weight) * share + 0.5;
                    atomicAdd(temperature[address], uint(int(heat) * sign_));
                }
                if (peakShare > 0.0) {
                    precise float heat = float(weight) * peakShare + 0.5;
                    atomicAdd(peak[address], uint(int(heat) * sign_));
                }
#ifdef SURFACE_FREEZING
                if (loose) {
                    precise float scaledCoarse = near * setup.freezingUnit + 0.5;
                    uint coarse = uint(int(scaledCoarse) * sign_);
                    atomicAdd(freezing[address].x, coarse * (frozen ? SURFACE_LOOSE + 1u : SURFACE_LOOSE));
                    if (frozen) atomicAdd(freezing[address].y, coarse * ticks);
                }
#endif
            }
        }
    }
}

#ifdef SURFACE_REBUILD
void main() {
    uint index = linearInvocation();
    if (index >= setup.particleCount) return;
    Particle now = particleNow(index);
    History history = historyNow(index);
    if (setup.incremental != 0) {
        splatted[index] = now;
        storeHistory(index, history);
    }
    addParticle(now, history, 1);
}
#else
void main() {
    uint slot = linearInvocation();
    if (slot >= commands.changedCount) return;
    uint index = changedList[slot];
    Particle now = particleNow(index);
    Particle particle = splatted[index];
    History historyThen = historyNow(index), history = historySplatted(index, historyThen);
    splatted[index] = now;
    storeHistory(index, historyThen);
    // One loop instead of two calls: the compiler makes the body once.
    for (int sign_ = -1; sign_ <= 1; sign_ += 2) {
        addParticle(particle, history, sign_);
        particle = now;
        history = historyThen;
    }
}
#endif
