// Where the particles' places and temperatures lie on the GPU, for those who only look at them.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool {

struct MetalLattice;

struct ParticleView {
    /// One vec4 a particle: xyz in model units, w = temperature (classic 0..1; physical K).
    const gl::Buffer* positions = nullptr;
    size_t count = 0;
    /// Where not every slot holds a particle: one uint a slot, alive with PHASE_ALIVE (shaders/shared/metal.h).
    const gl::Buffer* phases = nullptr;
    /// Where the metal remembers how hot it was: one vec4 a slot, z = highest temperature so far.
    const gl::Buffer* heats = nullptr;
    /// Where the metal remembers when it froze: one float a slot, s; 0 where it never was molten,
    /// METAL_MOLTEN where it is.
    const gl::Buffer* frozenAt = nullptr;
    /// The lattice that metal stands on until it melts, in model units, and which cells hold metal still.
    const MetalLattice* lattice = nullptr;
    const gl::Buffer* latticeSlots = nullptr;
    float solidus = 0; ///< K, of the metal on the lattice; 0: not known
    /// Where the order of the particles changes: one uint a particle, below `count`, by which it is known again.
    const gl::Buffer* numbers = nullptr;
};

} // namespace meltpool
