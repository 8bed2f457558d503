// The flow's two sweeps in double precision on the CPU: the reference for the compute passes, and the gauge for
// pressure inside the liquid.
#pragma once

#include "core/metal/flow/flow_constants.hpp"

#include <functional>
#include <vector>

namespace meltpool {

struct OracleParticle {
    glm::dvec3 position{0}, velocity{0};
    bool liquid = true;
    double temperature = 500; ///< K, of wall metal
    double delta = 0;         ///< density over rest density, scaled
    glm::dvec3 gradient{0};   ///< weighted kernel gradient sum, 1/m
    glm::dvec3 acceleration{0};
    double pressure = 0; ///< Pa: virial of all pair forces on it, half of each pair its own
};

class FlowOracle {
  public:
    /// `acceleration`: gravity and other body forces, m/s². `period`: length after which space repeats, 0: it does not.
    explicit FlowOracle(const FlowFluid& fluid, glm::dvec3 acceleration = glm::dvec3(0),
                        glm::dvec3 period = glm::dvec3(0))
        : fluid_(fluid), constants_(FlowConstants::of(fluid)), acceleration_(acceleration), period_(period) {}

    /// Computes density and gradient of all particles.
    void sweepDensity(std::vector<OracleParticle>& particles) const;
    /// Computes acceleration and pressure of the liquid; needs sweepDensity().
    void sweepForce(std::vector<OracleParticle>& particles) const;
    /// Runs both sweeps and moves the liquid on by dt.
    void step(std::vector<OracleParticle>& particles, double dt) const;

  private:
    using PairFunction = std::function<void(size_t, size_t)>;

    glm::dvec3 displacement(const glm::dvec3& a, const glm::dvec3& b) const;
    double slopeOverDistance(double r) const;
    double weight(const OracleParticle& other) const { return other.liquid ? 1 : wettingAt(fluid_, other.temperature); }
    glm::dvec3 pairAcceleration(const OracleParticle& own, const OracleParticle& other) const;
    /// Calls `act` for each ordered pair within the support.
    void forEachPair(const std::vector<OracleParticle>& particles, const PairFunction& act) const;

    FlowFluid fluid_;
    FlowConstants constants_;
    glm::dvec3 acceleration_, period_;
};

} // namespace meltpool
