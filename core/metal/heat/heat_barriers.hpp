// Barriers between the passes of heat, which read storage buffers also as texels.
#pragma once

#include "core/gl/order.hpp"

namespace meltpool {

/// A barrier before a pass that reads the writes of the last one.
inline void storageBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// A barrier before an indirect pass whose number of groups the last pass wrote too.
inline void indirectBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

} // namespace meltpool
