// Barriers between the passes of heat, which read storage buffers also as texels.
#pragma once

#include "core/gl/order.hpp"

namespace meltpool {

/// Before a pass that reads what the last one wrote.
inline void storageBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Before an indirect pass whose number of groups the last one wrote as well.
inline void indirectBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

} // namespace meltpool
