// The order in which a driver sees what shaders write: barriers and fences, and threads that need none.
#pragma once

#include "core/gl/gl.hpp"

namespace meltpool::gl {

/// Whether dispatches of this driver have ended when the call that issues them returns. So it is with Mesa's llvmpipe:
/// llvmpipe_launch_grid() waits for its own threads.
bool dispatchesEndAtOnce();

/// While it exists, this thread's barriers and fences are left out: its context only computes, with a driver of
/// dispatchesEndAtOnce(). Not for the sake of their own cost: llvmpipe's barriers and fences wait until the pictures of
/// all contexts are drawn (lp_setup_flush() takes the rasterizer's lock), so that steps would wait for a picture.
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

} // namespace meltpool::gl
