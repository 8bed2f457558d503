#version 450 core
#extension GL_GOOGLE_include_directive : require
// Removes every changed particle from the corners it was added to, adds it to the corners around its present position,
// and marks the blocks whose mesh this can change. Weights are integers, so that exactly the added amount is removed.
//
// SURFACE_SMOOTH: the weight (1 - d²/r²)³ with r = influence - 1/2 cells falls smoothly to zero inside the reached
// corners. Without it: the linear weight of the founding thesis, which ends in a step.
// SURFACE_REBUILD: the volumes are empty and every particle is added.
// SURFACE_FREEZING: frozen metal is also added to the freezing volume.
// SURFACE_NUMBERED: the order of the particles changes; their records are stored by number.
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

/// The highest temperature of a particle so far; the coldest of the range if the particles do not store it.
float peakNow(uint index) {
    return withPeaks() ? texelFetch(heats, int(index)).z : setup.coldest; // the layout of `heats`: shared/metal.h
}

/// A temperature as a share of the temperature range, 0 to 1.
float shareOf(float temperature_) {
    precise float share = (temperature_ - setup.coldest) / setup.temperatureRange;
    return share > 0.0 ? min(share, 1.0) : 0.0;
}

/// Data of a particle besides its place and temperature.
struct History {
    float hottest;  ///< highest temperature, in the volumes' temperatures
    float frozenAt; ///< s; negative: molten; 0: never molten, or not requested
};

History historyNow(uint index) {
#ifdef SURFACE_FREEZING
    return History(peakNow(index), frozenNow(index));
#else
    return History(peakNow(index), 0.0);
#endif
}

/// The history when the particle was last splatted.
History historySplatted(uint record, History now) {
    History history = now;
    if (withPeaks()) history.hottest = splattedPeaks[record];
#ifdef SURFACE_FREEZING
    history.frozenAt = splattedFreezing[record];
#endif
    return history;
}

void storeHistory(uint record, History history) {
    if (withPeaks()) splattedPeaks[record] = history.hottest;
#ifdef SURFACE_FREEZING
    splattedFreezing[record] = history.frozenAt;
#endif
}

/// A particle's place among the corners, the corners in its reach, and its contribution.
struct Splat {
    vec3 place;
    ivec3 nearest, first, last; ///< first > last: it reaches none
    float share, peakShare;     ///< shares of its temperature and of its highest so far
    bool loose, frozen;         ///< true if it melted at some time; if it froze again
    uint ticks;                 ///< time of freezing
};

const Splat kNothing = Splat(vec3(0), ivec3(0), ivec3(1), ivec3(0), 0.0, 0.0, false, false, 0u);

Splat splatOf(Particle particle, History history) {
    precise vec3 place = (particle.position - setup.origin) * (vec3(setup.cells) / setup.extent) + 1.0;
    if (!all(lessThan(abs(place), vec3(1e6)))) return kNothing;
    Splat splat = kNothing;
    splat.place = place;
    int reach = setup.influence - 1;
    splat.nearest = ivec3(floor(place + 0.5));
    splat.first = max(splat.nearest - reach, ivec3(1));
    splat.last = min(splat.nearest + reach, setup.cells + 1);
    splat.share = shareOf(particle.temperature);
    splat.peakShare = shareOf(history.hottest);
#ifdef SURFACE_FREEZING
    splat.loose = history.frozenAt != 0.0;
    splat.frozen = history.frozenAt > 0.0 && history.frozenAt < SURFACE_FREEZING_LONGEST;
    splat.ticks = splat.frozen ? uint(history.frozenAt * SURFACE_FREEZING_TICKS + 0.5) : 0u;
#endif
    return splat;
}

bool reachesNone(Splat splat) {
    return any(greaterThan(splat.first, splat.last));
}

/// A particle's contribution to the volumes at one corner. Whole numbers: equal for an unchanged particle in every
/// pass.
struct Addition {
    int density, temperature, peak;
    uvec2 freezing;
};

/// Square of the way from a particle to a row of corners along x; far beyond every weight in rows that it does not
/// reach.
float squareToRow(Splat splat, int y, int z) {
    precise float dy = splat.place.y - float(y), dz = splat.place.z - float(z);
    precise float square = dy * dy + dz * dz;
#ifndef SURFACE_REBUILD // a rebuild visits no other rows
    ivec2 row = ivec2(y, z);
    if (any(lessThan(row, splat.first.yz)) || any(greaterThan(row, splat.last.yz))) square = 1e9;
#endif
    return square;
}

/// `toRow`: squareToRow() of the row that the corner `x` is in.
Addition additionAt(Splat splat, int x, float toRow, float scale) {
#ifdef SURFACE_REBUILD
    bool within = true;
#else
    bool within = x >= splat.first.x && x <= splat.last.x;
#endif
    precise float dx = splat.place.x - float(x);
    precise float square = dx * dx + toRow;
    float near = within ? max(weightAt(square, scale), 0.0) : 0.0;
    precise float scaled = near * float(SURFACE_UNIT) + 0.5;
    int weight = int(scaled);
    precise float heat = float(weight) * splat.share + 0.5;
    precise float peakHeat = float(weight) * splat.peakShare + 0.5;
    Addition addition = Addition(weight, int(heat), int(peakHeat), uvec2(0));
#ifdef SURFACE_FREEZING
    precise float scaledCoarse = near * setup.freezingUnit + 0.5;
    uint coarse = splat.loose && near > 0.0 ? uint(int(scaledCoarse)) : 0u;
    addition.freezing = coarse * uvec2(splat.frozen ? SURFACE_LOOSE + 1u : SURFACE_LOOSE, splat.ticks);
#endif
    return addition;
}

/// The addition to be removed: nothing from empty volumes.
Addition takenFrom(Splat splat, int x, float toRow, float scale) {
#ifdef SURFACE_REBUILD
    return Addition(0, 0, 0, uvec2(0));
#else
    return additionAt(splat, x, toRow, scale);
#endif
}

/// Replaces `before` by `now` in the volumes. Both are near each other, or one of them reaches nothing: a corner in
/// reach of both is changed once, and only if its value changes.
void replace(Splat before, Splat now) {
    bool fresh = reachesNone(before), gone = reachesNone(now);
    if (!fresh) markBlocks(before.first, before.last);
    if (!gone && (fresh || now.nearest != before.nearest)) markBlocks(now.first, now.last);
    ivec3 first = fresh ? now.first : gone ? before.first : min(before.first, now.first);
    ivec3 last = fresh ? now.last : gone ? before.last : max(before.last, now.last);
    float scale = weightScale(float(setup.influence - 1));
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y) {
            int row = cornerAddress(ivec3(0, y, z));
            float toNow = squareToRow(now, y, z), toBefore = squareToRow(before, y, z);
            for (int x = first.x; x <= last.x; ++x) {
                Addition added = additionAt(now, x, toNow, scale), taken = takenFrom(before, x, toBefore, scale);
                int address = row + (x >> 3) * SURFACE_BLOCK_CORNERS + (x & 7);
                if (added.density != taken.density) atomicAdd(density[address], uint(added.density - taken.density));
                if (added.temperature != taken.temperature)
                    atomicAdd(temperature[address], uint(added.temperature - taken.temperature));
                if (added.peak != taken.peak) atomicAdd(peak[address], uint(added.peak - taken.peak));
#ifdef SURFACE_FREEZING
                uvec2 change = added.freezing - taken.freezing;
                if (change.x != 0u) atomicAdd(freezing[address].x, change.x);
                if (change.y != 0u) atomicAdd(freezing[address].y, change.y);
#endif
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
        uint record = recordOf(index);
        splatted[record] = now;
        storeHistory(record, history);
    }
    replace(kNothing, splatOf(now, history));
}
#else
void main() {
    uint slot = linearInvocation();
    if (slot >= commands.changedCount) return;
    uint index = changedList[slot];
    uint record = recordOf(index);
    Particle now = particleNow(index);
    History history = historyNow(index);
    Splat before = splatOf(splatted[record], historySplatted(record, history)), after = splatOf(now, history);
    splatted[record] = now;
    storeHistory(record, history);
    bool together = all(lessThanEqual(abs(after.nearest - before.nearest), ivec3(1)));
    // One loop instead of two calls: the compiler emits the body once.
    for (int turn = together ? 1 : 0; turn < 2; ++turn) {
        Splat taken = before, added = after;
        if (!together && turn == 0) added = kNothing;
        if (!together && turn == 1) taken = kNothing;
        replace(taken, added);
    }
}
#endif
