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

/// The snapshot's state in double precision; density 0.
std::vector<TwinParticle> twinOf(const ClassicMetal::Snapshot& state);

/// Numbers of the particles at most h away from each one, itself included, rising.
std::vector<std::vector<size_t>> twinNeighbours(const std::vector<TwinParticle>& particles, double h);

/// One step: heating, density and pressure; acceleration; integration.
void twinStep(std::vector<TwinParticle>& particles, const ClassicParameters& parameters, const ClassicSource& source);

/// A state in which everything happens: particles at random in a cube of edge `edge` around the origin, a third solid,
/// the rest with temperatures 0.1 .. 1 and speeds up to 1.
ClassicMetal::Snapshot livelyState(size_t count, double edge, unsigned seed);

} // namespace meltpool::test
