#include "core/metal/flow/flow_oracle.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

glm::dvec3 FlowOracle::displacement(const glm::dvec3& a, const glm::dvec3& b) const {
    glm::dvec3 d = a - b;
    for (int axis = 0; axis < 3; ++axis)
        if (period_[axis] > 0) d[axis] -= period_[axis] * std::round(d[axis] / period_[axis]);
    return d;
}

double FlowOracle::slopeOverDistance(double r) const {
    const double h = constants_.support;
    const double u = 1 - r * r / (h * h);
    return u <= 0 ? 0 : -8 * constants_.kernelSelf * u * u * u / (h * h);
}

void FlowOracle::forEachPair(const std::vector<OracleParticle>& particles, const PairFunction& act) const {
    // Sorted cells along x only: simple, and far from quadratic for the shapes of the tests.
    const double h = constants_.support;
    std::vector<std::pair<double, size_t>> order(particles.size());
    for (size_t i = 0; i < particles.size(); ++i)
        order[i] = {particles[i].position.x, i};
    std::sort(order.begin(), order.end());
    const size_t count = order.size();
    for (size_t a = 0; a < count; ++a) {
        const auto visit = [&](size_t b) {
            const glm::dvec3 d = displacement(particles[order[a].second].position, particles[order[b].second].position);
            if (glm::dot(d, d) >= h * h) return;
            act(order[a].second, order[b].second);
            act(order[b].second, order[a].second);
        };
        size_t b = a + 1;
        for (; b < count && order[b].first - order[a].first < h; ++b)
            visit(b);
        if (period_.x <= 0) continue;
        for (size_t last = count; last-- > b && order[a].first + period_.x - order[last].first < h;)
            visit(last);
    }
}

void FlowOracle::sweepDensity(std::vector<OracleParticle>& particles) const {
    for (OracleParticle& own : particles) {
        own.delta = constants_.kernelSelf;
        own.gradient = glm::dvec3(0);
    }
    const double h = constants_.support;
    forEachPair(particles, [&](size_t i, size_t j) {
        const glm::dvec3 d = displacement(particles[i].position, particles[j].position);
        const double u = 1 - glm::dot(d, d) / (h * h);
        particles[i].delta += constants_.kernelSelf * u * u * u * u;
        particles[i].gradient += weight(particles[j]) * slopeOverDistance(glm::length(d)) * d;
    });
}

glm::dvec3 FlowOracle::pairAcceleration(const OracleParticle& own, const OracleParticle& other) const {
    const double h = constants_.support;
    const glm::dvec3 d = displacement(own.position, other.position);
    const double r = glm::length(d);
    const glm::dvec3 e = d / r;
    const double q = r / h;
    const auto stiffness = [&](double delta) {
        return constants_.soundSpeed * constants_.soundSpeed * std::max(delta - 1, 0.0) / (delta * delta);
    };
    const double slope = slopeOverDistance(r) * r;
    const double friction = other.liquid ? 1 : constants_.wallFriction;
    glm::dvec3 a = -(stiffness(own.delta) + stiffness(other.delta)) * slope * e;
    a += friction * constants_.friction * slope * glm::dot(own.velocity - other.velocity, e) / (r + 1e-4 * h * h / r) *
         e;
    const double k = weight(other) * 2 / (own.delta + other.delta);
    const double lobe = std::pow(1 - q, 3) * std::pow(q, 3);
    a -= k * constants_.cohesion * (q > 0.5 ? lobe : 2 * lobe - 1.0 / 64) * e;
    a -= k * constants_.area * 4 * q * q * (1 - q * q) * glm::dot(own.gradient - other.gradient, e) * e;
    return a;
}

void FlowOracle::sweepForce(std::vector<OracleParticle>& particles) const {
    const double volume = constants_.mass / fluid_.density;
    for (OracleParticle& own : particles) {
        own.acceleration = acceleration_;
        own.pressure = 0;
    }
    forEachPair(particles, [&](size_t i, size_t j) {
        if (!particles[i].liquid) return;
        const glm::dvec3 a = pairAcceleration(particles[i], particles[j]);
        particles[i].acceleration += a;
        particles[i].pressure +=
            constants_.mass * glm::dot(a, displacement(particles[i].position, particles[j].position)) / (6 * volume);
    });
}

void FlowOracle::step(std::vector<OracleParticle>& particles, double dt) const {
    sweepDensity(particles);
    sweepForce(particles);
    for (OracleParticle& own : particles) {
        if (!own.liquid) continue;
        own.velocity += dt * own.acceleration;
        own.position += dt * own.velocity;
    }
}

} // namespace meltpool
