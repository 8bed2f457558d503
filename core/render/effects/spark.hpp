// Drawn effects about an arc: spatter and drops as glowing balls, and the smoke that the arc lights.
#pragma once

#include "shaders/shared/effects.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace meltpool {

/// The smoke about an arc.
struct Fume {
    /// Share of light that a metre of it scatters out of a ray; 0: none.
    float scattering = 0;
    /// Puffs of it that rise, the oldest first, and the pool that none may hide (model units).
    std::span<const FumePuff> puffs = {};
    glm::vec3 pool{0};
};

struct ArcEffectsView {
    std::span<const Spark> sparks;
    size_t onTable = 0; ///< number of the last of them that are on the table, not on the workpiece
    Fume fume;
};

} // namespace meltpool
