// The order in which a driver sees what shaders write: barriers, fences, and copies between passes. A barrierFree()
// thread needs neither of the first two, and copies without the driver.
#pragma once

#include "core/gl/gl.hpp"

#include <cstddef>

namespace meltpool::gl {

/// glMemoryBarrier() where this thread needs it.
void memoryBarrier(GLbitfield barriers);

/// A fence after the commands issued so far; null where this thread needs none, as they have ended.
GLsync fence();

/// Copies bytes between buffers.
void copyBytes(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset);

/// Sets words of a buffer; `offset` and `bytes` are of whole words.
void fillWords(GLuint buffer, size_t offset, size_t bytes, GLuint word);

/// glDispatchComputeIndirect().
void dispatchIndirect(size_t offset);

} // namespace meltpool::gl
