// Counts and temperatures over all particles.
#pragma once

#include <cstddef>

namespace meltpool {

/// Temperatures in the model's own scale: classic 0 (solid) .. 1 (liquid), physical K.
struct MetalStatistics {
    size_t particles = 0;
    size_t molten = 0;    ///< classic: temperature above 0, so free to move
    size_t lost = 0;      ///< outside the box, at a place that is no number, or refused wire that was fed there
    size_t nonFinite = 0; ///< times since the reset that a particle's new state was no number and was refused
    double minTemperature = 0;
    double meanTemperature = 0;
    double maxTemperature = 0;
};

/// Greatest number of pending statistics requests.
inline constexpr size_t kStatisticsInFlight = 4;

} // namespace meltpool
