// Barriers between the passes of the surface, which read storage buffers also as texels.
#pragma once

#include "core/gl/gl.hpp"

namespace meltpool {

/// Issues the barrier before a pass that reads results of the last one.
inline void surfaceBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Issues the barrier before an indirect pass whose number of groups the last one wrote as well.
inline void surfaceCommandBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

} // namespace meltpool
