// Where the particles' places and temperatures lie on the GPU, for those who only look at them.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool {

struct ParticleView {
    /// One vec4 a particle: xyz in model units, w = temperature (classic 0..1; physical K).
    const gl::Buffer* positions = nullptr;
    size_t count = 0;
    /// Where not every slot holds a particle: one uint a slot, alive with PHASE_ALIVE (shaders/shared/metal.h).
    const gl::Buffer* phases = nullptr;
    /// Where the metal remembers how hot it was: one vec4 a slot, z = highest temperature so far.
    const gl::Buffer* heats = nullptr;
};

} // namespace meltpool
