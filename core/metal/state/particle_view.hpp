// The GPU buffers of the particles' positions and temperatures, for readers.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool {

struct MetalLattice;

struct ParticleView {
    /// One vec4 a particle: xyz in model units, w = temperature (classic 0..1; physical K).
    const gl::Buffer* positions = nullptr;
    size_t count = 0;
    /// One uint a slot, alive with PHASE_ALIVE (shaders/shared/metal.h); null if every slot holds a particle.
    const gl::Buffer* phases = nullptr;
    /// One vec4 a slot, z = highest temperature so far; null if the metal does not record it.
    const gl::Buffer* heats = nullptr;
    /// One float a slot, the time of freezing, s; 0 if it never was molten, METAL_MOLTEN if it is; null if the metal
    /// does not record it.
    const gl::Buffer* frozenAt = nullptr;
    /// The lattice of metal that has not melted, in model units, with the cells that still hold metal.
    const MetalLattice* lattice = nullptr;
    const gl::Buffer* latticeSlots = nullptr;
    float solidus = 0; ///< K, of the metal on the lattice; 0: unknown
    /// One uint a particle, below `count`, its fixed number; null if the order of the particles does not change.
    const gl::Buffer* numbers = nullptr;
};

} // namespace meltpool
