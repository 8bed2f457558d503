// A liquid alone, at one temperature, with walls: the rig of the flow's validation cases and tests.
#pragma once

#include "core/metal/flow/flow.hpp"
#include "core/metal/flow/flow_oracle.hpp"

#include <functional>

namespace meltpool {

struct FlowRig {
    /// `seeds`: liquid for those with PHASE_LIQUID, walls else; see liquidSeed() and wallSeed().
    FlowRig(gl::ShaderLibrary& shaders, const FlowFluid& fluid, const FlowSpace& space, glm::vec3 gravity,
            std::span<const MetalSeed> seeds);

    /// Runs for `seconds` in equal spans of about `span`; `look` is called after each with the time since the start.
    /// Throws RuntimeFault if the state stops being finite.
    void run(double seconds, double span, const std::function<void(double)>& look = {});

    std::vector<glm::dvec3> readPositions() const;  ///< positions of the liquid, m
    std::vector<glm::dvec3> readVelocities() const; ///< velocities of the liquid, m/s
    /// Returns all particles as the gauge sees them, with density and pressure. Waits for the GPU.
    std::vector<OracleParticle> measure() const;

    FlowFluid fluid;
    FlowSpace space;
    std::vector<bool> liquid;
    MetalState state;
    Flow flow;
    double time = 0;
    size_t steps = 0;
};

MetalSeed liquidSeed(glm::vec3 position);
MetalSeed wallSeed(glm::vec3 position);

/// Adds seeds for the points of a cubic lattice (first point half a spacing from `low`) between `low` and `high`.
void addBlock(std::vector<MetalSeed>& seeds, glm::vec3 low, glm::vec3 high, double spacing, bool isLiquid);

} // namespace meltpool
