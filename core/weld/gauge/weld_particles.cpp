#include "core/weld/gauge/weld_particles.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace meltpool {

namespace {

/// Returns a place of a pipe rolled out, see WeldParticles; all in m.
glm::vec3 rolledOut(const glm::vec3& place, double radius) {
    const double x = static_cast<double>(place.x), y = static_cast<double>(place.y) + radius;
    double angle = std::atan2(x, y);
    if (angle < 0) angle += 2 * std::numbers::pi;
    return {static_cast<float>(angle * radius), static_cast<float>(std::hypot(x, y) - radius), place.z};
}

/// Returns the lattice of a pipe rolled out, whose cells touch the outer face as the pipe's own touch the upper faces.
MetalLattice rolledOut(const MetalLattice& lattice, double radius) {
    const double spacing = static_cast<double>(lattice.spacing);
    const auto axis = static_cast<float>(-std::floor(radius / spacing) * spacing);
    const auto around = static_cast<float>(2 * std::numbers::pi * radius);
    const glm::vec3 high = lattice.low + glm::vec3(lattice.cells()) * lattice.spacing;
    return MetalLattice::covering({0, axis, lattice.low.z}, {around, high.y, high.z}, lattice.spacing);
}

ParticleValues valuesOf(const MetalState& state) {
    return {state.position.read<vec4>(state.particles()), state.heat.read<vec4>(state.particles()),
            state.phase.read<uint>(state.particles())};
}

} // namespace

WeldParticles::WeldParticles(const MetalState& state, std::span<const MetalSeed> original)
    : WeldParticles(state.lattice(), valuesOf(state), original) {}

WeldParticles::WeldParticles(const MetalState& state, std::span<const MetalSeed> original, double pipeRadius)
    : WeldParticles(state.lattice(), valuesOf(state), original, pipeRadius) {}

WeldParticles::WeldParticles(const MetalLattice& lattice, ParticleValues values, std::span<const MetalSeed> original,
                             std::optional<double> pipeRadius)
    : lattice_(pipeRadius ? meltpool::rolledOut(lattice, *pipeRadius) : lattice),
      original_(original),
      rolledOut_(pipeRadius.has_value()),
      values_(std::move(values)) {
    if (original_.size() > values_.positions.size())
        throw RuntimeFault("a section of a metal with " + std::to_string(values_.positions.size()) +
                           " particles cannot be measured; expected the " + std::to_string(original_.size()) +
                           " of the workpiece among them");
    if (pipeRadius) {
        for (vec4& place : values_.positions)
            place = vec4(meltpool::rolledOut(glm::vec3(place), *pipeRadius), place.w);
        rolledSeeds_.assign(original.begin(), original.end());
        for (MetalSeed& seed : rolledSeeds_)
            seed.position = meltpool::rolledOut(seed.position, *pipeRadius);
    }
    sort();
}

void WeldParticles::sort() {
    const auto count = static_cast<size_t>(lattice_.cells().x);
    living_.resize(count);
    originals_.resize(count);
    const auto low = static_cast<double>(lattice_.low.x), spacing = static_cast<double>(lattice_.spacing);
    for (size_t slot = 0; slot < values_.positions.size(); ++slot) {
        const double layer = std::floor((static_cast<double>(values_.positions[slot].x) - low) / spacing);
        if ((values_.phases[slot] & PHASE_ALIVE) && layer >= 0 && layer < static_cast<double>(count))
            living_[static_cast<size_t>(layer)].push_back(slot);
    }
    const std::span<const MetalSeed> seeds = original();
    for (size_t slot = 0; slot < seeds.size(); ++slot) {
        const glm::ivec3 cell = lattice_.cellAt(seeds[slot].position);
        if ((seeds[slot].phase & PHASE_LATTICE) && lattice_.contains(cell))
            originals_[static_cast<size_t>(cell.x)].push_back(slot);
    }
}

std::vector<size_t> WeldParticles::gather(const Layers& layers, int first, int end) {
    std::vector<size_t> slots;
    const int count = static_cast<int>(layers.size());
    for (int layer = std::max(first, 0); layer < std::min(end, count); ++layer)
        slots.insert(slots.end(), layers[static_cast<size_t>(layer)].begin(), layers[static_cast<size_t>(layer)].end());
    std::sort(slots.begin(), slots.end());
    return slots;
}

} // namespace meltpool
