// Initial positions of the classic model's particles.
#pragma once

#include "core/metal/classic/classic_parameters.hpp"

#include <glm/vec4.hpp>

#include <vector>

namespace meltpool {

/// One vec4 a particle, in the order of their numbers: position in [-0.5, 0.5]³ box units and temperature 0 (solid).
/// Ordered: n = floor(cbrt(N)) per axis at the centres of n³ equal cells, x fastest, then y, then z; the remaining N -
/// n³ at random in [-0.25, 0.25]³. Random: uniform in [-0.5, 0.5]³. Equal setups give equal bits on every machine.
/// Throws InputError for fewer than one particle.
std::vector<glm::vec4> arrangeParticles(const ClassicSetup& setup);

} // namespace meltpool
