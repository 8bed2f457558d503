#include "core/weld/gauge/weld_particles.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

WeldParticles::WeldParticles(const MetalState& state, std::span<const MetalSeed> original)
    : lattice_(state.lattice()),
      original_(original),
      positions_(state.position.read<vec4>(state.particles())),
      heats_(state.heat.read<vec4>(state.particles())),
      phases_(state.phase.read<uint>(state.particles())) {
    if (original.size() > positions_.size())
        throw RuntimeFault("a section of a metal with " + std::to_string(positions_.size()) +
                           " particles cannot be measured; expected the " + std::to_string(original.size()) +
                           " of the workpiece among them");
    const auto count = static_cast<size_t>(lattice_.cells().x);
    living_.resize(count);
    originals_.resize(count);
    const auto low = static_cast<double>(lattice_.low.x), spacing = static_cast<double>(lattice_.spacing);
    for (size_t slot = 0; slot < positions_.size(); ++slot) {
        const double layer = std::floor((static_cast<double>(positions_[slot].x) - low) / spacing);
        if ((phases_[slot] & PHASE_ALIVE) && layer >= 0 && layer < static_cast<double>(count))
            living_[static_cast<size_t>(layer)].push_back(slot);
    }
    for (size_t slot = 0; slot < original.size(); ++slot) {
        const glm::ivec3 cell = lattice_.cellAt(original[slot].position);
        if ((original[slot].phase & PHASE_LATTICE) && lattice_.contains(cell))
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
