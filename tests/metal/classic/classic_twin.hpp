// The classic model in double precision on the CPU, written directly from its description: the reference for the GPU's
// passes.
#pragma once

#include "core/metal/classic/classic_metal.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace meltpool::test {

struct TwinParticle {
    glm::dvec3 position{0};
    glm::dvec3 velocity{0};
    double temperature = 0;
    double density = 0;
};

/// Returns the snapshot's state in double precision, with density 0.
std::vector<TwinParticle> twinOf(const ClassicMetal::Snapshot& state);

/// Returns the ascending numbers of the particles at most h away from each one, itself included.
std::vector<std::vector<size_t>> twinNeighbours(const std::vector<TwinParticle>& particles, double h);

/// Makes one step: heating, density and pressure; acceleration; integration.
void twinStep(std::vector<TwinParticle>& particles, const ClassicParameters& parameters, const ClassicSource& source);

/// Returns a state that covers all cases: random particles in a cube of edge `edge` around the origin, a third solid,
/// the rest with temperatures 0.1 .. 1 and speeds up to 1.
ClassicMetal::Snapshot livelyState(size_t count, double edge, unsigned seed);

} // namespace meltpool::test
