// Where the classic model's particles are at the start.
#pragma once

#include "core/metal/classic/classic_parameters.hpp"

#include <glm/vec4.hpp>

#include <vector>

namespace meltpool {

/// One vec4 a particle, by particle number: xyz in [-0.5, 0.5]³ box units, w = 0 (solid). Ordered: n = floor(cbrt(N))
/// per axis at the middles of n³ equal cells, x fastest, then y, then z; the N - n³ left over at random in
/// [-0.25, 0.25]³. Random: uniform in [-0.5, 0.5]³. The same setup gives the same bits on every machine.
/// Throws InputError for fewer than one particle.
std::vector<glm::vec4> arrangeParticles(const ClassicSetup& setup);

} // namespace meltpool
