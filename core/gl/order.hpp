// The order in which a driver sees what shaders write: barriers and fences, and threads that need none.
#pragma once

#include "core/gl/gl.hpp"

#include <cstddef>

namespace meltpool::gl {

/// Whether dispatches of this driver have ended when the call that issues them returns. So it is with Mesa's llvmpipe:
/// llvmpipe_launch_grid() waits for its own threads.
bool dispatchesEndAtOnce();

/// While it exists, this thread's barriers and fences are left out: its context only computes, with a driver of
/// dispatchesEndAtOnce(). There they order nothing, and llvmpipe's wait until the pictures of all contexts that share
/// objects with it are drawn (lp_setup_flush() takes the rasterizer's lock).
class InOrderThread {
  public:
    InOrderThread();
    ~InOrderThread();
    InOrderThread(const InOrderThread&) = delete;
    InOrderThread& operator=(const InOrderThread&) = delete;
};

/// glMemoryBarrier() where this thread needs it.
void memoryBarrier(GLbitfield barriers);

/// A fence after the commands issued so far; null where this thread needs none, as they have ended.
GLsync fence();

/// Storage flags beside its own for a buffer that an InOrderThread reaches: none but with a driver of
/// dispatchesEndAtOnce().
GLbitfield directStorage();

/// Maps a buffer with directStorage() for good; nothing where that is none.
void mapDirectly(GLuint buffer, size_t bytes);

/// A buffer's own memory on an InOrderThread, null elsewhere; it stays where it is as long as the buffer, and any
/// thread may read it between two works of that one. There, all that writes, reads, copies or clears buffers, and what
/// dispatches by their numbers, goes there and not through the driver: llvmpipe would look whether a picture still
/// needs the buffer (llvmpipe_flush_resource()), in lists that a thread which draws with a context that shares objects
/// changes meanwhile.
std::byte* directMemory(GLuint buffer);

/// Copies bytes between buffers.
void copyBytes(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset);

/// Sets words of a buffer; `offset` and `bytes` are of whole words.
void fillWords(GLuint buffer, size_t offset, size_t bytes, GLuint word);

/// glDispatchComputeIndirect().
void dispatchIndirect(size_t offset);

} // namespace meltpool::gl
