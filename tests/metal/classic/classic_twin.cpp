#include "tests/metal/classic/classic_twin.hpp"

#include "core/metal/classic/classic_kernels.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace meltpool::test {

namespace {

using Cell = std::array<int, 3>;

Cell cellAt(const glm::dvec3& place, double edge) {
    return {int(std::floor(place.x / edge)), int(std::floor(place.y / edge)), int(std::floor(place.z / edge))};
}

void heat(TwinParticle& particle, const ClassicParameters& p, const ClassicSource& source) {
    const glm::dvec3 apart = particle.position - glm::dvec3(source.position);
    const double squared = glm::dot(apart, apart);
    const double radius = double(p.heatRadius);
    if (source.strength <= 0 || squared >= radius) return;
    const double sign = source.cold ? -1 : 1;
    particle.temperature += sign * double(source.strength) * double(p.heatTemperature) * (1 - squared / radius);
    particle.temperature = std::clamp(particle.temperature, 0.0, 1.0);
}

glm::dvec3 accelerationOf(size_t i, const std::vector<TwinParticle>& particles, const std::vector<size_t>& neighbours,
                          const ClassicParameters& p) {
    const ClassicKernels kernels(double(p.supportRadius));
    const double mass = double(p.particleMass);
    const auto pressure = [&p](double density) { return double(p.gasStiffness) * (density - double(p.restDensity)); };
    const TwinParticle& own = particles[i];
    glm::dvec3 force(0);
    for (const size_t j : neighbours) {
        const TwinParticle& other = particles[j];
        const glm::dvec3 apart = own.position - other.position;
        const double r = glm::length(apart);
        const double mean = (pressure(own.density) + pressure(other.density)) / (2 * other.density);
        if (r > 0) force -= mass * mean * kernels.spikySlope(r) * apart / r; // coincident particles have no direction
        force += double(p.viscosity) * mass * (other.velocity - own.velocity) / other.density *
                 kernels.viscosityLaplacian(r);
    }
    glm::dvec3 acceleration = force / own.density + glm::dvec3(p.gravity);
    const double size = glm::length(acceleration);
    if (size > double(p.accelerationLimit)) acceleration *= double(p.accelerationLimit) / size;
    return acceleration;
}

void move(TwinParticle& particle, const glm::dvec3& acceleration, const ClassicParameters& p) {
    const double dt = double(p.timeStep);
    particle.velocity = (particle.velocity + acceleration * dt) * particle.temperature;
    particle.position += particle.velocity * dt;
    const glm::dvec3 before = particle.velocity;
    for (int axis = 0; axis < 3; ++axis) {
        double& x = particle.position[axis];
        if (std::abs(x) <= 1) continue;
        x = std::clamp(x, -1.0, 1.0);
        if (p.wallSlip)
            particle.velocity[axis] = -double(p.wallRestitution) * before[axis];
        else
            particle.velocity = -double(p.wallRestitution) * before;
    }
    particle.temperature = std::max(particle.temperature - double(p.solidifyRate), 0.0);
}

} // namespace

std::vector<TwinParticle> twinOf(const ClassicMetal::Snapshot& state) {
    std::vector<TwinParticle> particles;
    for (size_t i = 0; i < state.positions.size(); ++i)
        particles.push_back({state.positions[i], state.velocities[i], double(state.positions[i].w), 0});
    return particles;
}

std::vector<std::vector<size_t>> twinNeighbours(const std::vector<TwinParticle>& particles, double h) {
    std::map<Cell, std::vector<size_t>> cells;
    for (size_t i = 0; i < particles.size(); ++i)
        cells[cellAt(particles[i].position, h)].push_back(i);
    std::vector<std::vector<size_t>> lists(particles.size());
    for (size_t i = 0; i < particles.size(); ++i) {
        const Cell own = cellAt(particles[i].position, h);
        for (int step = 0; step < 27; ++step) {
            const auto cell = cells.find({own[0] + step % 3 - 1, own[1] + step / 3 % 3 - 1, own[2] + step / 9 - 1});
            if (cell == cells.end()) continue;
            for (const size_t j : cell->second)
                if (glm::length(particles[i].position - particles[j].position) <= h) lists[i].push_back(j);
        }
        std::sort(lists[i].begin(), lists[i].end());
    }
    return lists;
}

void twinStep(std::vector<TwinParticle>& particles, const ClassicParameters& p, const ClassicSource& source) {
    const ClassicKernels kernels(double(p.supportRadius));
    const auto neighbours = twinNeighbours(particles, double(p.supportRadius));
    for (size_t i = 0; i < particles.size(); ++i) {
        heat(particles[i], p, source);
        particles[i].density = 0;
        for (const size_t j : neighbours[i])
            particles[i].density +=
                double(p.particleMass) * kernels.poly6(glm::length(particles[i].position - particles[j].position));
    }
    std::vector<glm::dvec3> accelerations(particles.size());
    for (size_t i = 0; i < particles.size(); ++i)
        accelerations[i] = accelerationOf(i, particles, neighbours[i], p);
    for (size_t i = 0; i < particles.size(); ++i) {
        if (particles[i].temperature > 0) move(particles[i], accelerations[i], p);
        if (particles[i].temperature == 0) particles[i].velocity = glm::dvec3(0);
    }
}

ClassicMetal::Snapshot livelyState(size_t count, double edge, unsigned seed) {
    std::mt19937 bits(seed);
    const auto uniform = [&bits] { return float(bits() >> 8U) * 0x1p-24F; };
    ClassicMetal::Snapshot state;
    for (size_t i = 0; i < count; ++i) {
        const auto place = [&] { return (uniform() - 0.5F) * float(edge); };
        const float x = place(), y = place(), z = place();
        const bool solid = bits() % 3 == 0;
        state.positions.emplace_back(x, y, z, solid ? 0.0F : 0.1F + 0.9F * uniform());
        const auto speed = [&] { return solid ? 0.0F : uniform() - 0.5F; };
        const float vx = speed(), vy = speed(), vz = speed();
        state.velocities.emplace_back(vx, vy, vz, 0.0F);
    }
    return state;
}

} // namespace meltpool::test
