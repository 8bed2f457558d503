// The flow's two sweeps in double precision, on the CPU and over all pairs: what the compute passes are held against.
#pragma once

#include "core/metal/flow.hpp"

#include <glm/geometric.hpp>

#include <vector>

namespace meltpool::test {

struct TwinParticle {
    glm::dvec3 position{0}, velocity{0};
    bool liquid = true;
    double delta = 0;
    glm::dvec3 gradient{0};
    glm::dvec3 acceleration{0};
    double virial = 0; ///< pressure of all pair forces, Pa; a particle takes half of each pair
};

struct FlowTwin {
    FlowFluid fluid;
    FlowConstants constants = FlowConstants::of(fluid);
    glm::dvec3 gravity{0}; ///< with any other body acceleration
    glm::dvec3 period{0};  ///< 0 where space does not repeat

    glm::dvec3 apart(const glm::dvec3& a, const glm::dvec3& b) const {
        glm::dvec3 d = a - b;
        for (int axis = 0; axis < 3; ++axis)
            if (period[axis] > 0) d[axis] -= period[axis] * std::round(d[axis] / period[axis]);
        return d;
    }
    double weight(const TwinParticle& other) const { return other.liquid ? 1 : fluid.wetting; }
    double slopeOverDistance(double r) const {
        const double u = 1 - r * r / (constants.support * constants.support);
        return u <= 0 ? 0 : -8 * constants.kernelSelf * u * u * u / (constants.support * constants.support);
    }

    void sweepDensity(std::vector<TwinParticle>& particles) const {
        for (TwinParticle& own : particles) {
            own.delta = constants.kernelSelf;
            own.gradient = glm::dvec3(0);
            for (const TwinParticle& other : particles) {
                if (&own == &other) continue;
                const glm::dvec3 d = apart(own.position, other.position);
                const double r = glm::length(d);
                const double u = 1 - r * r / (constants.support * constants.support);
                if (u <= 0) continue;
                own.delta += constants.kernelSelf * u * u * u * u;
                own.gradient += weight(other) * slopeOverDistance(r) * d;
            }
        }
    }

    /// Acceleration of `own` by `other`, without gravity.
    glm::dvec3 pair(const TwinParticle& own, const TwinParticle& other) const {
        const double h = constants.support;
        const glm::dvec3 d = apart(own.position, other.position);
        const double r = glm::length(d);
        if (r >= h) return glm::dvec3(0);
        const glm::dvec3 e = d / r;
        const double q = r / h;
        const auto stiffness = [&](double delta) {
            return constants.soundSpeed * constants.soundSpeed * std::max(delta - 1, 0.0) / (delta * delta);
        };
        const double slope = slopeOverDistance(r) * r;
        glm::dvec3 a = -(stiffness(own.delta) + stiffness(other.delta)) * slope * e;
        a += 10 * constants.kinematicViscosity * slope * glm::dot(own.velocity - other.velocity, e) /
             (r + 1e-4 * h * h / r) * e;
        const double k = weight(other) * 2 / (own.delta + other.delta);
        const double lobe = std::pow(1 - q, 3) * std::pow(q, 3);
        a -= k * constants.cohesion * (q > 0.5 ? lobe : 2 * lobe - 1.0 / 64) * e;
        a -= k * constants.area * 4 * q * q * (1 - q * q) * (own.gradient - other.gradient);
        return a;
    }

    void sweepForce(std::vector<TwinParticle>& particles) const {
        const double volume = constants.mass / fluid.density;
        for (TwinParticle& own : particles) {
            own.acceleration = gravity;
            own.virial = 0;
            if (!own.liquid) continue;
            for (const TwinParticle& other : particles) {
                if (&own == &other) continue;
                const glm::dvec3 a = pair(own, other);
                own.acceleration += a;
                own.virial += constants.mass * glm::dot(a, apart(own.position, other.position)) / (6 * volume);
            }
        }
    }

    void step(std::vector<TwinParticle>& particles, double dt) const {
        sweepDensity(particles);
        sweepForce(particles);
        for (TwinParticle& own : particles) {
            if (!own.liquid) continue;
            own.velocity += dt * own.acceleration;
            own.position += dt * own.velocity;
        }
    }
};

} // namespace meltpool::test
