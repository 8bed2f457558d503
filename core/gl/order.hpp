// Barriers, fences and copies that order shader writes for the driver. A barrierFree() thread needs no barriers or
// fences, and copies without the driver.
#pragma once

#include "core/gl/gl.hpp"

#include <cstddef>

namespace meltpool::gl {

/// Calls glMemoryBarrier() if this thread needs it.
void memoryBarrier(GLbitfield barriers);

/// A fence after the commands issued so far; null if this thread needs none, because they have ended.
GLsync fence();

/// Copies bytes between buffers.
void copyBytes(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset);

/// Sets words of a buffer; `offset` and `bytes` are multiples of a word.
void fillWords(GLuint buffer, size_t offset, size_t bytes, GLuint word);

/// Calls glDispatchComputeIndirect().
void dispatchIndirect(size_t offset);

} // namespace meltpool::gl
