// Pseudo-random numbers that follow from counters alone: equal steps give equal numbers, whatever frames are drawn.
#pragma once

#include <cstdint>

namespace meltpool {

/// Returns 0..1, below 1; another number for each step and draw of it. The finaliser of SplitMix64 (Steele, Lea, Flood
/// 2014): it gives unrelated numbers for neighbouring counts.
inline float countedChance(std::uint64_t step, std::uint64_t draw) {
    std::uint64_t mixed = (step * 0x100000ULL + draw + 1) * 0x9E3779B97F4A7C15ULL;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBULL;
    mixed ^= mixed >> 31;
    return static_cast<float>(mixed >> 40) * 0x1p-24F;
}

} // namespace meltpool
